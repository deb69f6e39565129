#include <map>
#include <set>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sim/isectors/isector_set.h"
#include "sim/world/analytic_world.h"

namespace eod::sim {
namespace {

using testing::Contains;
using testing::Not;

class DynamicLoading : public ::testing::Test {
 protected:
  static const RobotModel& Robot() {
    static const RobotModel model = LoadRobot(EOD_DATA_DIR "/sim/robots/eod_robot.sdf");
    return model;
  }
  AnalyticWorld world_;
  IsectorSet dut_{Robot(), kModuleFlat, Coverage::kPaper};

  /// "B1 +Y" and so on: what is cast while `commanded`.
  std::set<std::string> Cast(IsectorSet& set, MotionSet commanded) {
    std::vector<Eigen::Isometry3d> X_ML;
    LinkPoses(Robot(), HomeState(Robot()), X_ML);
    set.Cast(world_, X_ML, commanded);
    std::set<std::string> names;
    for (const CastSegment& cast : set.segments()) {
      const IsectorSpec& isector = Robot().isectors[static_cast<size_t>(cast.isector)];
      names.insert(isector.name + " " + isector.segments[static_cast<size_t>(cast.segment)].name);
    }
    EXPECT_EQ(names.size(), set.segments().size());
    return names;
  }
  std::set<std::string> Cast(MotionSet commanded) { return Cast(dut_, commanded); }

  /// Lines of the source paper's set alone: the seven BUMPs.
  static size_t OfBumps(const std::set<std::string>& names) {
    size_t count = 0;
    for (const std::string& name : names) {
      if (name[0] == 'B') ++count;
    }
    return count;
  }
};

TEST_F(DynamicLoading, NothingCommandedLeavesTheGroundAndTheViewAhead) {
  EXPECT_EQ(Cast(0), (std::set<std::string>{"TRIPOD front_left", "TRIPOD front_right",
                                            "TRIPOD rear", "LOS_FRONT +Y"}));
}

TEST_F(DynamicLoading, EachMotionLoadsItsIsectors) {
  // Lines of B1..B7 a motion. A wheel has six, less its -Z (which rests on the ground) unless its
  // flipper goes down; B5, B6, B7 have three each.
  constexpr size_t kWheels = 2 * 5, kLowered = 2 * 6, kHand = 9;
  const std::map<int, size_t> expected = {{kDriveForward, kWheels + kHand},
                                          {kDriveReverse, kWheels},
                                          {kTurnLeft, 2 * kWheels + kHand},
                                          {kTurnRight, 2 * kWheels + kHand},
                                          {kFrontFlipperUp, kWheels},
                                          {kFrontFlipperDown, kLowered},
                                          {kRearFlipperUp, kWheels},
                                          {kRearFlipperDown, kLowered},
                                          {kBigArmUp, kHand},
                                          {kBigArmDown, kHand},
                                          {kSmallArmUp, kHand},
                                          {kSmallArmDown, kHand},
                                          {kWristUp, kHand},
                                          {kWristDown, kHand},
                                          {kGripperCcw, kHand},
                                          {kGripperCw, kHand},
                                          {kGripperOpen, kHand},
                                          {kGripperClose, kHand},
                                          {kCameraPanLeft, 0},
                                          {kCameraPanRight, 0},
                                          {kCameraTiltUp, 0},
                                          {kCameraTiltDown, 0}};
  for (const auto& [motion, lines] : expected) {
    EXPECT_EQ(OfBumps(Cast(SetOf(motion))), lines) << "M" << motion + 1;
  }
}

TEST_F(DynamicLoading, SavesTwoThirdsOfTheLines) {
  // As the design counts it: whole isectors, TRIPOD with the chassis and the flippers. All = 36
  // lines.
  size_t all = 0, sum = 0;
  for (int motion = 0; motion < kMotionCount; ++motion) {
    for (const IsectorSpec& isector : Robot().isectors) {
      const bool counts = isector.name[0] == 'B' || motion <= kRearFlipperDown;
      if (isector.extended || isector.method == IsectorMethod::kLos) continue;
      if (motion == 0) all += isector.segments.size();
      if (counts && (isector.motions & SetOf(motion)) != 0) sum += isector.segments.size();
    }
  }
  EXPECT_EQ(all, 36u);
  // 24 + 15 + 36 + 36, four flipper motions of 15, ten of arm and hand of 9, none for the camera.
  EXPECT_EQ(sum, 24u + 15 + 36 + 36 + 4 * 15 + 10 * 9);
  EXPECT_NEAR(static_cast<double>(sum) / kMotionCount, 11.9, 0.05);
}

TEST_F(DynamicLoading, WheelsLookDownOnlyWhileTheirFlipperGoesDown) {
  for (int motion = 0; motion < kMotionCount; ++motion) {
    const auto names = Cast(SetOf(motion));
    EXPECT_EQ(names.contains("B1 -Z"), motion == kFrontFlipperDown) << motion;
    EXPECT_EQ(names.contains("B2 -Z"), motion == kFrontFlipperDown) << motion;
    EXPECT_EQ(names.contains("B3 -Z"), motion == kRearFlipperDown) << motion;
    EXPECT_EQ(names.contains("B4 -Z"), motion == kRearFlipperDown) << motion;
  }
}

TEST_F(DynamicLoading, MotionsTogetherTakeTheUnion) {
  const auto both = Cast(SetOf(kDriveForward) | SetOf(kFrontFlipperDown));
  EXPECT_THAT(both, Contains("B1 -Z"));
  EXPECT_THAT(both, Contains("B5 l1"));
  EXPECT_THAT(both, Not(Contains("B3 +Y")));
  EXPECT_EQ(OfBumps(both), 2u * 6 + 9);
}

TEST_F(DynamicLoading, RearLineIsCastInReverseOnly) {
  EXPECT_THAT(Cast(SetOf(kDriveReverse)), Contains("LOS_REAR -Y"));
  EXPECT_THAT(Cast(SetOf(kDriveForward)), Not(Contains("LOS_REAR -Y")));
}

TEST_F(DynamicLoading, GuardsBelongToTheExtendedCoverage) {
  IsectorSet extended(Robot(), kModuleFlat);
  EXPECT_THAT(Cast(extended, SetOf(kDriveForward)), Contains("GUARD_FRONT left_low"));
  EXPECT_THAT(Cast(extended, SetOf(kTurnLeft)), Contains("GUARD_RIGHT rear"));
  EXPECT_THAT(Cast(extended, SetOf(kBigArmDown)), Contains("B5_DOWN -Z"));
  EXPECT_THAT(Cast(SetOf(kDriveForward)), Not(Contains("GUARD_FRONT left_low")));
}

TEST_F(DynamicLoading, WorkIsCounted) {
  world_.AddPlane("ground", kModuleFlat | kClampProxy | kBumpProxy, Eigen::Vector3d::Zero(),
                  Eigen::Vector3d::UnitZ());
  Cast(SetOf(kTurnLeft));
  EXPECT_EQ(dut_.counters().segments, dut_.segments().size());
  EXPECT_EQ(dut_.counters().candidates, dut_.segments().size());  // one plane, offered to each
  Cast(0);
  EXPECT_EQ(dut_.counters().segments, 4u);  // of this step, not a sum
}

}  // namespace
}  // namespace eod::sim
