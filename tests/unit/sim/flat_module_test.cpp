#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "sim/isectors/isector_set.h"
#include "sim/world/world_model.h"

namespace eod::sim {
namespace {

constexpr double kDegree = std::numbers::pi / 180;

/// The robot in the flat module, standing where a test puts it.
class FlatModule : public ::testing::Test {
 protected:
  static const RobotModel& Robot() {
    static const RobotModel model = LoadRobot(EOD_DATA_DIR "/sim/robots/eod_robot.sdf");
    return model;
  }
  static const World& TheWorld() {
    static const auto world =
        BuildWorld(LoadWorld(EOD_DATA_DIR "/sim/worlds/training_ground.sdf").Module(1));
    return *world;
  }
  RobotState state_ = HomeState(Robot());
  IsectorSet dut_{Robot(), kModuleFlat};

  void Cast(MotionSet commanded) {
    std::vector<Eigen::Isometry3d> X_ML;
    LinkPoses(Robot(), state_, X_ML);
    dut_.Cast(TheWorld(), X_ML, commanded);
  }
  const CastSegment& Line(const char* isector, const char* segment) {
    for (const CastSegment& cast : dut_.segments()) {
      const IsectorSpec& spec = Robot().isectors[static_cast<size_t>(cast.isector)];
      if (spec.name == isector &&
          spec.segments[static_cast<size_t>(cast.segment)].name == segment) {
        return cast;
      }
    }
    throw std::runtime_error(std::string(isector) + " " + segment + " was not cast");
  }
};

TEST_F(FlatModule, RobotStandsLevelOnTheStartPad) {
  Cast(0);
  EXPECT_EQ(dut_.ground().legs, 3);
  EXPECT_NEAR(dut_.ground().height, 0, 1e-12);
  EXPECT_NEAR(dut_.ground().normal.z(), 1, 1e-15);
}

TEST_F(FlatModule, NothingIsWithinReachOfAnyLineAtTheStart) {
  for (int motion = 0; motion < kMotionCount; ++motion) {
    Cast(SetOf(motion));
    for (const CastSegment& cast : dut_.segments()) {
      const IsectorSpec& isector = Robot().isectors[static_cast<size_t>(cast.isector)];
      const SegmentSpec& segment = isector.segments[static_cast<size_t>(cast.segment)];
      if (!cast.hit.hit) continue;
      EXPECT_GT(cast.hit.range, segment.d0) << isector.name << " " << segment.name;
    }
  }
}

TEST_F(FlatModule, ViewAheadMeasuresTheWayToTheWall) {
  Cast(0);
  const CastSegment& ahead = Line("LOS_FRONT", "+Y");
  EXPECT_EQ(TheWorld().ObjectName(ahead.hit.object), "wall");
  EXPECT_NEAR(ahead.hit.range, 4.0 - 0.475, 1e-9);  // from the chassis' front
}

TEST_F(FlatModule, FrontGuardsMeetTheWallWithTheirThreshold) {
  state_.position.y() = 4.0 - 0.475 - 0.04;  // 0.04 m before the wall, D0 is 0.05
  Cast(SetOf(kDriveForward));
  EXPECT_NEAR(Line("LOS_FRONT", "+Y").hit.range, 0.04, 1e-9);
  EXPECT_NEAR(Line("GUARD_FRONT", "left_low").hit.range, 0.04, 1e-9);
  EXPECT_NEAR(Line("GUARD_FRONT", "right_high").hit.range, 0.04, 1e-9);
}

TEST_F(FlatModule, LevelFlippersFeelTheWallWithTheirTips) {
  state_.joint[kFrontFlipper] = 0;
  state_.position.y() = 4.0 - 0.775 - 0.115;  // tips at 0.375 + 0.40; D0 is 0.12
  Cast(SetOf(kDriveForward));
  EXPECT_NEAR(Line("B1", "+Y").hit.range, 0.115, 1e-9);
  EXPECT_NEAR(Line("B2", "+Y").hit.range, 0.115, 1e-9);
}

TEST_F(FlatModule, FlipperLoweredToTheGoldenAngleMeetsTheGroundAtItsThreshold) {
  // (0.20 + 0.40 sin p) / cos p = 0.105 has its root at p = -14.21 deg.
  state_.joint[kFrontFlipper] = -14.21 * kDegree;
  Cast(SetOf(kFrontFlipperDown));
  EXPECT_EQ(TheWorld().ObjectName(Line("B1", "-Z").hit.object), "ground");
  EXPECT_NEAR(Line("B1", "-Z").hit.range, 0.105, 1e-4);
  EXPECT_NEAR(Line("B2", "-Z").hit.range, 0.105, 1e-4);
}

TEST_F(FlatModule, RobotFitsThroughTheGate) {
  state_.position = {-4.0, 1.9, 0};
  state_.attitude.heading = 90 * kDegree;
  Cast(SetOf(kDriveForward) | SetOf(kTurnLeft));
  EXPECT_EQ(TheWorld().ObjectName(Line("LOS_FRONT", "+Y").hit.object), "board");
  // Posts 0.60 m from the middle, chassis sides at 0.35.
  EXPECT_NEAR(Line("GUARD_LEFT", "middle").hit.range, 0.25, 1e-9);
  EXPECT_NEAR(Line("GUARD_RIGHT", "middle").hit.range, 0.25, 1e-9);
}

TEST_F(FlatModule, TwoSetsCastTheSameBits) {
  state_.position = {-3.1, 1.7, 0};
  state_.attitude.heading = 1.3;
  IsectorSet other(Robot(), kModuleFlat);
  std::vector<Eigen::Isometry3d> X_ML;
  LinkPoses(Robot(), state_, X_ML);
  dut_.Cast(TheWorld(), X_ML, kAllMotions);
  other.Cast(TheWorld(), X_ML, kAllMotions);
  ASSERT_EQ(dut_.segments().size(), other.segments().size());
  for (size_t i = 0; i < dut_.segments().size(); ++i) {
    EXPECT_EQ(dut_.segments()[i].hit.range, other.segments()[i].hit.range);
    EXPECT_EQ(dut_.segments()[i].hit.point, other.segments()[i].hit.point);
  }
}

}  // namespace
}  // namespace eod::sim
