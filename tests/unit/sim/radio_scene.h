#pragma once

#include "sim/geometry/mesh.h"
#include "sim/rules/link_rules.h"
#include "sim/world/built_world.h"
#include "tests/unit/sim/random_scene.h"

namespace eod::sim {

inline constexpr LinkRules kLinkRules{.check_period = 0.1,
                                      .base_antenna = 2,
                                      .robot_antenna = 1.2,
                                      .drop_below = 0.2,
                                      .cable_height = 0.25};

/// Level ground of 200 m with walls of 0.2 m by 5 m height, `length` long in x.
inline ModuleModel Ground() {
  ModuleModel module;
  AddObject(module, "ground", kModuleFlat | kClampProxy, PlaneMesh(200, 200, 10));
  return module;
}
inline void AddWallAt(ModuleModel& module, double x, double y, double length) {
  AddObject(module, "wall", kModuleFlat | kBumpProxy, BoxMesh(Eigen::Vector3d(length, 0.2, 5)),
            {x, y, 2.5});
}

inline RobotState StandingAt(double x, double y, double heading = 0) {
  RobotState state;
  state.position = {x, y, 0};
  state.attitude.heading = heading;
  return state;
}

}  // namespace eod::sim
