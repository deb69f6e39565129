#pragma once

#include <Eigen/Geometry>

#include "sim/world/world_model.h"

namespace eod::sim {

/// How a body resists: its principal frame B, at the centre of mass, in the object's frame.
struct MassProperties {
  Eigen::Isometry3d X_OB = Eigen::Isometry3d::Identity();
  Eigen::Vector3d inertia = Eigen::Vector3d::Zero();  ///< [kg m^2] about B's axes
};

/// The mass spread evenly over the parts; the centre of mass is where the object says.
MassProperties MassPropertiesOf(const MovableObject& object);

}  // namespace eod::sim
