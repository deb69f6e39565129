#pragma once

#include <string>
#include <vector>

#include <Eigen/Geometry>

#include "sim/world/world.h"

namespace eod::sim {

/// World of exact shapes: infinite planes and boxes. For tests that derive their numbers, and as
/// the second form behind the seam.
class AnalyticWorld final : public World {
 public:
  /// Half-space below the plane through `point` with the unit normal `n_M`.
  void AddPlane(std::string name, uint32_t class_mask, const Eigen::Vector3d& point,
                const Eigen::Vector3d& n_M);
  /// Box of whole lengths `size`, centred on X_MB.
  void AddBox(std::string name, uint32_t class_mask, const Eigen::Isometry3d& X_MB,
              const Eigen::Vector3d& size);

  void Cast(std::span<const SegmentQuery> queries, std::span<SegmentHit> hits,
            CastMemory& memory) const override;
  const std::string& ObjectName(int object) const override;

 private:
  struct Plane {
    int object;
    uint32_t class_mask;
    Eigen::Vector3d point, normal;
  };
  struct Box {
    int object;
    uint32_t class_mask;
    Eigen::Isometry3d X_MB;
    Eigen::Vector3d half;
  };
  static void Meet(const Plane& plane, const SegmentQuery& query, SegmentHit& best);
  static void Meet(const Box& box, const SegmentQuery& query, SegmentHit& best);

  std::vector<std::string> names_;
  std::vector<Plane> planes_;
  std::vector<Box> boxes_;
};

}  // namespace eod::sim
