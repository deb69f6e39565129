#pragma once

#include <string>
#include <vector>

#include <Eigen/Geometry>

#include "sim/segments/movable_shapes.h"
#include "sim/world/world.h"

namespace eod::sim {

/// World of exact shapes and infinite planes. For tests that derive their numbers, and as the
/// second form behind the seam.
class AnalyticWorld final : public World {
 public:
  /// Half-space below the plane through `point` with the unit normal `n_M`. Each of these returns
  /// the number of the object, from 0 up.
  int AddPlane(std::string name, uint32_t class_mask, const Eigen::Vector3d& point,
               const Eigen::Vector3d& n_M);
  /// Box of whole lengths `size`, centred on X_MB.
  int AddBox(std::string name, uint32_t class_mask, const Eigen::Isometry3d& X_MB,
             const Eigen::Vector3d& size);
  int AddShape(std::string name, uint32_t class_mask, const Eigen::Isometry3d& X_MO, Shape shape);
  /// Moves a box or shape; false if `object` is none. Not while others cast.
  bool Move(int object, const Eigen::Isometry3d& X_MO);

  void Cast(std::span<const SegmentQuery> queries, std::span<SegmentHit> hits,
            CastMemory& memory) const override;
  const std::string& ObjectName(int object) const override;

 private:
  struct Plane {
    int object;
    uint32_t class_mask;
    Eigen::Vector3d point, normal;
  };
  int NewObject(std::string name);
  void MeetPlanes(size_t index, const SegmentQuery& query, SegmentHit& best,
                  CastMemory& memory) const;

  std::vector<std::string> names_;
  std::vector<Plane> planes_;
  MovableShapes shapes_;
};

}  // namespace eod::sim
