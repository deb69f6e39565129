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

/// A side as computed, and how far that can be from the truth.
struct Side {
  double value, error;
  bool sure() const { return std::abs(value) > error; }
};

struct Weights {
  double a, b, c;
  bool mixed() const { return (a < 0 || b < 0 || c < 0) && (a > 0 || b > 0 || c > 0); }
  double sum() const { return a + b + c; }
};

double MaxAbs(const Vector3d& v) {
  return std::max({std::abs(v.x()), std::abs(v.y()), std::abs(v.z())});
}

Weights ExactWeights(const SegmentQuery& segment, const Vector3d& a, const Vector3d& b,
                     const Vector3d& c) {
  const Vector3d &d = segment.direction, &s = segment.start;
  return {ExactSide(d, s, b, c), ExactSide(d, s, c, a), ExactSide(d, s, a, b)};
}

}  // namespace

double ExactSide(const Vector3d& d, const Vector3d& s, const Vector3d& b, const Vector3d& c) {
  const std::array<Difference, 3> B = {Difference(b.x(), s.x()), Difference(b.y(), s.y()),
                                       Difference(b.z(), s.z())};
  const std::array<Difference, 3> C = {Difference(c.x(), s.x()), Difference(c.y(), s.y()),
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
    add(component, B[j], C[k]);
    add(-component, B[k], C[j]);
  }
  return sum.Sum();
}

std::optional<double> Meet(const SegmentQuery& segment, const Vector3d& a, const Vector3d& b,
                           const Vector3d& c) {
  const Vector3d& d = segment.direction;
  const Vector3d A = a - segment.start, B = b - segment.start, C = c - segment.start;
  const double size_a = MaxAbs(A), size_b = MaxAbs(B), size_c = MaxAbs(C);
  const Side sides[3] = {{d.dot(B.cross(C)), kSideError * size_b * size_c},
                         {d.dot(C.cross(A)), kSideError * size_c * size_a},
                         {d.dot(A.cross(B)), kSideError * size_a * size_b}};
  bool sure_positive = false, sure_negative = false, all_sure = true;
  for (const Side& side : sides) {
    sure_positive |= side.value > side.error;
    sure_negative |= side.value < -side.error;
    all_sure &= side.sure();
  }
  if (sure_positive && (sure_negative || segment.face_rule == FaceRule::kFrontOnly)) {
    return std::nullopt;
  }
  Weights weights = all_sure ? Weights{sides[0].value, sides[1].value, sides[2].value}
                             : ExactWeights(segment, a, b, c);
  // Positive sides: the line leaves through the back.
  const auto passes = [&] {
    return weights.mixed() || weights.sum() == 0 ||
           (segment.face_rule == FaceRule::kFrontOnly && weights.sum() > 0);
  };
  if (passes()) return std::nullopt;

  const double at_a = A.dot(d), to_b = (b - a).dot(d), to_c = (c - a).dot(d);
  const auto range_of = [&] {
    return at_a + (weights.b * to_b + weights.c * to_c) / weights.sum();
  };
  double range = range_of();
  if (all_sure) {
    const double size = std::max({size_a, size_b, size_c});
    const double edge = std::max(std::abs(to_b), std::abs(to_c));
    const double error = 3 * kSideError * size * size * edge / std::abs(weights.sum());
    const double to_end = std::min(std::abs(range), std::abs(range - segment.length));
    if (error > kRangeError || (error > kEndError && to_end < error + 2 * kEndTolerance)) {
      weights = ExactWeights(segment, a, b, c);
      range = range_of();
    }
  }
  if (!(range >= -kEndTolerance && range <= segment.length + kEndTolerance)) return std::nullopt;
  return std::clamp(range, 0.0, segment.length);
}

}  // namespace eod::sim
