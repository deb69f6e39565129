#include "sim/response/response.h"

#include <random>

#include <gtest/gtest.h>

#include "sim/stance/standing.h"
#include "tests/unit/behaviour/fixture.h"

namespace eod::sim {
namespace {

// Front small wheels with level flippers: axle 0.375 + flipper 0.40 ahead of the origin.
constexpr double kWheelY = 0.775;
constexpr double kD0 = 0.12;
constexpr double kWheelRadius = 0.10;

constexpr uint32_t BitOf(Part part) { return 1u << static_cast<int>(part); }

double Gap(const Yard& yard, double wall_y) { return wall_y - (yard.state.position.y() + kWheelY); }

TEST(DistanceThreshold, StepsUpAtTheCriticalSpeed) {
  SegmentSpec segment;
  segment.d0 = 0.12;
  segment.skin = 0.02;
  // V0 = skin / dt = 0.02 / 0.004 = 5 m/s.
  const DistanceLaw law{.dt_s = 0.004};
  EXPECT_EQ(DistanceThreshold(segment, 0, law), 0.12);
  EXPECT_EQ(DistanceThreshold(segment, 5.0, law), 0.12);
  EXPECT_DOUBLE_EQ(DistanceThreshold(segment, 5.001, law), 0.12 + 5.001 * 0.004);
}

TEST(DistanceThreshold, StaysAtD0WithoutTheFactor) {
  SegmentSpec segment;
  segment.d0 = 0.12;
  segment.skin = 0.02;
  const DistanceLaw fixed{.dt_s = 0.004, .with_factor = false};
  for (const double speed : {0.0, 5.001, 100.0}) {
    EXPECT_EQ(DistanceThreshold(segment, speed, fixed), 0.12);
  }
}

TEST(Response, StopGapKeepsTheBoundsOfEq2AtAnySpeed) {
  std::mt19937 random(20060311);
  std::uniform_real_distribution<double> period(0.001, 0.020);
  std::uniform_real_distribution<double> travel(0.0002, 0.15);  // [m] a step; lines reach 0.20 on
  int below = 0;
  int above = 0;
  for (int trial = 0; trial < 400; ++trial) {
    RobotModel robot = WithIsectors(TheRobot(), {"B1", "B2"});
    Yard yard(robot);
    yard.law.dt_s = period(random);
    // Half of the speeds up to V0, where a step is at most the skin of 20 mm.
    const double d = trial % 2 == 0 ? travel(random) : std::min(0.0199, travel(random) / 7);
    const double v = d / yard.law.dt_s;
    yard.robot.drive_speed = {v, v, v};
    const double wall_y = 2.0 + travel(random);
    AddWall(yard.world, {0, wall_y, 0}, {0, -1, 0});
    yard.Step(DemandFor({kDriveForward}), static_cast<int>(3.0 / d) + 2);
    const double gap = Gap(yard, wall_y);
    if (v <= 0.02 / yard.law.dt_s) {
      ++below;
      EXPECT_GT(gap, kD0 - d - 1e-9) << v;
      EXPECT_LE(gap, kD0 + 1e-9) << v;
    } else {
      ++above;
      EXPECT_GT(gap, kD0 - 1e-9) << v;
      EXPECT_LE(gap, kD0 + d + 1e-9) << v;
    }
    EXPECT_GE(gap, kWheelRadius - 1e-9) << v << ": penetrates";
    EXPECT_TRUE(Contains(yard.response.blocked, kDriveForward));
  }
  EXPECT_GT(below, 100);
  EXPECT_GT(above, 100);
}

TEST(Response, FixedDistancePenetratesAtSpeedAndEq2DoesNot) {
  // The design's example: 0.67 m/s at 25 Hz is 26.8 mm a step, beyond the skin of 20 mm.
  constexpr double kSpeed = 0.67, kPeriod = 0.04, kSkin = kD0 - kWheelRadius;
  constexpr double kStep = kSpeed * kPeriod;
  constexpr int kSteps = 10;
  for (const bool with_factor : {true, false}) {
    Yard yard(WithIsectors(TheRobot(), {"B1", "B2"}));
    yard.law = {.dt_s = kPeriod, .with_factor = with_factor};
    yard.robot.drive_speed = {kSpeed, kSpeed, kSpeed};
    // The worst case: after ten steps the wall is a micrometre beyond D0.
    const double wall_y = kWheelY + kSteps * kStep + kD0 + 1e-6;
    AddWall(yard.world, {0, wall_y, 0}, {0, -1, 0});
    yard.Step(DemandFor({kDriveForward}), 2 * kSteps);
    EXPECT_TRUE(Contains(yard.response.blocked, kDriveForward));
    const double penetration = kWheelRadius - Gap(yard, wall_y);
    if (with_factor) {
      EXPECT_NEAR(penetration, -kSkin, 2e-6);  // stopped before that step: D0 is left
    } else {
      EXPECT_NEAR(penetration, kStep - kSkin, 2e-6);  // 6.8 mm
    }
  }
}

TEST(Response, WithoutDynamicLoadingTheSameSegmentsBlockTheSameMotions) {
  const RobotModel& robot = TheRobot();
  const auto walls = [](Yard& yard) {
    yard.world.AddPlane("ground", kModuleFlat | kBumpProxy, {0, 0, 0}, Eigen::Vector3d::UnitZ());
    AddWall(yard.world, {0, 1.1, 0}, {0.1, -1, 0});
    AddWall(yard.world, {-0.6, 0, 0}, {1, 0, 0});
  };
  Yard loaded(robot);
  Yard all(robot, {.dynamic_loading = false});
  walls(loaded);
  walls(all);
  std::mt19937 random(22);
  for (int i = 0; i < 600; ++i) {
    // Two motions for a while, of all 22; some of them are opposites, which is nothing to Respond.
    const int first = static_cast<int>(random() % kMotionCount);
    const int second = static_cast<int>(random() % kMotionCount);
    const MotionDemand demand = DemandFor({first, second});
    for (int step = 0; step < 10; ++step) {
      loaded.Step(demand);
      all.Step(demand);
      ASSERT_EQ(loaded.response.blocked, all.response.blocked) << i << "." << step;
      ASSERT_EQ(loaded.response.contact_parts, all.response.contact_parts) << i << "." << step;
      ASSERT_EQ(loaded.state, all.state) << i << "." << step;
    }
    ASSERT_LE(loaded.isectors.segments().size(), all.isectors.segments().size());
  }
}

TEST(Response, WallAheadNamesBothWheelsAndLeavesRetreatFree) {
  Yard yard(WithIsectors(TheRobot(), {"B1", "B2", "B3", "B4"}));
  AddWall(yard.world, {0, 1, 0}, {0, -1, 0});
  yard.Step(DemandFor({kDriveForward}), 200);
  EXPECT_EQ(yard.response.blocked, SetOf(kDriveForward));
  EXPECT_EQ(yard.response.contact_parts,
            BitOf(Part::kFrontLeftWheel) | BitOf(Part::kFrontRightWheel));
  const double before = yard.state.position.y();
  yard.Step(DemandFor({kDriveReverse}));
  EXPECT_NEAR(before - yard.state.position.y(), 0.30 * 0.004, 1e-12);
}

TEST(Response, ContactStandsWithoutACommandAndEndsWithTheRetreat) {
  Yard yard(WithIsectors(TheRobot(), {"B1", "B2", "B3", "B4"}));
  AddWall(yard.world, {0, 1, 0}, {0, -1, 0});
  yard.Step(DemandFor({kDriveForward}), 200);
  yard.Step({}, 10);
  EXPECT_EQ(yard.response.blocked, SetOf(kDriveForward));
  EXPECT_NE(yard.response.contact_parts, 0u);
  // At most 1.2 mm beyond D0: two steps back of 1.2 mm end it at the latest, the third step sees
  // it.
  yard.Step(DemandFor({kDriveReverse}), 3);
  EXPECT_EQ(yard.response.blocked, 0u);
  EXPECT_EQ(yard.response.contact_parts, 0u);
}

TEST(Response, ObliqueWallStopsTheNearerWheelOnly) {
  Yard yard(WithIsectors(TheRobot(), {"B1", "B2"}));
  // The face runs from near left to far right.
  AddWall(yard.world, {0, 1.2, 0}, {0.3, -1, 0});
  yard.Step(DemandFor({kDriveForward}), 400);
  EXPECT_EQ(yard.response.contact_parts, BitOf(Part::kFrontLeftWheel));
}

TEST(Response, DrivesAlongAWallThatTouchesItsSide) {
  Yard yard(WithIsectors(TheRobot(), {"B1", "B2", "B3", "B4"}));
  // Wheel at x = -0.30: 0.11 from the wall, nearer than D0 = 0.12.
  AddWall(yard.world, {-0.41, 0, 0}, {1, 0, 0});
  yard.Step(DemandFor({kDriveForward}), 500);
  EXPECT_EQ(yard.response.blocked, 0u);
  EXPECT_NEAR(yard.state.position.y(), 500 * 0.30 * 0.004, 1e-9);
}

TEST(Response, TurnIntoAWallBesideStopsAndTheOtherWayIsFree) {
  Yard yard(WithIsectors(TheRobot(), {"B1", "B2", "B3", "B4"}));
  AddWall(yard.world, {-0.55, 0, 0}, {1, 0, 0});
  yard.Step(DemandFor({kTurnLeft}), 400);
  EXPECT_TRUE(Contains(yard.response.blocked, kTurnLeft));
  const double stopped_at = yard.state.attitude.heading;
  EXPECT_GT(stopped_at, 1 * kDegree);
  EXPECT_LT(stopped_at, 25 * kDegree);
  // No wheel's centre is nearer to the wall than its radius.
  LinkPoses(yard.robot, yard.state, yard.X_ML);
  for (const IsectorSpec& isector : yard.robot.isectors) {
    const Eigen::Vector3d p_M = yard.X_ML[isector.link] * isector.X_LI.translation();
    EXPECT_GT(p_M.x() + 0.55, kWheelRadius) << isector.name;
  }
  yard.Step(DemandFor({kTurnRight}), 5);
  EXPECT_NEAR(stopped_at - yard.state.attitude.heading, 5 * 0.12 * kDegree, 1e-9);
}

TEST(Response, SlidesOutOfACornerByTurning) {
  // Stopped by a wall ahead, the robot may still turn when it has backed off by more than it
  // swings.
  Yard yard(WithIsectors(TheRobot(), {"B1", "B2", "B3", "B4"}));
  AddWall(yard.world, {0, 1, 0}, {0, -1, 0});
  yard.Step(DemandFor({kDriveForward}), 200);
  // Turning left swings the right wheel forward: its +Y gets shorter.
  yard.Step(DemandFor({kTurnLeft}));
  EXPECT_TRUE(Contains(yard.response.blocked, kTurnLeft));
  yard.Step(DemandFor({kDriveReverse}), 100);
  yard.Step(DemandFor({kTurnLeft}), 50);
  EXPECT_NEAR(yard.state.attitude.heading, 50 * 0.12 * kDegree, 1e-9);
}

TEST(Response, TwoMotionsThatPassV0OnlyTogetherAreBlockedTogether) {
  RobotModel robot = WithIsectors(TheRobot(), {"B2"});
  Yard yard(robot);
  // V0 = 0.02 / 0.02 = 1 m/s. Forward 0.9 m/s, and a turn that gives the right wheel 0.3 m x 1
  // rad/s.
  yard.law.dt_s = 0.02;
  yard.robot.drive_speed = {0.9, 0.9, 0.9};
  yard.robot.turn_rate = 1.0;
  // Wheel 0.13 before the wall: alone each has D = 0.12; together |(-0.775, 1.2)| = 1.43 m/s > V0,
  // D = 0.12 + 0.0286.
  AddWall(yard.world, {0, kWheelY + 0.13, 0}, {0, -1, 0});
  yard.Step(DemandFor({kDriveForward}));
  EXPECT_EQ(yard.response.blocked, 0u);
  yard.state = LevelFlippers(yard.robot);
  yard.Step(DemandFor({kTurnLeft}));
  EXPECT_EQ(yard.response.blocked, 0u);
  yard.state = LevelFlippers(yard.robot);
  yard.Step(DemandFor({kDriveForward, kTurnLeft}));
  EXPECT_EQ(yard.response.blocked, SetOf(kDriveForward) | SetOf(kTurnLeft));
}

TEST(Response, LoweredFrontFlipperStopsOnFlatGroundAtTheGoldenAngle) {
  Yard yard(WithIsectors(TheRobot(), {"B1", "B2", "B3", "B4"}));
  yard.world.AddPlane("ground", kModuleFlat | kClampProxy | kBumpProxy, Eigen::Vector3d::Zero(),
                      Eigen::Vector3d::UnitZ());
  yard.Step(DemandFor({kFrontFlipperDown}), 1000);
  EXPECT_TRUE(Contains(yard.response.blocked, kFrontFlipperDown));
  // 20 deg/s x 4 ms = 0.08 deg a step beyond the angle where the line reads 0.105.
  EXPECT_LE(yard.state.joint[kFrontFlipper] / kDegree, -14.21 + 0.005);
  EXPECT_GT(yard.state.joint[kFrontFlipper] / kDegree, -14.21 - 0.08 - 0.005);
  // Driving on is free, raising it too.
  yard.Step(DemandFor({kDriveForward}));
  EXPECT_NEAR(yard.state.position.y(), 0.0012, 1e-12);
  yard.Step(DemandFor({kFrontFlipperUp}), 10);
  EXPECT_EQ(yard.response.blocked, 0u);
}

TEST(Response, OutwardPushOfOneHandStopsThatHandAlone) {
  RobotModel robot = WithIsectors(TheRobot(), {"B5", "B6", "B7"});
  // Let a line of the left hand look outwards, as a guard would.
  robot.isectors[FindIsector(robot, "B5")].segments.push_back(
      {.name = "out",
       .direction = -Eigen::Vector3d::UnitX(),
       .length = 0.3,
       .d0 = 0.05,
       .skin = 0.02});
  Yard yard(robot);
  AddWall(yard.world, {-0.09, 0, 0}, {1, 0, 0});
  // The left hand starts at x = 0 and stops 0.05 before the wall: 40 mm open.
  yard.Step(DemandFor({kGripperOpen}), 800);
  EXPECT_EQ(yard.response.left_hand_blocked, SetOf(kGripperOpen));
  EXPECT_EQ(yard.response.blocked, 0u);
  EXPECT_NEAR(yard.state.left_opening, 0.04, 0.0405 * 0.004 + 1e-9);
  EXPECT_EQ(yard.state.right_opening, yard.robot.joints[kGripperOpening].upper);
}

TEST(Response, PadPressedIntoAThingStopsItsHandWhileClosing) {
  // A box between the hands, off to the left. That l3, l6 and l9 see it is nearness and stops
  // nothing, until the left pad's line l1 starts inside it.
  Yard yard(WithIsectors(TheRobot(), {"B5", "B6", "B7"}));
  yard.state.left_opening = yard.state.right_opening = yard.state.joint[kGripperOpening] = 0.10;
  LinkPoses(yard.robot, yard.state, yard.X_ML);
  const Eigen::Isometry3d X_MG = yard.X_ML[FindLink(yard.robot, "gripper")];
  // 60 mm wide from -80 mm to -20 mm across, at the middle of the fingers.
  Eigen::Isometry3d X_MB = X_MG * Eigen::Translation3d(-0.05, 0.15 + 0.08, 0);
  yard.world.AddBox("bomb", kModuleFlat | kBombObject | kBumpProxy, X_MB, {0.06, 0.06, 0.20});
  yard.Step(DemandFor({kGripperClose}), 400);
  EXPECT_EQ(yard.response.left_hand_blocked, SetOf(kGripperClose));
  // The left pad stops just inside the box's left face, the right one goes on to its own.
  EXPECT_NEAR(yard.state.left_opening, 0.08, 0.0405 * 0.004 + 1e-9);
  EXPECT_LT(yard.state.right_opening, 0.05);
  // Opening again is free.
  const double pressed = yard.state.left_opening;
  yard.Step(DemandFor({kGripperOpen}), 10);
  EXPECT_GT(yard.state.left_opening, pressed);
}

TEST(StandOn, TakesHeightAndAttitudeOfThePlaneUnderThreeLegs) {
  RobotState state;
  state.attitude.heading = 30 * kDegree;
  state.fall_speed = 3;
  // Golden plane of the design: pitch 20 deg at heading 30 deg.
  const Eigen::Vector3d n = ToRotation({.heading = 30 * kDegree, .pitch = 20 * kDegree}).col(2);
  const RobotState next =
      StandOn({.legs = 3, .height = 0.7, .normal = n, .mean_offset = 0.1}, state, 0.004);
  EXPECT_NEAR(next.attitude.pitch, 20 * kDegree, 1e-12);
  EXPECT_NEAR(next.attitude.roll, 0, 1e-12);
  EXPECT_EQ(next.attitude.heading, state.attitude.heading);
  EXPECT_EQ(next.position.z(), 0.7);
  EXPECT_EQ(next.fall_speed, 0);
}

TEST(StandOn, KeepsTheAttitudeOnOneOrTwoLegs) {
  RobotState state;
  state.attitude = {.heading = 0.4, .pitch = 0.2, .roll = 0.1};
  state.position.z() = 1;
  for (const int legs : {1, 2}) {
    const RobotState next = StandOn({.legs = legs, .mean_offset = -0.02}, state, 0.004);
    EXPECT_EQ(next.attitude, state.attitude);
    EXPECT_DOUBLE_EQ(next.position.z(), 0.98);
  }
}

TEST(StandOn, FallsWithGravityUntilGroundIsFound) {
  RobotState state;
  for (int i = 0; i < 250; ++i) state = StandOn({}, state, 0.004);
  // Free fall of 1 s: g t at the end, and g t^2 / 2 (plus half a step) down.
  EXPECT_NEAR(state.fall_speed, 9.80665, 1e-9);
  EXPECT_NEAR(state.position.z(), -9.80665 / 2 * (1 + 0.004), 1e-9);
  state = StandOn({.legs = 3, .height = -6}, state, 0.004);
  EXPECT_EQ(state.position.z(), -6);
  EXPECT_EQ(state.fall_speed, 0);
}

}  // namespace
}  // namespace eod::sim
