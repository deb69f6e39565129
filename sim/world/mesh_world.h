#pragma once

#include <string>
#include <vector>

#include "sim/segments/triangle_engine.h"
#include "sim/world/world_model.h"

namespace eod::sim {

/// World of triangles that stand still.
class MeshWorld final : public World {
 public:
  MeshWorld(const ModuleModel& module, InstructionSet instruction_set);

  void Cast(std::span<const SegmentQuery> queries, std::span<SegmentHit> hits,
            CastMemory& memory) const override;
  const std::string& ObjectName(int object) const override;

 private:
  TriangleEngine triangles_;
  std::vector<std::string> names_;
};

}  // namespace eod::sim
