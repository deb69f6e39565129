#pragma once

#include <optional>
#include <span>

#include <Eigen/Geometry>

#include "sim/bodies/rigid_bodies.h"
#include "sim/rules/disposal_rules.h"
#include "sim/segments/cast_memory.h"
#include "sim/world/world.h"
#include "sim/world/world_model.h"

namespace eod::sim {

/// Where a shot went.
struct Shot {
  int body = -1;                                        ///< charge that it hit
  bool disrupted = false;                               ///< it is safe now; otherwise it goes off
  Eigen::Vector3d p_M = Eigen::Vector3d::Zero();        ///< where it hit
  Eigen::Vector3d impulse_M = Eigen::Vector3d::Zero();  ///< [N s]
};

/// The muzzle's pose: shoots along +Y.
Eigen::Isometry3d BarrelPose(const Eigen::Isometry3d& X_MWrist, const DisrupterRules& rules);

/// What a shot from X_MB does. It disrupts a charge that it meets within `min_range` ..
/// `max_range`, no farther than `aim_offset` past its middle and no more than `aim_angle` off its
/// surface's normal; any other hit of a charge sets it off. Nothing if it meets something else
/// first, or nothing within `reach`. No allocation once `memory` has grown.
std::optional<Shot> ShotFrom(const Eigen::Isometry3d& X_MB, const World& world,
                             const ModuleModel& module, std::span<const BodyState> bodies,
                             std::span<const int> movable_of_object, const DisrupterRules& rules,
                             CastMemory& memory);

}  // namespace eod::sim
