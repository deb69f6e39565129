#include "sim/robot/robot_model.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "sim/geometry/object_class.h"
#include "tests/unit/sim/edited_file.h"

namespace eod::sim {
namespace {

constexpr double kDegree = std::numbers::pi / 180;

const RobotModel& Robot() {
  static const RobotModel model = LoadRobot(EOD_DATA_DIR "/sim/robots/eod_robot.sdf");
  return model;
}

TEST(RobotModel, NineJointsGiveEighteenMotionsBesideTheFourOfTheDrive) {
  MotionSet motions =
      SetOf(kDriveForward) | SetOf(kDriveReverse) | SetOf(kTurnLeft) | SetOf(kTurnRight);
  for (const JointSpec& joint : Robot().joints) {
    motions |= SetOf(joint.positive_motion) | SetOf(joint.negative_motion);
    EXPECT_EQ(joint.positive_motion ^ 1, joint.negative_motion) << joint.name;
  }
  EXPECT_EQ(motions, kAllMotions);
}

TEST(RobotModel, LimitsRatesAndHomeAreThoseOfTheDesign) {
  struct Row {
    double lower, upper, rate, home;  // degrees, J7 in metres
  };
  // J7: 0..0.8 units of 0.15 m at 0.27 units/s.
  const std::array<Row, kJointCount> table = {
      Row{-45, 120, 20, 90},   Row{-45, 120, 20, 90},  Row{0, 150, 10, 120},
      Row{0, 180, 15, 30},     Row{-100, 100, 20, 30}, Row{-180, 180, 30, 0},
      Row{0, 0.12, 0.0405, 0}, Row{-170, 170, 40, 0},  Row{-60, 90, 30, -10}};
  for (size_t i = 0; i < table.size(); ++i) {
    const JointSpec& joint = Robot().joints[i];
    const double unit = i == kGripperOpening ? 1 : kDegree;
    EXPECT_NEAR(joint.lower, table[i].lower * unit, 1e-9) << joint.name;
    EXPECT_NEAR(joint.upper, table[i].upper * unit, 1e-9) << joint.name;
    EXPECT_NEAR(joint.rate, table[i].rate * unit, 1e-9) << joint.name;
    EXPECT_NEAR(joint.home, table[i].home * unit, 1e-9) << joint.name;
  }
}

TEST(RobotModel, DriveSpeedsAndTurnRate) {
  EXPECT_EQ(Robot().drive_speed, (std::array<double, 3>{0.10, 0.30, 0.67}));
  EXPECT_NEAR(Robot().turn_rate, 30 * kDegree, 1e-12);
  EXPECT_EQ(Robot().step_up_limit, 0.45);
  EXPECT_EQ(Robot().fall_search, 3.0);
}

TEST(RobotModel, ParentsComeBeforeTheirChildren) {
  EXPECT_EQ(Robot().links[0].parent, -1);
  for (size_t i = 1; i < Robot().links.size(); ++i) {
    EXPECT_GE(Robot().links[i].parent, 0);
    EXPECT_LT(Robot().links[i].parent, static_cast<int>(i));
  }
}

TEST(RobotModel, HasTheSevenBumpsTripodAndBothLines) {
  for (const char* name : {"B1", "B2", "B3", "B4", "B5", "B6", "B7"}) {
    const int index = FindIsector(Robot(), name);
    ASSERT_GE(index, 0) << name;
    const IsectorSpec& bump = Robot().isectors[static_cast<size_t>(index)];
    EXPECT_EQ(bump.method, IsectorMethod::kBump);
    EXPECT_FALSE(bump.extended);
    EXPECT_EQ(bump.segments.size(), name[1] <= '4' ? 6u : 3u) << name;
  }
  EXPECT_GE(FindIsector(Robot(), "TRIPOD"), 0);
  EXPECT_GE(FindIsector(Robot(), "LOS_FRONT"), 0);
  EXPECT_GE(FindIsector(Robot(), "LOS_REAR"), 0);
}

TEST(RobotModel, ThresholdsIncludeTheCarriersOwnSize) {
  struct Row {
    const char* isector;
    size_t segment;
    const char* name;
    double d0;
  };
  for (const Row& row :
       {Row{"B1", 2, "+Y", 0.12}, Row{"B3", 4, "+Z", 0.105}, Row{"B4", 5, "-Z", 0.105},
        Row{"B5", 0, "l1", 0.085}, Row{"B5", 2, "l3", 0.30}, Row{"B6", 0, "l4", 0.02},
        Row{"B6", 1, "l5", 0.14}, Row{"B6", 2, "l6", 0.30}, Row{"B7", 0, "l7", 0.14},
        Row{"B7", 2, "l9", 0.14}}) {
    const auto index = static_cast<size_t>(FindIsector(Robot(), row.isector));
    const SegmentSpec& segment = Robot().isectors[index].segments[row.segment];
    EXPECT_EQ(segment.name, row.name);
    EXPECT_DOUBLE_EQ(segment.d0, row.d0) << row.isector << row.name;
    EXPECT_GE(segment.length, segment.d0 + 0.1) << row.isector << row.name;
  }
}

TEST(RobotModel, TripodReachesFromTheStepLimitDownToTheFallSearch) {
  const auto index = static_cast<size_t>(FindIsector(Robot(), "TRIPOD"));
  const IsectorSpec& tripod = Robot().isectors[index];
  ASSERT_EQ(tripod.segments.size(), 3u);
  EXPECT_EQ(tripod.class_mask, kClampProxy);
  for (const SegmentSpec& leg : tripod.segments) {
    EXPECT_DOUBLE_EQ(leg.start.z(), 0.45);
    EXPECT_DOUBLE_EQ(leg.length, 3.45);
    EXPECT_EQ(leg.direction, -Eigen::Vector3d::UnitZ());
  }
}

TEST(RobotModel, IsectorsLookForWhatTheirMethodUsuallyDoes) {
  for (const IsectorSpec& isector : Robot().isectors) {
    const bool ground = isector.method == IsectorMethod::kTripod;
    EXPECT_EQ(isector.class_mask,
              ground ? kClampProxy : kBumpProxy | kBombObject | kMovableObject | kContainmentVessel)
        << isector.name;
    EXPECT_EQ(isector.hit_rule, ground ? HitRule::kHighest : HitRule::kNearest) << isector.name;
    EXPECT_EQ(isector.face_rule, FaceRule::kTwoSided) << isector.name;
    for (const SegmentSpec& segment : isector.segments) EXPECT_TRUE(segment.enabled);
  }
}

TEST(RobotModel, IsectorsLookAsTheFileTellsThem) {
  EditedFile file(EOD_DATA_DIR "/sim/robots/eod_robot.sdf");
  file.Replace("name=\"B1\"",
               "name=\"B1\" face=\"front_only\" hit=\"all\" classes=\"bomb vessel\"");
  file.Replace("name=\"l4\"", "name=\"l4\" enabled=\"false\"");
  file.Replace("name=\"front_right\"", "name=\"front_right\" enabled=\"false\"");
  const RobotModel robot = LoadRobot(file.file());
  const IsectorSpec& b1 = robot.isectors[FindIsector(robot, "B1")];
  EXPECT_EQ(b1.face_rule, FaceRule::kFrontOnly);
  EXPECT_EQ(b1.hit_rule, HitRule::kAll);
  EXPECT_EQ(b1.class_mask, kBombObject | kContainmentVessel);
  EXPECT_FALSE(robot.isectors[FindIsector(robot, "B6")].segments[0].enabled);
  EXPECT_TRUE(robot.isectors[FindIsector(robot, "B6")].segments[1].enabled);
  EXPECT_FALSE(robot.isectors[FindIsector(robot, "TRIPOD")].segments[1].enabled);
}

TEST(RobotModel, HasFourCamerasThatLookWhereTheyShould) {
  RobotState state = HomeState(Robot());
  state.joint[kCameraTilt] = 0;
  std::vector<Eigen::Isometry3d> X_WL;
  LinkPoses(Robot(), state, X_WL);
  ASSERT_EQ(Robot().cameras.size(), 4u);
  for (const CameraSpec& camera : Robot().cameras) {
    const Eigen::Isometry3d X_WC = X_WL[static_cast<size_t>(camera.link)] * camera.X_LC;
    const Eigen::Vector3d forward = X_WC.linear().col(1), up = X_WC.linear().col(2);
    const double sign = camera.name == "rear" ? -1 : 1;
    // The hand is level at home; its camera looks down to the fingers.
    const double level = camera.name == "gripper" ? std::cos(12 * kDegree) : 1;
    EXPECT_NEAR(forward.y(), sign * level, 1e-9) << camera.name;
    EXPECT_NEAR(up.z(), level, 1e-9) << camera.name;
    EXPECT_LE(forward.z(), 1e-9) << camera.name;
    if (camera.name == "drive") {
      EXPECT_LT((X_WC.translation() - Eigen::Vector3d(0, 0.45, 0.40)).norm(), 1e-12);
      EXPECT_NEAR(camera.horizontal_fov, 75 * kDegree, 1e-9);
    }
    if (camera.name == "mast") {
      EXPECT_NEAR(X_WC.translation().z(), 1.20, 1e-12);
    }
  }
}

TEST(RobotModel, UndersideReachesFromTrackToTrackAndFlipperToFlipper) {
  std::vector<Eigen::Isometry3d> X_ML;
  RobotState state = HomeState(Robot());
  state.joint[kFrontFlipper] = state.joint[kRearFlipper] = 0;
  LinkPoses(Robot(), state, X_ML);
  Eigen::AlignedBox3d box;
  double lowest_of_flippers = 1;
  for (const SupportPoint& point : Robot().stance.points) {
    const Eigen::Vector3d p_M = X_ML[static_cast<size_t>(point.link)] * point.p_L;
    box.extend(p_M);
    EXPECT_NEAR(point.n_L.norm(), 1, 1e-12);
    if (point.link != 0) lowest_of_flippers = std::min(lowest_of_flippers, p_M.z());
  }
  // Small wheels of 0.10 m on flippers of 0.40 m, on axles at 0.375 m, 0.20 m high.
  EXPECT_NEAR(box.max().y(), 0.375 + 0.40 + 0.10, 1e-9);
  EXPECT_NEAR(box.min().y(), -box.max().y(), 1e-9);
  EXPECT_NEAR(box.max().x(), 0.30, 1e-9);
  EXPECT_NEAR(box.min().z(), 0, 1e-9);
  EXPECT_NEAR(lowest_of_flippers, 0.20 - 0.10, 1e-9);
}

TEST(RobotModel, FrictionIsThatOfTheStatedSlopeLimit) {
  EXPECT_NEAR(Robot().stance.friction, std::tan(40 * kDegree), 1e-9);
}

}  // namespace
}  // namespace eod::sim
