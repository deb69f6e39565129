#pragma once

#include "sim/disposal/hand.h"

namespace eod::sim {

/// The lines of a held charge against the rim of a can, the ground, and whatever else is in its
/// way: an isector of the gripper (part kHeldBomb) that begins to see when a charge is grasped.
///
/// They start `probe_inset` below its surface and look outwards: eight all round at the lower end,
/// four at half height, four at the upper end; downwards eight from the lower edge, four half way
/// in, one from the middle; one upwards. "Down" is the end of the axis that points downwards when
/// it is grasped. A rim of 40 mm or more is never missed by a charge of up to 75 mm in radius.

/// Appends the probe, which sees nothing yet, and returns its index in `robot.isectors`. Before
/// any IsectorSet is made of the robot. Without a link "gripper" the chassis carries it.
int AppendHeldProbe(RobotModel& robot);

/// Lays it round a charge at X_GO in the gripper. `down_G`: unit vertical, downwards, in the
/// gripper's frame. No allocation. IsectorSet::Reload then takes it over.
void ShapeHeldProbe(const ExplosiveSpec& charge, const Eigen::Isometry3d& X_GO,
                    const Eigen::Vector3d& down_G, const ChargeRules& rules, IsectorSpec& probe);

/// It sees nothing again.
void FoldHeldProbe(IsectorSpec& probe);

}  // namespace eod::sim
