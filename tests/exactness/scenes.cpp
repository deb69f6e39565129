#include "tests/exactness/scenes.h"

#include <cmath>
#include <limits>

#include "sim/geometry/pose.h"

namespace eod::sim {
namespace {

using Eigen::Vector3d;

constexpr uint32_t kClasses[4] = {kModuleFlat | kBumpProxy, kModuleFlat | kClampProxy,
                                  kModuleFlat | kBumpProxy | kClampProxy,
                                  kModuleSlope | kBumpProxy};

/// On a grid of 1/64 m, so that sums and differences are exact.
Vector3d Snapped(const Vector3d& v) { return (v * 64).array().round() / 64; }

Mesh Ground(SeededNumbers& numbers, bool relief) {
  Mesh mesh = PlaneMesh(4, 4, 1);
  if (!relief) return mesh;
  for (Triangle& triangle : mesh) {
    for (Vector3d& corner : triangle) {
      corner.z() = 0.3 * std::sin(1.7 * corner.x()) * std::cos(1.3 * corner.y());
    }
  }
  (void)numbers;
  return mesh;
}

Mesh Loose(SeededNumbers& numbers, double size, double thickness) {
  Mesh mesh;
  for (int i = 0; i < 24; ++i) {
    const Vector3d corner = numbers.InBox(2), along = numbers.InBox(size);
    mesh.push_back({corner, corner + along,
                    corner + numbers.Between(0, 1) * along + thickness * numbers.InBox(1)});
  }
  return mesh;
}

Mesh Body(SeededNumbers& numbers) {
  const double size = numbers.Between(0.2, 1.5);
  switch (numbers.Below(3)) {
    case 0:
      return BoxMesh({size, numbers.Between(0.1, 1), numbers.Between(0.1, 1)});
    case 1:
      return CylinderMesh(size / 2, 1, 9);
    default:
      return SphereMesh(size / 2, 4, 7);
  }
}

Mesh Kind(SeededNumbers& numbers, size_t kind) {
  switch (kind) {
    case 0:
      return Loose(numbers, 1, 0.5);
    case 1:
      return Loose(numbers, 1, 1e-4);  // splinters
    case 2:
      return Ground(numbers, true);
    case 3: {
      Mesh mesh = PlaneMesh(3000, 3000, 3000);  // huge ones among small ones
      for (const Triangle& small : Loose(numbers, 0.05, 0.05)) mesh.push_back(small);
      return mesh;
    }
    default: {
      const Eigen::Quaterniond turn(numbers.Between(-1, 1), numbers.Between(-1, 1),
                                    numbers.Between(-1, 1), numbers.Between(0.1, 1));
      Eigen::Isometry3d pose(turn.normalized());
      pose.translation() = numbers.InBox(1);
      return Transformed(pose, Body(numbers));
    }
  }
}

void Add(Mesh mesh, const Vector3d& shift, bool snap, uint32_t class_mask,
         std::vector<CollisionTriangle>& scene) {
  const int object = scene.empty() ? 0 : scene.back().object + 1;
  for (Triangle& corner : mesh) {
    for (Vector3d& point : corner) point = snap ? Snapped(point) + shift : Vector3d(point + shift);
    scene.push_back({corner, class_mask, object});
  }
}

class SegmentMaker {
 public:
  SegmentMaker(const std::vector<CollisionTriangle>& scene, uint64_t seed)
      : scene_(scene), numbers_(seed) {}

  SegmentQuery Make(size_t kind);

 private:
  const Triangle& AnyTriangle() { return scene_[numbers_.Below(scene_.size())].corner; }
  Vector3d PointOf(const Triangle& corner, double spread = 1) {
    double u = numbers_.Between(0, spread), v = numbers_.Between(0, spread);
    if (u + v > 1 && spread <= 1) u = 1 - u, v = 1 - v;
    return corner[0] + u * (corner[1] - corner[0]) + v * (corner[2] - corner[0]);
  }
  Vector3d AnyDirection() {
    if (numbers_.Below(4) != 0) return numbers_.InBox(1).normalized();
    const Vector3d axis = Vector3d::Unit(static_cast<int>(numbers_.Below(3)));
    return numbers_.Below(2) == 0 ? axis : Vector3d(-axis);
  }
  double AnyLength() {
    const size_t kind = numbers_.Below(8);
    return kind == 0 ? numbers_.Between(4, 200) : kind == 1 ? 0.25 : numbers_.Between(0.01, 2);
  }
  /// Aimed at `target` from `share` of its length before it.
  void Aim(SegmentQuery& query, const Vector3d& target, double share) {
    query.start = target - share * query.length * query.direction;
  }
  void Rules(SegmentQuery& query);
  void Spoil(SegmentQuery& query);

  const std::vector<CollisionTriangle>& scene_;
  SeededNumbers numbers_;
};

void SegmentMaker::Rules(SegmentQuery& query) {
  constexpr HitRule kHitRules[4] = {HitRule::kNearest, HitRule::kNearest, HitRule::kHighest,
                                    HitRule::kAll};
  query.hit_rule = kHitRules[numbers_.Below(4)];
  query.face_rule = numbers_.Below(4) == 0 ? FaceRule::kFrontOnly : FaceRule::kTwoSided;
  constexpr uint32_t kMasks[4] = {kModuleFlat | kBumpProxy, kBumpProxy, kAnyModule,
                                  kModuleFlat | kClampProxy};
  query.class_mask = kMasks[numbers_.Below(4)];
}

/// Makes it something that is no segment.
void SegmentMaker::Spoil(SegmentQuery& query) {
  constexpr double kBad[3] = {std::numeric_limits<double>::quiet_NaN(),
                              std::numeric_limits<double>::infinity(),
                              -std::numeric_limits<double>::infinity()};
  const double bad = kBad[numbers_.Below(3)];
  const auto axis = static_cast<Eigen::Index>(numbers_.Below(3));
  switch (numbers_.Below(5)) {
    case 0:
      query.start[axis] = bad;
      break;
    case 1:
      query.direction[axis] = bad;
      break;
    case 2:
      query.length = bad;
      break;
    case 3:
      query.length = -1 - query.length;
      break;
    default:
      query.direction *= numbers_.Below(2) == 0 ? 0 : 1.001;
      break;
  }
}

SegmentQuery SegmentMaker::Make(size_t kind) {
  SegmentQuery query;
  Rules(query);
  query.direction = AnyDirection();
  query.length = AnyLength();
  const Triangle& corner = AnyTriangle();
  const Vector3d point = PointOf(corner), edge = corner[1] - corner[0];
  switch (kind) {
    case 0:  // somewhere near
      Aim(query, PointOf(corner, 2) + numbers_.InBox(0.2), numbers_.Between(0, 1));
      break;
    case 1:  // through a corner
      Aim(query, corner[numbers_.Below(3)], numbers_.Between(0, 1));
      break;
    case 2:  // through an edge, at its middle or anywhere
      Aim(query, corner[0] + (numbers_.Below(2) == 0 ? 0.5 : numbers_.Between(0, 1)) * edge,
          numbers_.Below(2) == 0 ? 0.5 : numbers_.Between(0, 1));
      break;
    case 3:  // along an edge
      query.direction = edge.normalized();
      query.start = corner[0] - numbers_.Between(-0.5, 1) * edge;
      break;
    case 4:  // in the plane
      query.direction = (PointOf(corner) - PointOf(corner)).normalized();
      Aim(query, point, numbers_.Between(0, 1));
      break;
    case 5:  // from a face
      query.start = point;
      break;
    case 6:  // to a face
      Aim(query, point, 1);
      break;
    case 7:  // of no length, on a face or beside it
      query.length = 0;
      query.start = numbers_.Below(2) == 0 ? point : Vector3d(corner[0] + numbers_.InBox(0.1));
      break;
    case 8:  // from inside, if the triangle is part of a body
      query.start = point - 0.1 * edge.cross(corner[2] - corner[0]).normalized();
      break;
    default:  // straight up or down, as TRIPOD and HAT look
      query.direction = numbers_.Below(2) == 0 ? Vector3d::UnitZ() : Vector3d(-Vector3d::UnitZ());
      Aim(query, numbers_.Below(2) == 0 ? point : corner[0], numbers_.Between(0, 1));
      break;
  }
  if (!query.direction.allFinite()) query.direction = Vector3d::UnitX();
  if (numbers_.Below(50) == 0) Spoil(query);
  return query;
}

}  // namespace

std::vector<CollisionTriangle> TrickyScene(uint64_t seed) {
  SeededNumbers numbers(seed);
  const Vector3d far(1100 + numbers.Between(0, 1), -1020, 3.7);
  const bool snap = numbers.Below(3) == 0;
  const Vector3d shift = numbers.Below(2) == 0 ? Vector3d(Vector3d::Zero())
                         : snap                ? Snapped(far)
                                               : far;
  std::vector<CollisionTriangle> scene;
  const size_t parts = 1 + numbers.Below(3);
  for (size_t i = 0; i < parts; ++i) {
    Mesh mesh =
        snap && numbers.Below(2) == 0 ? BoxMesh({1, 0.5, 0.25}) : Kind(numbers, numbers.Below(6));
    Add(std::move(mesh), shift, snap, kClasses[numbers.Below(4)], scene);
  }
  return scene;
}

std::vector<SegmentQuery> TrickySegments(const std::vector<CollisionTriangle>& scene, size_t count,
                                         uint64_t seed) {
  constexpr size_t kKinds = 10;
  SegmentMaker maker(scene, seed);
  std::vector<SegmentQuery> queries;
  for (size_t i = 0; i < count; ++i) {
    queries.push_back(maker.Make(i % kKinds));
    queries.back().group = static_cast<uint32_t>(i / 6);
    // Neighbours of one group share a mask, as the lines of an isector do.
    if (i % 6 != 0 && i % 7 != 0) queries.back().class_mask = queries[i - 1].class_mask;
  }
  return queries;
}

}  // namespace eod::sim
