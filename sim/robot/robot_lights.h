#pragma once

#include <cstdint>
#include <string>

#include <Eigen/Geometry>

#include "sim/geometry/light_source.h"

namespace eod::sim {

/// What the operator has turned on.
struct RobotLights {
  bool drive = false;     ///< headlights
  bool gripper = false;   ///< the work light at the wrist
  bool infrared = false;  ///< illuminators; all cameras then show infrared pictures
  bool operator==(const RobotLights&) const = default;
};

/// A spot light on a link: shines along +Y of its frame S.
struct SpotLightSpec {
  enum class Switch : uint8_t { kDrive, kGripper, kInfrared };
  std::string name;
  int link = 0;
  Switch on_by = Switch::kDrive;  ///< which of RobotLights turns it on
  Eigen::Isometry3d X_LS = Eigen::Isometry3d::Identity();
  LampLight light;
  double inner_angle = 0;  ///< [rad] from the axis to where it begins to fade ...
  double outer_angle = 0;  ///< [rad] ... and to where it is dark

  bool IsOn(const RobotLights& lights) const {
    return on_by == Switch::kDrive     ? lights.drive
           : on_by == Switch::kGripper ? lights.gripper
                                       : lights.infrared;
  }
};

}  // namespace eod::sim
