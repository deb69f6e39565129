#include <cmath>

#include <gtest/gtest.h>

#include "tests/unit/disposal/bench.h"

namespace eod::sim {
namespace {

constexpr double kUnit = 0.15;          // [m] of the paper's opening
constexpr double kFull = 0.8 * kUnit;   // [m] per hand
constexpr double kRate = 0.27 * kUnit;  // [m/s]
constexpr double kTurn = 30 * kDegree;  // [rad/s]

/// Where hands and beam are in the gripper's frame [m].
struct Places {
  double left_x, right_x, beam_y;
};

Places PlacesOf(const RobotState& state) {
  const RobotModel& robot = TheSharpRobot();
  std::vector<Eigen::Isometry3d> X_ML;
  LinkPoses(robot, state, X_ML);
  const Eigen::Isometry3d X_GM = X_ML[FindLink(robot, "gripper")].inverse();
  const auto place = [&](const char* link) {
    return Eigen::Vector3d(X_GM * X_ML[FindLink(robot, link)].translation());
  };
  return {place("left_hand").x(), place("right_hand").x(), place("crossbeam").y()};
}

RobotState Opened(double left, double right) {
  RobotState state = TablePose();
  state.left_opening = left;
  state.right_opening = right;
  state.joint[kGripperOpening] = (left + right) / 2;
  return state;
}

RobotState After(RobotState state, const MotionDemand& demand, int steps = 1) {
  for (int i = 0; i < steps; ++i) state = Advance(TheSharpRobot(), state, demand, kStep);
  return state;
}

TEST(Eq5, OpeningMovesTheLeftHandToMinusXAndTheRightOneToPlusX) {
  for (const auto& [motion, sign] : {std::pair{kGripperOpen, 1.0}, {kGripperClose, -1.0}}) {
    const Places before = PlacesOf(Opened(0.05, 0.07));
    const Places after = PlacesOf(After(Opened(0.05, 0.07), DemandFor({motion})));
    EXPECT_NEAR(after.left_x, before.left_x - sign * kRate * kStep, 1e-12);
    EXPECT_NEAR(after.right_x, before.right_x + sign * kRate * kStep, 1e-12);
  }
}

TEST(Eq5, EachHandIsClampedToItsOwnLimits) {
  // One step is 0.162 mm.
  RobotState state = After(Opened(kFull - 0.0001, 0.05), DemandFor({kGripperOpen}));
  EXPECT_EQ(state.left_opening, TheSharpRobot().joints[kGripperOpening].upper);
  EXPECT_NEAR(PlacesOf(state).left_x, -kFull, 1e-12);
  EXPECT_NEAR(state.right_opening, 0.05 + kRate * kStep, 1e-15);
  state = After(Opened(0.0001, 0.05), DemandFor({kGripperClose}));
  EXPECT_EQ(state.left_opening, 0);
  EXPECT_NEAR(state.right_opening, 0.05 - kRate * kStep, 1e-15);
}

TEST(Eq5, AStoppedHandHasNoWay) {
  MotionDemand demand = DemandFor({kGripperClose});
  demand.right_hand_stopped = true;
  RobotState state = After(Opened(0.06, 0.06), demand, 10);
  EXPECT_EQ(state.right_opening, 0.06);
  EXPECT_NEAR(state.left_opening, 0.06 - 10 * kRate * kStep, 1e-12);
  demand.left_hand_stopped = true;
  EXPECT_EQ(After(state, demand, 10), state);
}

TEST(Eq6, FullOpeningRetractsTheBeamByTwoThirds) {
  const double closed = PlacesOf(Opened(0, 0)).beam_y;
  const RobotState open = After(Opened(0, 0), DemandFor({kGripperOpen}), 800);
  EXPECT_NEAR((closed - PlacesOf(open).beam_y) / kUnit, 0.8 * 2 / 3, 1e-9);  // 0.5333 units
  EXPECT_NEAR(closed - PlacesOf(open).beam_y, 0.080, 1e-9);
}

TEST(Eq6, TheBeamFollowsTheMeanOfBothHands) {
  const double closed = PlacesOf(Opened(0, 0)).beam_y;
  EXPECT_NEAR(closed - PlacesOf(Opened(0.04, 0.10)).beam_y, 2.0 / 3 * 0.07, 1e-12);
  EXPECT_NEAR(closed - PlacesOf(Opened(0.10, 0.04)).beam_y, 2.0 / 3 * 0.07, 1e-12);
}

TEST(Eq6, OpenAndCloseReturnsExactly) {
  const RobotState closed = Opened(0, 0);
  const RobotState open = After(closed, DemandFor({kGripperOpen}), 800);
  const RobotState back = After(open, DemandFor({kGripperClose}), 800);
  EXPECT_EQ(back, closed);
  EXPECT_EQ(PlacesOf(back).beam_y, PlacesOf(closed).beam_y);
}

TEST(Eq7, RotationAddsUpAndWrapsTo180Degrees) {
  RobotState state = TablePose();
  state.joint[kGripperRoll] = 179.9 * kDegree;
  const double d = kTurn * kStep;  // 0.12 degrees
  const double over = After(state, DemandFor({kGripperCcw})).joint[kGripperRoll];
  EXPECT_NEAR(over, 179.9 * kDegree + d - 2 * std::numbers::pi, 1e-12);
  state.joint[kGripperRoll] = -179.9 * kDegree;
  const double under = After(state, DemandFor({kGripperCw})).joint[kGripperRoll];
  EXPECT_NEAR(under, -179.9 * kDegree - d + 2 * std::numbers::pi, 1e-12);
  for (const int motion : {kGripperCcw, kGripperCw}) {
    for (int i = 0; i < 4000; ++i) {
      state = After(state, DemandFor({motion}));
      ASSERT_GT(state.joint[kGripperRoll], -std::numbers::pi);
      ASSERT_LE(state.joint[kGripperRoll], std::numbers::pi);
    }
  }
}

TEST(Eq7, TurningTheGripperTurnsWhatItHolds) {
  Bench bench;
  bench.Open(0.065);
  bench.PlaceInHand(0, 0);
  ASSERT_TRUE(bench.CloseUntilGrasped());
  bench.Step(DemandFor({kGripperCcw}), 250);  // 30 degrees
  const Eigen::Vector3d axis = bench.bodies[0].X_MO.linear().col(2);
  EXPECT_NEAR(std::acos(axis.z()), kTurn, 1e-9);
}

}  // namespace
}  // namespace eod::sim
