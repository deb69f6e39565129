#pragma once

#include <span>
#include <vector>

#include <Eigen/Geometry>

#include "sim/world/world_model.h"

namespace eod::sim {

/// A charge is an exact cylinder along Z of its object's frame O, centred there (Eq. 8).
///
/// Whether the point lies on its surface, mantle or end cap, to `tolerance` [m] (Eq. 8, in the
/// charge's own frame: a tilted one is not vertical).
bool IsOnCharge(const ExplosiveSpec& charge, const Eigen::Isometry3d& X_MO,
                const Eigen::Vector3d& p_M, double tolerance);

/// z of its lowest point [m], in the frame of X_MO.
double LowestPoint(const ExplosiveSpec& charge, const Eigen::Isometry3d& X_MO);

/// Indices in `module.movables` of those that are charges, in that order.
std::vector<int> ChargesOf(const ModuleModel& module);

/// What a line of the world met: index of the movable that is this object; -1 if it is none.
/// `movable_of_object` is indexed by the world's numbers of objects, and may be shorter.
int MovableOf(std::span<const int> movable_of_object, int object);

/// Whether a point of the vessel's frame is within its walls, at whatever height.
bool IsWithinWalls(const VesselSpec& vessel, const Eigen::Vector3d& p_V);

/// Whether a charge with its middle and lowest point there is safe in the vessel: within its walls,
/// below its rim, above its net. All in the module's frame.
bool IsInside(const VesselSpec& vessel, const Eigen::Vector3d& p_M, double lowest_z,
              double net_sag);

}  // namespace eod::sim
