#include "sim/world/mesh_world.h"

namespace eod::sim {

namespace {

const std::string kNoName;

}  // namespace

MeshWorld::MeshWorld(const ModuleModel& module, InstructionSet instruction_set)
    : triangles_(module.triangles, instruction_set) {
  for (const WorldObject& object : module.objects) names_.push_back(object.name);
}

void MeshWorld::Cast(std::span<const SegmentQuery> queries, std::span<SegmentHit> hits,
                     CastMemory& memory) const {
  triangles_.Cast(queries, hits, memory);
}

const std::string& MeshWorld::ObjectName(int object) const {
  const auto index = static_cast<size_t>(object);
  return object < 0 || index >= names_.size() ? kNoName : names_[index];
}

std::unique_ptr<World> BuildWorld(const ModuleModel& module, InstructionSet instruction_set) {
  return std::make_unique<MeshWorld>(module, instruction_set);
}

}  // namespace eod::sim
