#pragma once

#include <memory>
#include <string>
#include <vector>

#include "sim/segments/movable_shapes.h"
#include "sim/segments/triangle_engine.h"
#include "sim/world/world_model.h"

namespace eod::sim {

/// The world that a robot drives in: triangles that stand still, and exact shapes that move, the
/// module's movables among them.
///
/// Casting is thread-safe; whatever changes the world must not run while another thread casts.
/// Readers notice a change by themselves.
class BuiltWorld final : public World {
 public:
  /// Throws std::invalid_argument, see BuildBlockTree and KernelsFor.
  explicit BuiltWorld(const ModuleModel& module,
                      InstructionSet instruction_set = BestInstructionSet());

  void Cast(std::span<const SegmentQuery> queries, std::span<SegmentHit> hits,
            CastMemory& memory) const override;
  std::optional<double> LevelGroundIn(const Eigen::AlignedBox3d& box, uint32_t class_mask,
                                      CastMemory& memory) const override;
  const std::string& ObjectName(int object) const override;

  /// Numbers of the module's movable objects: they follow its static ones.
  int ObjectOfMovable(int movable) const { return first_movable_ + movable; }
  /// -1 if `object` is none.
  int MovableOfObject(int object) const;

  /// A new object of one shape, at X_MO; returns its number, never used before.
  int AddShape(std::string name, uint32_t class_mask, Shape shape, const Eigen::Isometry3d& X_MO);
  /// All shapes of an object, at once and without rebuilding anything. False if it has none.
  bool Move(int object, const Eigen::Isometry3d& X_MO);
  /// Nothing meets the object until it is moved again. False if it has no shapes.
  bool Hide(int object);
  /// The object meets nothing from now on; its name stays. False if it has no shapes.
  bool Remove(int object);
  /// Other triangles that stand still, such as those of a wall that is no more. Builds the tree
  /// anew: a quarter of a second for a million. Throws std::invalid_argument, and is as before
  /// then.
  void Rebuild(std::span<const CollisionTriangle> triangles);

 private:
  TriangleEngine triangles_;
  MovableShapes shapes_;
  std::vector<std::string> names_;
  int first_movable_ = 0;
  int movables_ = 0;
};

}  // namespace eod::sim
