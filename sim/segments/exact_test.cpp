#include "sim/segments/exact_test.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace eod::sim {
namespace {

using Eigen::Vector3d;

/// |error| of a computed side <= kSideError * max|b - s| * max|c - s|, for a unit direction:
/// (7 + 56 eps) eps times the permanent (Shewchuk, 4.4), which is at most 2 sqrt(3) of that
/// product.
constexpr double kSideError = 4e-15;
constexpr double kRangeError = 1e-7;  // [m] accepted without exact weights ...
constexpr double kEndError = 1e-10;  // [m] ... and where an end of the segment may be decided by it

/// A sum of doubles that is never rounded: components in growing order that do not overlap.
class Expansion {
 public:
  void Add(double value) {
    size_t kept = 0;
    for (size_t i = 0; i < size_; ++i) {
      const double sum = value + part_[i];
      const double from_part = sum - value;
      const double error = (value - (sum - from_part)) + (part_[i] - from_part);
      value = sum;
      if (error != 0) part_[kept++] = error;
    }
    if (value != 0) part_[kept++] = value;
    size_ = kept;
  }
  void AddProduct(double a, double b, double c) {
    if (a == 0 || b == 0 || c == 0) return;
    const double ab = a * b, ab_error = std::fma(a, b, -ab);
    const double abc = ab * c, abc_error = std::fma(ab, c, -abc);
    const double rest = ab_error * c;
    Add(std::fma(ab_error, c, -rest));
    Add(rest);
    Add(abc_error);
    Add(abc);
  }
  /// The largest component dominates, so the sum has its sign.
  double Sum() const {
    double sum = 0;
    for (size_t i = 0; i < size_; ++i) sum += part_[i];
    return sum;
  }

 private:
  std::array<double, 100> part_;  // 6 products of 1 x 2 x 2 parts, 4 components each: 96
  size_t size_ = 0;
};

/// The exact difference of two doubles.
struct Difference {
  double high, low;
  Difference(double a, double b) : high(a - b) {
    const double from_b = a - high;
    low = (a - (high + from_b)) + (from_b - b);
  }
};

/// On which sides of the edges a line passes: b c, c a, a b.
struct Sides {
  double a, b, c;
  double sum() const { return a + b + c; }
  double least() const { return std::min(std::min(a, b), c); }
  double largest() const { return std::max(std::max(a, b), c); }
  double smallest() const { return std::min(std::min(std::abs(a), std::abs(b)), std::abs(c)); }
};

double Size(const Vector3d& v) { return std::abs(v.x()) + std::abs(v.y()) + std::abs(v.z()); }

Sides ExactSides(const SegmentQuery& segment, const Vector3d& a, const Vector3d& b,
                 const Vector3d& c) {
  const Vector3d &d = segment.direction, &s = segment.start;
  return {ExactSide(d, s, b, c), ExactSide(d, s, c, a), ExactSide(d, s, a, b)};
}

double Triple(const Vector3d& d, const Vector3d& b, const Vector3d& c) {
  return d.x() * (b.y() * c.z() - b.z() * c.y()) + d.y() * (b.z() * c.x() - b.x() * c.z()) +
         d.z() * (b.x() * c.y() - b.y() * c.x());
}

/// A computed range, and what bounds its error, times the sum of the sides.
struct Range {
  double value, edge;

  Range(const Sides& sides, const Vector3d& d, const Vector3d& to_a, const Vector3d& ab,
        const Vector3d& ac) {
    const double along_b = ab.dot(d), along_c = ac.dot(d);
    value = to_a.dot(d) + (sides.b * along_b + sides.c * along_c) / sides.sum();
    edge = std::max(std::abs(along_b), std::abs(along_c));
  }
};

}  // namespace

double ExactSide(const Vector3d& d, const Vector3d& s, const Vector3d& b, const Vector3d& c) {
  const std::array<Difference, 3> to_b = {Difference(b.x(), s.x()), Difference(b.y(), s.y()),
                                          Difference(b.z(), s.z())};
  const std::array<Difference, 3> to_c = {Difference(c.x(), s.x()), Difference(c.y(), s.y()),
                                          Difference(c.z(), s.z())};
  Expansion sum;
  const auto add = [&](double factor, const Difference& one, const Difference& other) {
    sum.AddProduct(factor, one.low, other.low);
    sum.AddProduct(factor, one.low, other.high);
    sum.AddProduct(factor, one.high, other.low);
    sum.AddProduct(factor, one.high, other.high);
  };
  for (size_t i = 0; i < 3; ++i) {
    const size_t j = (i + 1) % 3, k = (i + 2) % 3;
    const double component = d[static_cast<Eigen::Index>(i)];
    add(component, to_b[j], to_c[k]);
    add(-component, to_b[k], to_c[j]);
  }
  return sum.Sum();
}

std::optional<double> Meet(const SegmentQuery& segment, const Vector3d& a, const Vector3d& b,
                           const Vector3d& c) {
  const Vector3d& d = segment.direction;
  const bool front_only = segment.face_rule == FaceRule::kFrontOnly;
  const Vector3d to_a = a - segment.start, to_b = b - segment.start, to_c = c - segment.start;
  Sides sides = {Triple(d, to_b, to_c), Triple(d, to_c, to_a), Triple(d, to_a, to_b)};
  const double size = std::max(std::max(Size(to_a), Size(to_b)), Size(to_c));
  const double error = kSideError * size * size;
  // Positive sides: the line leaves through the back.
  if (sides.largest() > error && (front_only || sides.least() < -error)) return std::nullopt;

  bool exact = !(sides.smallest() > error);
  if (exact) {
    sides = ExactSides(segment, a, b, c);
    const bool mixed = sides.least() < 0 && sides.largest() > 0;
    if (mixed || sides.sum() == 0 || (front_only && sides.sum() > 0)) return std::nullopt;
  }
  const Vector3d ab = b - a, ac = c - a;
  Range range(sides, d, to_a, ab, ac);
  if (!exact) {
    const double doubt = 3 * error * range.edge, sum = std::abs(sides.sum());
    if (doubt > kEndError * sum) {
      const double to_end = std::min(std::abs(range.value), std::abs(range.value - segment.length));
      if (doubt > std::min(kRangeError, std::max(to_end - 2 * kEndTolerance, kEndError)) * sum) {
        range = Range(ExactSides(segment, a, b, c), d, to_a, ab, ac);
      }
    }
  }
  if (!(range.value >= -kEndTolerance && range.value <= segment.length + kEndTolerance)) {
    return std::nullopt;
  }
  return std::clamp(range.value, 0.0, segment.length);
}

}  // namespace eod::sim
