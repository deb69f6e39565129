#include "sim/stance/standing.h"

#include "sim/geometry/gravity.h"

namespace eod::sim {

RobotState StandOn(const GroundFix& ground, const RobotState& state, double dt_s) {
  const Footing last{.z = state.position.z(), .attitude = state.attitude};
  const Footing footing = NextFooting(ground, last, state.attitude.heading);
  RobotState next = state;
  if (footing.falling) {
    next.fall_speed += kGravity * dt_s;
    next.position.z() -= next.fall_speed * dt_s;
    return next;
  }
  next.fall_speed = 0;
  next.position.z() = footing.z;
  next.attitude = footing.attitude;
  return next;
}

}  // namespace eod::sim
