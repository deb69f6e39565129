#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "sim/segments/shape.h"
#include "tests/unit/sim/random_scene.h"
#include "tests/unit/sim/reference_solid.h"

namespace eod::sim {
namespace {

using Eigen::Vector3d;

constexpr int kSegments = 100000;
constexpr double kPromised = 1e-9;  // [m] error of a crossing
// Lines that pass the surface's edge so closely, and crossings so close to an end, are left to
// rounding: ten times the tolerance of touches and ends.
constexpr double kZone = 10 * kEndTolerance;

struct Solids {
  const char* name;
  Shape shape;
  DistanceFunction distance;
};

std::vector<Vector3d> Pebble() {
  SeededNumbers numbers(11);
  std::vector<Vector3d> points;
  for (int i = 0; i < 14; ++i) points.push_back(numbers.InBox(0.5));
  return points;
}

std::vector<Solids> AllSolids() {
  const Vector3d crate(0.6, 0.25, 0.4);
  return {{"Box", Shape::Box(crate), BoxDistance(crate)},
          {"Cylinder", Shape::Cylinder(0.06, 0.4), CylinderDistance(0.06, 0.4)},
          {"Sphere", Shape::Sphere(0.3), CapsuleDistance(0.3, 0)},
          {"Capsule", Shape::Capsule(0.1, 0.5), CapsuleDistance(0.1, 0.5)},
          {"Hull", Shape::Hull(Pebble()), HullDistance(Pebble())}};
}

/// From anywhere around or inside, in any direction; every fifth along an axis; some start on the
/// surface, some end on it.
SegmentQuery RandomSegment(SeededNumbers& numbers, const DistanceFunction& distance) {
  SegmentQuery query;
  query.start = numbers.InBox(0.7);
  query.direction = (numbers.InBox(0.25) - query.start).normalized();
  if (numbers.Below(5) == 0) query.direction = Vector3d::Unit(static_cast<int>(numbers.Below(3)));
  query.length = numbers.Between(0, 1.5);
  const size_t kind = numbers.Below(8);
  if (kind >= 2) return query;
  const ReferenceChord chord = ReferenceChordOf(distance, query.start, query.direction, 4);
  if (chord.depth <= kZone) return query;
  const auto to_surface = static_cast<double>(kind == 0 ? chord.enter : chord.leave);
  if (numbers.Below(2) == 0 || to_surface <= 0) {
    query.start += to_surface * query.direction;
  } else {
    query.length = to_surface;
  }
  return query;
}

/// What the answers of a shape were worth, over many segments.
struct Verdict {
  int missed = 0, extra = 0, left_to_rounding = 0, crossings = 0, at_ends = 0, wrong_entry = 0;
  double range_error = 0, surface_error = 0, normal_error = 0;
};

/// The direction in which the distance grows fastest, by differences.
Vector3d Outward(const DistanceFunction& distance, const Vector3d& point) {
  constexpr Real kStep = 1e-7L;
  Vector3d gradient;
  for (size_t axis = 0; axis < 3; ++axis) {
    RealPoint a{point.x(), point.y(), point.z()}, b = a;
    a[axis] -= kStep;
    b[axis] += kStep;
    gradient[static_cast<Eigen::Index>(axis)] =
        static_cast<double>((distance(b) - distance(a)) / (2 * kStep));
  }
  return gradient;
}

void Judge(const Solids& solid, const SegmentQuery& query, Verdict& verdict) {
  const ReferenceChord chord = ReferenceChordOf(solid.distance, query.start, query.direction, 4);
  const Crossings found = solid.shape.Cross(query.start, query.direction, query.length);
  if (std::abs(chord.depth) <= kZone) {
    ++verdict.left_to_rounding;
    return;
  }
  size_t next = 0;
  for (const bool entry : {true, false}) {
    if (chord.depth < 0) break;
    const Real range = entry ? chord.enter : chord.leave;
    const Real beyond = std::max(-range, range - query.length);  // the nearer end
    if (beyond > kZone) continue;
    const bool must = beyond < kEndTolerance / 2;  // exact ends included
    if (next == found.count || found.list[next].entry != entry) {
      if (must) ++verdict.missed;
      if (!must) ++verdict.left_to_rounding;
      continue;
    }
    const Crossing& crossing = found.list[next++];
    const Vector3d point = query.start + crossing.range * query.direction;
    if (std::abs(beyond) < kEndTolerance) ++verdict.at_ends;
    ++verdict.crossings;
    const auto off = [](Real value) { return static_cast<double>(std::abs(value)); };
    verdict.range_error = std::max(verdict.range_error, off(crossing.range - range));
    verdict.surface_error =
        std::max(verdict.surface_error, off(solid.distance({point.x(), point.y(), point.z()})));
    // On an edge the gradient is a mean of two faces; there is no one normal to compare with.
    const Vector3d outward = Outward(solid.distance, point);
    if (std::abs(outward.norm() - 1) < 1e-6) {
      verdict.normal_error = std::max(verdict.normal_error, (crossing.normal - outward).norm());
    }
  }
  verdict.extra += static_cast<int>(found.count - next);
}

class EverySolid : public ::testing::TestWithParam<size_t> {};

TEST_P(EverySolid, AgreesWithItsDistanceFunctionOverAHundredThousandSegments) {
  const Solids solid = AllSolids()[GetParam()];
  SeededNumbers numbers(GetParam() + 21);
  Verdict verdict;
  for (int i = 0; i < kSegments; ++i) {
    Judge(solid, RandomSegment(numbers, solid.distance), verdict);
  }
  EXPECT_EQ(verdict.missed, 0);
  EXPECT_EQ(verdict.extra, 0);
  EXPECT_LT(verdict.range_error, kPromised);
  EXPECT_LT(verdict.surface_error, kPromised);
  // Differences over 1e-7 m of a surface no rounder than 0.06 m, and of long doubles.
  EXPECT_LT(verdict.normal_error, 1e-5);
  // The test has met what it is for: crossings, and hundreds of them exactly at an end.
  EXPECT_GT(verdict.crossings, kSegments / 5);
  EXPECT_GT(verdict.at_ends, kSegments / 200);
  EXPECT_LT(verdict.left_to_rounding, kSegments / 1000);
}

INSTANTIATE_TEST_SUITE_P(Solids, EverySolid, ::testing::Range<size_t>(0, 5),
                         [](const auto& one) { return AllSolids()[one.param].name; });

}  // namespace
}  // namespace eod::sim
