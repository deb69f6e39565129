#include "sim/world/built_world.h"

#include <utility>

#include "sim/world/object_name.h"

namespace eod::sim {

BuiltWorld::BuiltWorld(const ModuleModel& module, InstructionSet instruction_set)
    : triangles_(module.triangles, instruction_set),
      first_movable_(static_cast<int>(module.objects.size())),
      movables_(static_cast<int>(module.movables.size())) {
  for (const WorldObject& object : module.objects) names_.push_back(object.name);
  for (const MovableObject& movable : module.movables) {
    const auto object = static_cast<int>(names_.size());
    names_.push_back(movable.name);
    for (const MovablePart& part : movable.parts) {
      shapes_.Add(object, movable.object_class, part.shape, movable.X_MO, part.X_OS);
    }
  }
}

int BuiltWorld::MovableOfObject(int object) const {
  const int movable = object - first_movable_;
  return movable >= 0 && movable < movables_ ? movable : -1;
}

void BuiltWorld::Cast(std::span<const SegmentQuery> queries, std::span<SegmentHit> hits,
                      CastMemory& memory) const {
  triangles_.Cast(queries, hits, memory);
  if (shapes_.size() > 0) shapes_.Cast(queries, hits, memory);
}

std::optional<double> BuiltWorld::LevelGroundIn(const Eigen::AlignedBox3d& box, uint32_t class_mask,
                                                CastMemory& memory) const {
  if (shapes_.IsNear(box, class_mask)) return {};
  return triangles_.LevelGroundIn(box, class_mask, memory);
}

const std::string& BuiltWorld::ObjectName(int object) const { return NameOf(names_, object); }

int BuiltWorld::AddShape(std::string name, uint32_t class_mask, Shape shape,
                         const Eigen::Isometry3d& X_MO) {
  const auto object = static_cast<int>(names_.size());
  names_.push_back(std::move(name));
  shapes_.Add(object, class_mask, std::move(shape), X_MO);
  return object;
}

bool BuiltWorld::Move(int object, const Eigen::Isometry3d& X_MO) {
  return shapes_.Move(object, X_MO);
}

bool BuiltWorld::Hide(int object) { return shapes_.Hide(object); }

bool BuiltWorld::Remove(int object) { return shapes_.Remove(object); }

void BuiltWorld::Rebuild(std::span<const CollisionTriangle> triangles) {
  triangles_.Rebuild(triangles);
}

std::unique_ptr<World> BuildWorld(const ModuleModel& module, InstructionSet instruction_set) {
  return std::make_unique<BuiltWorld>(module, instruction_set);
}

}  // namespace eod::sim
