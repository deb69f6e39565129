#include "sim/isectors/isector_set.h"

#include <gtest/gtest.h>

#include "sim/world/analytic_world.h"

namespace eod::sim {
namespace {

using Eigen::Vector3d;

const RobotModel& Robot() {
  static const RobotModel model = LoadRobot(EOD_DATA_DIR "/sim/robots/eod_robot.sdf");
  return model;
}

class IsectorSetTest : public ::testing::Test {
 protected:
  AnalyticWorld world_;

  void Cast(IsectorSet& dut, MotionSet commanded) {
    std::vector<Eigen::Isometry3d> X_ML;
    LinkPoses(Robot(), HomeState(Robot()), X_ML);
    dut.Cast(world_, X_ML, commanded);
  }
  void Cast(IsectorSet& dut, MotionSet commanded, int64_t step) {
    std::vector<Eigen::Isometry3d> X_ML;
    LinkPoses(Robot(), HomeState(Robot()), X_ML);
    dut.Cast(world_, X_ML, commanded, step);
  }
};

TEST_F(IsectorSetTest, IsectorsAreReadForTheStepTheyWereActiveIn) {
  IsectorSet dut(Robot(), kModuleFlat);
  const int b1 = FindIsector(Robot(), "B1"), tripod = FindIsector(Robot(), "TRIPOD");
  Cast(dut, SetOf(kDriveForward), 41);
  EXPECT_NO_THROW(dut.isector(b1).Hit(2, 41));
  Cast(dut, 0, 42);
  EXPECT_THROW(dut.isector(b1).Hit(2, 42), StaleReading);  // nothing loads it
  EXPECT_NO_THROW(dut.isector(tripod).Hit(0, 42));
  EXPECT_EQ(dut.step(), 42);
}

TEST_F(IsectorSetTest, SegmentThatIsNotLoadedIsStaleToo) {
  IsectorSet dut(Robot(), kModuleFlat);
  const int b1 = FindIsector(Robot(), "B1");
  constexpr int kDown = 5;  // -Z rests on the ground: loaded while the flipper goes down
  Cast(dut, SetOf(kDriveForward), 1);
  EXPECT_THROW(dut.isector(b1).Hit(kDown, 1), StaleReading);
  Cast(dut, SetOf(kFrontFlipperDown), 2);
  EXPECT_NO_THROW(dut.isector(b1).Hit(kDown, 2));
}

TEST_F(IsectorSetTest, CountsStepsForWhoDoesNot) {
  IsectorSet dut(Robot(), kModuleFlat);
  Cast(dut, 0);
  Cast(dut, 0);
  EXPECT_EQ(dut.step(), 1);
  EXPECT_TRUE(dut.isector(FindIsector(Robot(), "TRIPOD")).IsFresh(1));
}

TEST_F(IsectorSetTest, ListAndIsectorsTellTheSame) {
  world_.AddPlane("ground", kModuleFlat | kClampProxy | kBumpProxy, {0, 0, 0}, Vector3d::UnitZ());
  IsectorSet dut(Robot(), kModuleFlat);
  Cast(dut, kAllMotions, 5);
  for (const CastSegment& cast : dut.segments()) {
    const SegmentHit& hit = dut.isector(cast.isector).Hit(cast.segment, 5);
    EXPECT_EQ(hit.hit, cast.hit.hit);
    EXPECT_EQ(hit.point, cast.hit.point);
  }
}

TEST_F(IsectorSetTest, SegmentDisabledInTheRobotFileIsNeverCast) {
  RobotModel robot = Robot();
  const int b1 = FindIsector(robot, "B1");
  robot.isectors[b1].segments[2].enabled = false;
  std::vector<Eigen::Isometry3d> X_ML;
  LinkPoses(robot, HomeState(robot), X_ML);
  for (const bool dynamic_loading : {true, false}) {
    IsectorSet dut(robot, kModuleFlat, Coverage::kPaper, {.dynamic_loading = dynamic_loading});
    dut.Cast(world_, X_ML, kAllMotions);
    for (const CastSegment& cast : dut.segments()) {
      EXPECT_FALSE(cast.isector == b1 && cast.segment == 2);
    }
  }
}

TEST_F(IsectorSetTest, WithoutDynamicLoadingAllIsAlwaysCast) {
  size_t paper = 0, all = 0;
  for (const IsectorSpec& isector : Robot().isectors) {
    all += isector.segments.size();
    if (!isector.extended) paper += isector.segments.size();
  }
  EXPECT_EQ(paper, 36u + 2);  // the design's 24 + 9 + 3, and the two lines of sight
  const IsectorRules rules{.dynamic_loading = false};
  IsectorSet of_paper(Robot(), kModuleFlat, Coverage::kPaper, rules);
  IsectorSet of_all(Robot(), kModuleFlat, Coverage::kExtended, rules);
  for (const MotionSet commanded : {MotionSet{0}, SetOf(kCameraPanLeft), kAllMotions}) {
    Cast(of_paper, commanded);
    Cast(of_all, commanded);
    EXPECT_EQ(of_paper.segments().size(), paper);
    EXPECT_EQ(of_all.segments().size(), all);
  }
}

TEST_F(IsectorSetTest, ModuleMasksLeaveAFifthOfFiveEqualModules) {
  // Five equal parts, all within reach of the segments.
  constexpr uint32_t kModules[] = {kModuleFlat, kModuleSlope, kModuleBomb, kModuleOutdoor,
                                   kModuleIndoor};
  constexpr int kEach = 7;
  for (const uint32_t module : kModules) {
    for (int i = 0; i < kEach; ++i) {
      world_.AddPlane("part", module | kClampProxy | kBumpProxy, {0, 0, -10.0 * i},
                      Vector3d::UnitZ());
    }
  }
  for (const uint32_t module : kModules) {
    IsectorSet masked(Robot(), module);
    IsectorSet unmasked(Robot(), module, Coverage::kExtended, {.module_masks = false});
    Cast(masked, kAllMotions);
    Cast(unmasked, kAllMotions);
    const size_t segments = masked.segments().size();
    EXPECT_EQ(masked.counters().candidates, segments * kEach);
    EXPECT_EQ(unmasked.counters().candidates, segments * kEach * 5);
  }
}

TEST_F(IsectorSetTest, TakesOverLinesOfTheModelThatHaveChanged) {
  RobotModel robot = Robot();
  const int b1 = FindIsector(robot, "B1");
  IsectorSet dut(robot, kModuleFlat);
  SegmentSpec& line = robot.isectors[b1].segments[0];
  line.start = {0, 0, 3};
  line.enabled = true;
  dut.Reload(b1);
  Cast(dut, kAllMotions, 1);
  std::vector<Eigen::Isometry3d> X_ML;
  LinkPoses(robot, HomeState(robot), X_ML);
  const Eigen::Isometry3d X_MI = X_ML[robot.isectors[b1].link] * robot.isectors[b1].X_LI;
  for (const CastSegment& cast : dut.segments()) {
    if (cast.isector != b1 || cast.segment != 0) continue;
    EXPECT_TRUE(cast.query.start.isApprox(X_MI * line.start, 1e-12));
  }
  EXPECT_THROW(dut.Reload(1000), std::out_of_range);
}

}  // namespace
}  // namespace eod::sim
