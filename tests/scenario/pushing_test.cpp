// Loose things in the robot's way.
#include <gtest/gtest.h>

#include "tests/scenario/charge_script.h"

namespace eod::lockstep {
namespace {

using namespace std::chrono_literals;

struct Obstacle {
  std::string name;
  double x, y;    ///< [m] of its middle
  double half;    ///< [m] from its middle to the face that looks at the robot
  double height;  ///< [m] of its frame above the ground
};
class PushedThing : public ::testing::TestWithParam<Obstacle> {};

TEST_P(PushedThing, StopsTheRobotWhichCreepsOnWithItWhenTheOperatorInsists) {
  const auto& [name, x, y, half, height] = GetParam();
  // [m] of the tracks, where the line of sight begins, and of the hull between them, which pushes.
  constexpr double kFront = 0.475, kHull = 0.45, kD0 = 0.05;
  Mission dut = RunMission(ToChargeLane(x) + DriveAhead(y - half - kFront - 0.2 - 2) +
                               "speed low\npress M01\nwait alarm 16 within 5s\n"
                               "expect reason collision\nexpect inhibit M01\n"
                               "wait alarm 17 within 2s\nwait 4s\nrelease all\nwait 4s\n",
                           "bomb_ground_m");
  const sim::Simulator& simulator = dut.rig().simulator();
  const auto& movables = ShippedData().world.Module(3).movables;
  const auto thing = static_cast<size_t>(
      std::find_if(movables.begin(), movables.end(),
                   [&name = name](const auto& movable) { return movable.name == name; }) -
      movables.begin());
  ASSERT_LT(thing, movables.size());
  double y_at_alarm = 0, fastest_after = 0;
  bool bomb_alarm = false;
  dut.rig().SetStepSink([&](const sim::StepResult& step, const sim::AlarmTable& alarms) {
    if (y_at_alarm == 0 && alarms.IsActive(sim::AlarmCode::kCollision)) {
      y_at_alarm = step.state.position.y();
    } else if (y_at_alarm > 0) {
      fastest_after = std::max(fastest_after, step.speed);
    }
    bomb_alarm = bomb_alarm || step.disposal.touched;
  });
  PlayScript(dut, 200s);
  EXPECT_NEAR(y - half - y_at_alarm - kFront, kD0, 0.005);
  EXPECT_DOUBLE_EQ(fastest_after, ShippedData().robot.drive_speed[0]);
  EXPECT_FALSE(bomb_alarm);
  // Four seconds at creep, less the gap before it: pushed skin on skin, upright, and at rest now.
  const sim::BodyState& body = simulator.bodies()[thing];
  const double front = simulator.last().state.position.y() + kHull;
  EXPECT_GT(front, y - half + 0.25);
  EXPECT_NEAR(body.X_MO.translation().y(), front + half, 0.005);
  EXPECT_NEAR(body.X_MO.translation().x(), x, 0.05);
  EXPECT_NEAR(body.X_MO.translation().z(), height, 0.005);
  EXPECT_FALSE(body.is_moving);
}

// The cone's body above its foot, which goes between the tracks: 0.11 m in radius.
INSTANTIATE_TEST_SUITE_P(Things, PushedThing,
                         ::testing::Values(Obstacle{"carton_1", 16, 6, 0.20, 0.175},
                                           Obstacle{"loose_cone_1", 20, 5, 0.11, 0.0}),
                         [](const auto& thing) { return thing.param.name; });

}  // namespace
}  // namespace eod::lockstep
