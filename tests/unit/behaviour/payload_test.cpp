#include "sim/motion/payload.h"

#include <gtest/gtest.h>

#include "tests/unit/behaviour/fixture.h"

namespace eod::sim {
namespace {

RobotState Stretched(double small_arm_deg) {
  RobotState state = HomeState(TheRobot());
  state.joint[kBigArm] = 0;
  state.joint[kSmallArm] = small_arm_deg * kDegree;
  state.joint[kWrist] = 0;
  return state;
}

double LimitAt(const RobotState& state) {
  std::vector<Eigen::Isometry3d> X_ML;
  LinkPoses(TheRobot(), state, X_ML);
  return Payload(TheRobot()).Limit(X_ML);
}

TEST(Payload, IsThatOfTheRobotFileAtFullStretchAndFolded) {
  EXPECT_DOUBLE_EQ(LimitAt(Stretched(180)), TheRobot().payload.stretched);
  EXPECT_DOUBLE_EQ(LimitAt(HomeState(TheRobot())), TheRobot().payload.folded);
}

TEST(Payload, FallsAsTheReachGrowsSoThatTheMomentIsTheSame) {
  const double full_reach = 0.75 + 0.65 + 0.15;  // big arm, small arm, wrist to crossbeam
  RobotState raised = Stretched(180);
  raised.joint[kBigArm] = 45 * kDegree;
  EXPECT_NEAR(LimitAt(raised) * full_reach * std::cos(45 * kDegree),
              TheRobot().payload.stretched * full_reach, 1e-9);
}

TEST(Payload, ForbidsReachingOutWithTooMuchAndNothingElse) {
  Payload dut(TheRobot());
  RobotState state = Stretched(130);
  state.joint[kBigArm] = 40 * kDegree;  // raising it draws the hand in
  const double load = LimitAt(state) - 1e-6;
  const MotionDemand all = DemandFor({kSmallArmUp, kBigArmUp, kDriveForward, kGripperOpen});
  EXPECT_EQ(dut.Forbidden(state, all, load, 0.004), SetOf(kSmallArmUp));
  EXPECT_EQ(dut.Forbidden(state, DemandFor({kSmallArmDown}), load, 0.004), 0u);
  EXPECT_EQ(dut.Forbidden(state, all, 0.9 * load, 0.004), 0u);
  EXPECT_EQ(dut.Forbidden(state, all, 0, 0.004), 0u);
}

TEST(Payload, WithoutTheElementThereIsNoLimit) {
  RobotModel robot = TheRobot();
  robot.payload = {};
  Payload dut(robot);
  EXPECT_EQ(dut.Forbidden(Stretched(150), DemandFor({kSmallArmUp}), 1000, 0.004), 0u);
}

}  // namespace
}  // namespace eod::sim
