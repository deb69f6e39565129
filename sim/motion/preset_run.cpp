#include "sim/motion/preset_run.h"

#include <algorithm>
#include <cmath>

namespace eod::sim {
namespace {

constexpr double kThere = 1e-9;  // [rad] or [m]

}  // namespace

MotionDemand PresetRun::Demand(int index, const RobotState& state, double dt_s) {
  if (index != index_) stopped_ = false;
  index_ = index;
  moving_ = 0;
  MotionDemand demand;
  if (stopped_) return demand;
  const auto preset = std::find_if(robot_.presets.begin(), robot_.presets.end(),
                                   [&](const PresetSpec& spec) { return spec.index == index; });
  if (preset == robot_.presets.end()) return demand;

  double longest = 0;  // [s] of the joint that has the longest way
  for (int j = 0; j < kJointCount; ++j) {
    if (!preset->joint[j]) continue;
    longest =
        std::max(longest, std::abs(*preset->joint[j] - state.joint[j]) / robot_.joints[j].rate);
  }
  for (int j = 0; j < kJointCount; ++j) {
    if (!preset->joint[j]) continue;
    const JointSpec& joint = robot_.joints[j];
    const double way = *preset->joint[j] - state.joint[j];
    if (std::abs(way) < kThere) continue;
    const double share = std::abs(way) / joint.rate / longest;
    const int motion = way > 0 ? joint.positive_motion : joint.negative_motion;
    demand.rate[motion] = std::min(share, RateOf(j, std::abs(way), dt_s));
    demand.commanded |= SetOf(motion);
  }
  moving_ = demand.commanded;
  return demand;
}

/// As fast as can still be slowed down over the `way` that is left; the last step ends exactly
/// there.
double PresetRun::RateOf(int joint, double way, double dt_s) const {
  const JointSpec& spec = robot_.joints[joint];
  const double last_step = way / dt_s;
  // Half the acceleration leaves room for the steps in which the drives follow.
  const double slowing = std::sqrt(spec.acceleration * way);
  return std::min({1.0, last_step / spec.rate, slowing / spec.rate});
}

}  // namespace eod::sim
