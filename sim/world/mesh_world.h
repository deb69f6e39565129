#pragma once

#include <string>
#include <vector>

#include "sim/world/triangle_tree.h"
#include "sim/world/world_model.h"

namespace eod::sim {

/// World of triangles that stand still.
class MeshWorld final : public World {
 public:
  explicit MeshWorld(const ModuleModel& module);

  void Cast(std::span<const SegmentQuery> queries, std::span<SegmentHit> hits,
            CastMemory& memory) const override;
  const std::string& ObjectName(int object) const override;

 private:
  SegmentHit Cast(const SegmentQuery& query, uint64_t& candidates) const;

  std::vector<CollisionTriangle> triangles_;
  std::vector<std::string> names_;
  TriangleTree tree_;
};

}  // namespace eod::sim
