#include "tests/exactness/reference.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include <gmpxx.h>

namespace eod::sim {
namespace {

constexpr long double kDoubt = 1e-12L;       // [m]
constexpr long double kSignError = 4e-18L;   // of a triple product with a unit vector
constexpr long double kRangeError = 1e-11L;  // [m] accepted of extended precision

template <typename Number>
using Vector = std::array<Number, 3>;

template <typename Number>
Vector<Number> Minus(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  return {Number(a.x()) - Number(b.x()), Number(a.y()) - Number(b.y()),
          Number(a.z()) - Number(b.z())};
}

template <typename Number>
Number Dot(const Vector<Number>& a, const Vector<Number>& b) {
  return Number(a[0] * b[0] + a[1] * b[1] + a[2] * b[2]);
}

template <typename Number>
Vector<Number> Cross(const Vector<Number>& a, const Vector<Number>& b) {
  return {Number(a[1] * b[2] - a[2] * b[1]), Number(a[2] * b[0] - a[0] * b[2]),
          Number(a[0] * b[1] - a[1] * b[0])};
}

long double Size(const Vector<long double>& a) {
  return std::max({std::abs(a[0]), std::abs(a[1]), std::abs(a[2])});
}

/// What both kinds of numbers compute: on which sides the line passes, and where.
template <typename Number>
struct Passage {
  Vector<Number> to_corner[3];
  Number side[3];
  Number sum;

  Passage(const Triangle& corner, const SegmentQuery& segment) {
    const Vector<Number> d = Minus<Number>(segment.direction, Eigen::Vector3d::Zero());
    for (size_t i = 0; i < 3; ++i) to_corner[i] = Minus<Number>(corner[i], segment.start);
    for (size_t i = 0; i < 3; ++i) {
      side[i] = Dot(d, Cross(to_corner[(i + 1) % 3], to_corner[(i + 2) % 3]));
    }
    sum = side[0] + side[1] + side[2];
  }

  Number Range(const SegmentQuery& segment) const {
    const Vector<Number> d = Minus<Number>(segment.direction, Eigen::Vector3d::Zero());
    const Number weighted = side[0] * Dot(d, to_corner[0]) + side[1] * Dot(d, to_corner[1]) +
                            side[2] * Dot(d, to_corner[2]);
    // The direction is unit only as far as doubles can tell; ranges count in units of it.
    return Number(weighted / sum);
  }
};

std::optional<long double> ByRationals(const Triangle& corner, const SegmentQuery& segment) {
  const Passage<mpq_class> passage(corner, segment);
  const auto sign = [](const mpq_class& number) { return sgn(number); };
  bool positive = false, negative = false;
  for (const mpq_class& side : passage.side) {
    positive |= sign(side) > 0;
    negative |= sign(side) < 0;
  }
  if (positive == negative) return std::nullopt;  // beside it, or edge-on
  if (positive && segment.face_rule == FaceRule::kFrontOnly) return std::nullopt;
  return static_cast<long double>(passage.Range(segment).get_d());
}

std::optional<long double> Meet(const Triangle& corner, const SegmentQuery& segment) {
  const Passage<long double> passage(corner, segment);
  bool positive = false, negative = false, sure = true;
  long double largest = 0, longest = 0;
  for (size_t i = 0; i < 3; ++i) {
    const long double error =
        kSignError * Size(passage.to_corner[(i + 1) % 3]) * Size(passage.to_corner[(i + 2) % 3]);
    positive |= passage.side[i] > error;
    negative |= passage.side[i] < -error;
    sure &= std::abs(passage.side[i]) > error;
    largest = std::max(largest, Size(passage.to_corner[i]));
    longest = std::max(longest, static_cast<long double>((corner[i] - corner[(i + 1) % 3]).norm()));
  }
  if (positive && negative) return std::nullopt;
  const long double error = 3 * kSignError * largest * largest * largest / std::abs(passage.sum);
  if (!sure || !(error < kRangeError)) return ByRationals(corner, segment);
  if (positive && segment.face_rule == FaceRule::kFrontOnly) return std::nullopt;
  return passage.Range(segment);
}

/// Whether a box of the triangle and one of the segment are a micrometre apart.
bool AreFar(const Triangle& corner, const SegmentQuery& segment) {
  const Eigen::Vector3d end = segment.start + segment.length * segment.direction;
  const auto low = corner[0].cwiseMin(corner[1]).cwiseMin(corner[2]).array() - 1e-6;
  const auto high = corner[0].cwiseMax(corner[1]).cwiseMax(corner[2]).array() + 1e-6;
  return (segment.start.cwiseMin(end).array() > high).any() ||
         (segment.start.cwiseMax(end).array() < low).any();
}

}  // namespace

void MeetAll(std::span<const CollisionTriangle> triangles, const SegmentQuery& segment,
             std::vector<ReferenceHit>& hits) {
  hits.clear();
  const long double length = segment.length, tolerance = kEndTolerance;
  for (size_t i = 0; i < triangles.size(); ++i) {
    if (!Accepts(segment.class_mask, triangles[i].class_mask)) continue;
    if (AreFar(triangles[i].corner, segment)) continue;
    const std::optional<long double> range = Meet(triangles[i].corner, segment);
    if (!range || *range < -tolerance - kDoubt || *range > length + tolerance + kDoubt) continue;
    const bool doubtful = *range < -tolerance + kDoubt || *range > length + tolerance - kDoubt;
    hits.push_back({i, std::clamp(*range, 0.0L, length), doubtful});
  }
  std::sort(hits.begin(), hits.end(), [](const ReferenceHit& one, const ReferenceHit& other) {
    return one.range != other.range ? one.range < other.range : one.triangle < other.triangle;
  });
}

}  // namespace eod::sim
