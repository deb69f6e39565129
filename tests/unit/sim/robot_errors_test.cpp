#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sim/robot/robot_model.h"
#include "tests/unit/sim/edited_file.h"

namespace eod::sim {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

class RobotErrors : public ::testing::Test {
 protected:
  EditedFile robot_{EOD_DATA_DIR "/sim/robots/eod_robot.sdf"};

  std::string Load() {
    try {
      LoadRobot(robot_.file());
    } catch (const std::runtime_error& error) {
      EXPECT_THAT(error.what(), Not(HasSubstr("\n"))) << "one line";
      return error.what();
    }
    return "loaded";
  }
};

TEST_F(RobotErrors, UnchangedCopyLoads) {
  robot_.Replace("eod_robot", "eod_robot");
  EXPECT_EQ(Load(), "loaded");
}

TEST_F(RobotErrors, MissingFileIsNamed) {
  EXPECT_THAT([] { LoadRobot("/nowhere/robot.sdf"); },
              testing::ThrowsMessage<std::runtime_error>("/nowhere/robot.sdf: cannot be read"));
}

TEST_F(RobotErrors, BrokenXmlNamesTheLine) {
  const std::string place = robot_.Replace("</visual>", "</visuall>");
  // The parser reports the element that is closed wrongly, by the line where it starts.
  EXPECT_THAT(Load(), AllOf(StartsWith(robot_.PlaceOf("<visual name")), HasSubstr("broken XML")))
      << place;
}

TEST_F(RobotErrors, BadNumberOfSdfNamesTheLine) {
  const std::string place = robot_.Replace("<size>0.15 ", "<size>wide ");
  EXPECT_THAT(Load(), AllOf(StartsWith(place), HasSubstr("<size>wide ")));
}

TEST_F(RobotErrors, BadNumberOfOurOwnNamesTheLine) {
  const std::string place = robot_.Replace("d0=\"0.12\"", "d0=\"0.1.2\"");
  EXPECT_THAT(Load(),
              AllOf(StartsWith(place), HasSubstr("d0 = \"0.1.2\""), HasSubstr("needs 1 number")));
}

TEST_F(RobotErrors, NumberOutOfRangeNamesWhatIsAllowed) {
  const std::string place = robot_.Replace("low_mps=\"0.3\"", "low_mps=\"30\"");
  EXPECT_THAT(Load(), AllOf(StartsWith(place), HasSubstr("low_mps = 30"), HasSubstr("0.01..5")));
}

TEST_F(RobotErrors, MissingJointIsNamed) {
  robot_.Replace(
      "<eod:motion index=\"5\" positive=\"M13\" negative=\"M14\" home_deg=\"30\" "
      "accel_deg_per_s2=\"80\"/>",
      "");
  EXPECT_THAT(Load(), AllOf(StartsWith(robot_.PlaceOf("<model")), HasSubstr("8 joints carry"),
                            HasSubstr("9 x 2 + 4 = 22"), HasSubstr("missing: J5")));
}

TEST_F(RobotErrors, TwoJointsOfOneNumberAreRefused) {
  const std::string place = robot_.Replace("<eod:motion index=\"5\"", "<eod:motion index=\"4\"");
  EXPECT_THAT(Load(), AllOf(StartsWith(place), HasSubstr("J4 is J4_small_arm already")));
}

TEST_F(RobotErrors, TenthJointIsRefused) {
  const std::string place = robot_.Replace("<eod:motion index=\"9\"", "<eod:motion index=\"10\"");
  EXPECT_THAT(Load(), AllOf(StartsWith(place), HasSubstr("index = 10"), HasSubstr("1..9")));
}

TEST_F(RobotErrors, MotionsThatAreNoPairAreRefused) {
  const std::string place = robot_.Replace("negative=\"M14\"", "negative=\"M15\"");
  EXPECT_THAT(Load(), AllOf(StartsWith(place), HasSubstr("M13 and M15 are no pair")));
}

TEST_F(RobotErrors, SharedMotionIsRefused) {
  robot_.Replace("positive=\"M13\" negative=\"M14\"", "positive=\"M11\" negative=\"M12\"");
  EXPECT_THAT(Load(), HasSubstr("two joints share a motion"));
}

TEST_F(RobotErrors, UnknownElementOfOursIsRefused) {
  const std::string place = robot_.Replace("<eod:chassis", "<eod:turret/><eod:chassis");
  EXPECT_THAT(Load(), AllOf(StartsWith(place), HasSubstr("unknown element <eod:turret>"),
                            HasSubstr("eod:chassis")));
}

TEST_F(RobotErrors, UnknownAttributeOfOursIsRefused) {
  const std::string place = robot_.Replace("skin=\"0.02\"", "skim=\"0.02\"");
  EXPECT_THAT(Load(),
              AllOf(StartsWith(place), HasSubstr("unknown attribute skim"), HasSubstr("skin")));
}

TEST_F(RobotErrors, UnknownElementOfSdfIsRefused) {
  const std::string place = robot_.Replace("<geometry><mesh>", "<geometri/><geometry><mesh>");
  EXPECT_THAT(Load(), AllOf(StartsWith(place), HasSubstr("geometri")));
}

TEST_F(RobotErrors, UnknownFaceRuleNamesTheTwo) {
  const std::string place = robot_.Replace("name=\"B1\"", "name=\"B1\" face=\"back_only\"");
  EXPECT_EQ(Load(), place + "face = \"back_only\" of <eod:isector>: allowed two_sided, front_only");
}

TEST_F(RobotErrors, UnknownHitRuleNamesTheThree) {
  const std::string place = robot_.Replace("name=\"B1\"", "name=\"B1\" hit=\"lowest\"");
  EXPECT_EQ(Load(), place + "hit = \"lowest\" of <eod:isector>: allowed nearest, highest, all");
}

TEST_F(RobotErrors, UnknownClassIsNamedAmongOthers) {
  const std::string place =
      robot_.Replace("name=\"B1\"", "name=\"B1\" classes=\"bump bombs vessel\"");
  EXPECT_EQ(Load(), place +
                        "classes = \"bombs\" of <eod:isector>: allowed bump, clamp, bomb, "
                        "movable, vessel");
}

TEST_F(RobotErrors, IsectorThatLooksForNothingIsRefused) {
  const std::string place = robot_.Replace("name=\"B1\"", "name=\"B1\" classes=\" \"");
  EXPECT_EQ(Load(), place +
                        "classes of <eod:isector> is empty: allowed bump, clamp, bomb, "
                        "movable, vessel");
}

TEST_F(RobotErrors, SegmentIsEnabledOrNot) {
  const std::string place = robot_.Replace("name=\"l4\"", "name=\"l4\" enabled=\"yes\"");
  EXPECT_EQ(Load(), place + "enabled = \"yes\" of <eod:segment>: allowed false, true");
}

TEST_F(RobotErrors, UnknownMethodNamesTheEight) {
  const std::string place = robot_.Replace("method=\"los\"", "method=\"laser\"");
  EXPECT_EQ(Load(), place +
                        "method = \"laser\" of <eod:isector>: allowed volume, hat, z, zpr, "
                        "xyzpr, los, tripod, bump");
}

TEST_F(RobotErrors, NumberOfSegmentsIsTheMethods) {
  const std::string place = robot_.Replace("method=\"los\"", "method=\"tripod\"");
  robot_.Replace("name=\"+Y\" direction=\"0 1 0\" length=\"10\" d0=\"0.05\" skin=\"0.05\"",
                 "name=\"+Y\"");
  EXPECT_EQ(Load(), place + "isector LOS_FRONT: 1 segments, method tripod has 3..3");
}

TEST_F(RobotErrors, TripodThatSpansNoPlaneIsRefused) {
  robot_.Replace("name=\"rear\" start=\"0 -0.375 0\"", "name=\"rear\" start=\"0 0.375 0\"");
  EXPECT_EQ(Load(), robot_.PlaceOf("<eod:isector name=\"TRIPOD\"") +
                        "isector TRIPOD: its legs stand in one line, method tripod needs a plane");
}

TEST_F(RobotErrors, UnknownMotionIsRefused) {
  const std::string place = robot_.Replace("motions=\"M02\"", "motions=\"M02 M23\"");
  EXPECT_THAT(Load(), AllOf(StartsWith(place), HasSubstr("\"M23\""), HasSubstr("M01..M22")));
}

TEST_F(RobotErrors, MissingLinkIsNamed) {
  robot_.Replace("<parent>big_arm</parent>", "<parent>boom</parent>");
  EXPECT_THAT(Load(), AllOf(StartsWith(robot_.PlaceOf("boom")), HasSubstr("boom")));
}

TEST_F(RobotErrors, MissingCameraIsNamed) {
  robot_.Replace("<sensor name=\"rear\"", "<sensor name=\"stern\"");
  EXPECT_THAT(Load(), HasSubstr("camera rear is missing"));
}

TEST_F(RobotErrors, MissingMeshIsNamed) {
  robot_.Replace("meshes/hull.obj", "meshes/hall.obj");
  EXPECT_THAT(Load(), HasSubstr("meshes/hall.obj: cannot be read"));
}

TEST_F(RobotErrors, WorldInsteadOfARobotIsRefused) {
  EXPECT_THAT([] { LoadRobot(EOD_DATA_DIR "/sim/worlds/training_ground.sdf"); },
              testing::ThrowsMessage<std::runtime_error>(HasSubstr("holds no <model>")));
}

TEST_F(RobotErrors, StanceNeedsItsNumbersWithinTheirRanges) {
  const std::string place = robot_.Replace("press_on_s=\"0.5\"", "press_on_s=\"50\"");
  EXPECT_THAT(Load(), AllOf(StartsWith(place), HasSubstr("press_on_s = 50"), HasSubstr("0..10")));
}

TEST_F(RobotErrors, SupportOfAnUnknownLinkIsNamed) {
  const std::string place =
      robot_.Replace("support link=\"rear_flipper\"", "support link=\"tail\"");
  EXPECT_THAT(Load(), AllOf(StartsWith(place), HasSubstr("\"tail\""), HasSubstr("no such link")));
}

TEST_F(RobotErrors, OutlineThatIsNoPolygonNamesWhatItNeeds) {
  const std::string place = robot_.Replace("x=\"0\" outline=\"", "x=\"0\" outline=\"0.5 ");
  EXPECT_THAT(Load(), AllOf(StartsWith(place), HasSubstr("17 numbers"), HasSubstr("y and z")));
}

}  // namespace
}  // namespace eod::sim
