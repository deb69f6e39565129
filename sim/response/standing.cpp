#include "sim/response/standing.h"

namespace eod::sim {
namespace {

constexpr double kGravity = 9.80665;  // [m/s^2]

}  // namespace

RobotState StandOn(const GroundFix& ground, const RobotState& state, double dt_s) {
  RobotState next = state;
  if (ground.legs == 0) {
    next.fall_speed += kGravity * dt_s;
    next.position.z() -= next.fall_speed * dt_s;
    return next;
  }
  next.fall_speed = 0;
  if (ground.legs == 3) {
    next.position.z() = ground.height;
    next.attitude = AttitudeOnPlane(ground.normal, state.attitude.heading);
  } else {
    next.position.z() += ground.mean_offset;
  }
  return next;
}

}  // namespace eod::sim
