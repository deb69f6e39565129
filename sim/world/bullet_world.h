#pragma once

#include <memory>
#include <string>

#include <Eigen/Geometry>

#include "sim/segments/shape.h"
#include "sim/world/world.h"
#include "sim/world/world_model.h"

namespace eod::sim {

/// How Bullet is asked. The defaults are what answers best.
struct BulletOptions {
  double margin = 0;  ///< [m] round hulls and cylinders; Bullet's own default is 0.04
  bool gjk = false;   ///< kF_UseGjkConvexCastRaytest for convex shapes
};

/// A module as Bullet sees it, in double: the second opinion behind the seam, for tests and
/// benchmarks. docs/bullet.md lists where it differs from what `World` promises:
///
/// - solids answer with their entry alone, never from inside, never at an end of the segment;
///   kAll and kHighest know no exits of solids;
/// - triangles are met up to 1e-4 of their height outside of their edges, never at an end;
/// - a segment of length 0 meets nothing.
///
/// Casts take turns: btCollisionWorld::rayTest keeps its stack in the world and answers wrongly if
/// two run at once. Counters: a candidate is an object whose box the segment meets.
class BulletWorld final : public World {
 public:
  /// Takes the triangles; the model may be dropped. Shapes get the numbers after its objects.
  explicit BulletWorld(const ModuleModel& module, const BulletOptions& options = {});
  ~BulletWorld() override;

  /// Returns the number of the object.
  int AddShape(std::string name, uint32_t class_mask, const Eigen::Isometry3d& X_MO,
               const Shape& shape);
  /// Moves a shape; false if `object` is none.
  bool Move(int object, const Eigen::Isometry3d& X_MO);

  void Cast(std::span<const SegmentQuery> queries, std::span<SegmentHit> hits,
            CastMemory& memory) const override;
  const std::string& ObjectName(int object) const override;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace eod::sim
