#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "sim/isectors/isector_set.h"
#include "sim/motion/motion.h"

namespace eod::sim {

/// How one cast segment was judged.
struct SegmentContact {
  double threshold = 0;  ///< [m] D of Eq. 2 in this step
  bool contact = false;  ///< hit and range < threshold
  MotionSet blocks = 0;  ///< commanded motions that would shorten it
};

/// Where the robot may go: direction-aware blocking (3.3 of the design).
struct Response {
  std::vector<SegmentContact> contacts;  ///< one a cast segment, same order
  MotionSet blocked = 0;                 ///< motions to be left out
  uint32_t contact_parts = 0;            ///< parts with a blocking contact, bits of Part
};

/// D = d0 up to V0 = skin/dt, d0 + v dt beyond (Eq. 2); v is the speed of the isector's own origin.
double DistanceThreshold(const SegmentSpec& segment, double speed_mps, double dt_s);

/// Judges the segments that were cast from the current pose against `demand`: a motion is blocked iff
/// a segment in contact would get shorter by it. Each motion is judged alone, then all together.
void Respond(const RobotModel& robot, const RobotState& state,
             std::span<const Eigen::Isometry3d> X_ML, std::span<const CastSegment> segments,
             const MotionDemand& demand, double dt_s, Response& response);

}  // namespace eod::sim
