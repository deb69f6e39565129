#pragma once

#include <array>
#include <vector>

#include <Eigen/Geometry>

namespace eod::bench {

inline constexpr double kSpeed = 0.67;    ///< [m/s] the prototype's top speed, 40 m/min
inline constexpr double kFrameRate = 25;  ///< [Hz] see DrivePath
inline constexpr int kBumps = 10, kLegs = 3;

/// Where the robot's isectors are in one frame. Axes as the house has them: X right, Y forward, Z
/// up; the robot's origin is on the ground, in the middle.
struct RobotPose {
  Eigen::Isometry3d X_MR = Eigen::Isometry3d::Identity();
  double heading = 0;
  std::array<Eigen::Isometry3d, kBumps> X_MB;  ///< four wheels, nose, elbow, mast, beam, two hands
};

/// Once round the loop of the site in 2000 frames: along a wall, through a gate, between kerbs,
/// past clutter, up and down the stairs, through a low corridor, over bumpy ground all the while.
/// The arm swings up and down.
///
/// At 25 Hz, the rate of cameras, a frame moves the robot by 26.8 mm. The simulator steps at 250
/// Hz: it sees the same world in ten times smaller moves, which is easier on whatever is kept from
/// frame to frame.
std::vector<RobotPose> DrivePath(int frames);

}  // namespace eod::bench
