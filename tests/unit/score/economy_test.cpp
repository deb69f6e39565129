#include <gtest/gtest.h>

#include "sim/robot/motion_id.h"
#include "sim/score/economy_watch.h"
#include "tests/unit/score/judged.h"

namespace eod::sim {
namespace {

double Lost(const Judged& run) { return kRubric.economy - run.economy(); }

/// Moves a joint by so many degrees, one a step.
void MoveJoint(Judged& run, int joint, int degrees) {
  for (int i = 0; i < std::abs(degrees); ++i) {
    run.sample.joint[joint] += degrees > 0 ? 1 : -1;
    run.Step();
  }
}

TEST(Economy, DrivingBackAtOnceCostsAndLaterDoesNot) {
  Judged run;
  run.sample.camera_select = 0;
  run.Drive(1);
  run.Drive(-1);
  EXPECT_DOUBLE_EQ(Lost(run), ThePoints().reversal_points);
  run.Wait(ThePoints().reversal_time);
  run.Drive(1);
  EXPECT_DOUBLE_EQ(Lost(run), ThePoints().reversal_points);
  run.Drive(1);  // on in the same direction
  EXPECT_DOUBLE_EQ(Lost(run), ThePoints().reversal_points);
}

TEST(Economy, TurningBackAtOnceCosts) {
  Judged run;
  for (const double rate : {20.0, 20.0, 0.0, -5.0, -5.0}) {
    run.sample.turn_rate_dps = rate;
    run.Step();
  }
  EXPECT_DOUBLE_EQ(Lost(run), ThePoints().reversal_points);
}

TEST(Economy, ArmMotionTakenBackAtOnceCostsOnce) {
  Judged run;
  MoveJoint(run, kBigArm, 10);
  MoveJoint(run, kBigArm, static_cast<int>(-10 * ThePoints().undone_share) + 1);
  EXPECT_EQ(Lost(run), 0);
  MoveJoint(run, kBigArm, -5);
  EXPECT_DOUBLE_EQ(Lost(run), ThePoints().undone_points);
}

TEST(Economy, CorrectionsLaterMotionsAndLooksAreFree) {
  Judged run;
  MoveJoint(run, kSmallArm, 2);  // no more than a correction
  MoveJoint(run, kSmallArm, -2);
  MoveJoint(run, kBigArm, 10);
  run.Wait(ThePoints().reversal_time + 0.2);
  MoveJoint(run, kBigArm, -10);
  MoveJoint(run, kCameraPan, 30);
  MoveJoint(run, kCameraPan, -30);
  EXPECT_EQ(Lost(run), 0);
}

TEST(Economy, RollThroughAFullTurnIsNoWayBack) {
  Judged run;
  run.sample.joint[kGripperRoll] = 170;
  run.Step();
  MoveJoint(run, kGripperRoll, 9);
  run.sample.joint[kGripperRoll] = -180;  // wrapped round
  run.Step();
  MoveJoint(run, kGripperRoll, 9);
  EXPECT_EQ(Lost(run), 0);
}

TEST(Economy, JointDrivenAgainstItsLimitCostsUntilItHasLeftIt) {
  Judged run;
  run.sample.limit_flags = 1u << kWrist;
  run.Step();  // stands there: free
  EXPECT_EQ(Lost(run), 0);
  run.sample.wanted_mask = run.sample.inhibit_mask = SetOf(kWristUp);
  run.Steps(5);
  run.sample.wanted_mask = 0;
  run.Step();
  run.sample.wanted_mask = SetOf(kWristUp);
  run.Step();
  EXPECT_DOUBLE_EQ(Lost(run), ThePoints().limit_points);
  run.sample.limit_flags = 0;
  run.Step();
  run.sample.limit_flags = 1u << kWrist;
  run.Step();
  EXPECT_DOUBLE_EQ(Lost(run), 2 * ThePoints().limit_points);
}

TEST(Economy, OpeningTheHandsToTheirStopIsFree) {
  Judged run;
  run.sample.limit_flags = 1u << kGripperOpening;
  run.sample.wanted_mask = run.sample.inhibit_mask = SetOf(kGripperOpen);
  run.Step();
  EXPECT_EQ(Lost(run), 0);
}

}  // namespace
}  // namespace eod::sim
