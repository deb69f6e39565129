#pragma once

#include <string>

#include "tests/scenario/operator_script.h"

namespace eod::lockstep {

/// Opens each hand by so much [m], and a little more.
inline std::string Open(double metres) {
  return fmt::format("hold M17 until joint 7 >= {} within 4s\n", metres);
}

/// Moves joint `joint` to `target` [deg] with motion `motion`, the last degrees slowly.
inline std::string MoveJoint(int joint, double target, std::string_view motion, bool down) {
  const double sign = down ? 1 : -1;
  return fmt::format(
      "rate 100%\nhold {0} until joint {1} {2} {3} within 30s\nrate 10%\n"
      "hold {0} until joint {1} {2} {4} within 30s\nrate 100%\nwait 300ms\n",
      motion, joint, down ? "<=" : ">=", target + sign * 4, target + sign * 0.05);
}

/// At (x, 2), heading 0, x in whole lanes: along the cross lane of the module "bomb".
inline std::string ToChargeLane(double x) {
  const std::string there = x > 0 ? TurnTo(270, false) + DriveAhead(x) + TurnTo(359.75, true)
                                  : TurnTo(90, true) + DriveAhead(-x) + TurnTo(0.25, false);
  return PowerUp("bomb") + DriveAhead(2) + there;
}

/// At charge M, the gripper round it and open; `last_m` is the last, creeping bit of the way.
inline std::string AroundChargeM(double last_m = 0.238) {
  return PowerUp("bomb") +
         "speed low\nhold preset ground_pick until joint 4 >= 108.6 within 20s\n" + Open(0.08) +
         "hold M01 until travel >= 4.5 within 30s\nwait 500ms\nspeed creep\n" +
         fmt::format("hold M01 until travel >= {} within 30s\nwait 1s\n", last_m);
}

inline std::string GraspChargeM() {
  return AroundChargeM() + "hold M18 until grasp grasped within 6s\nwait 500ms\n";
}

/// And lifted by 20 degrees of the big arm.
inline std::string TakeChargeM() { return GraspChargeM() + "hold M09 for 2s\nwait 500ms\n"; }

/// At (-4, 2): the hand level, its middle 1.15 m ahead and 0.87 m high.
inline std::string HandAtTheTable() {
  return ToChargeLane(-4) + MoveJoint(3, 54.3, "M10", true) + MoveJoint(4, 99.3, "M11", false) +
         MoveJoint(5, 26.4, "M14", true);
}

}  // namespace eod::lockstep
