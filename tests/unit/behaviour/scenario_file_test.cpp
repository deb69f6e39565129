#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sim/task/task.h"
#include "tests/unit/behaviour/fixture.h"

namespace eod::sim {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

std::string LoadError(const std::string& text) {
  const auto file = std::filesystem::path(::testing::TempDir()) / "scenario_under_test.toml";
  std::ofstream(file) << text;
  try {
    LoadScenario(file);
  } catch (const std::runtime_error& error) {
    std::string what = error.what();
    EXPECT_THAT(what, StartsWith(file.string() + ":"));
    EXPECT_EQ(what.find('\n'), std::string::npos);
    return what.substr(file.string().size() + 1);
  }
  return "no error";
}

TEST(LoadScenario, ReadsTheShippedOne) {
  const Scenario dut = LoadScenario(kData / "sim/scenarios/flat_first_drive.toml");
  EXPECT_EQ(dut.name, "flat_first_drive");
  EXPECT_EQ(dut.module, 1);
  ASSERT_EQ(dut.steps.size(), 4u);
  EXPECT_EQ(dut.steps[0].kind, TaskStep::Kind::kContact);
  EXPECT_EQ(dut.steps[1].distance, 0.5);
  EXPECT_EQ(dut.steps[2].object, "gate_1");
  EXPECT_EQ(dut.steps[3].tolerance, 0.05);
}

TEST(LoadScenario, ErrorsNameLineAndRemedy) {
  EXPECT_EQ(LoadError("name = 'a'\nmodule = 1\npar_tme_s = 3\n"),
            "3: unknown key 'par_tme_s'; did you mean 'par_time_s'?");
  EXPECT_EQ(LoadError("name = 'a'\nmodule = 7\n"), "2: module = 7, allowed 1 .. 5");
  EXPECT_EQ(LoadError("name = 'a'\nmodule = 'flat'\n"), "2: 'module' has to be a whole number");
  EXPECT_EQ(LoadError("name = 'a'\n"), "1: key 'module' is missing");
  EXPECT_THAT(LoadError("name = \n"), StartsWith("1: "));
  const std::string head = "name = 'a'\nmodule = 1\n[[step]]\n";
  EXPECT_EQ(LoadError(head + "kind = 'contract'\ntext = ''\n"),
            "4: kind = 'contract' is unknown; did you mean 'contact'?");
  EXPECT_EQ(LoadError(head + "kind = 'clear'\ntext = ''\ndistance = 1\n"),
            "6: unknown key 'distance'; did you mean 'distance_m'?");
  EXPECT_EQ(LoadError(head + "kind = 'stop_at'\ntext = ''\nobject = 'b'\ndistance_m = -1\n"),
            "7: distance_m = -1, allowed 0 .. 3000");
  EXPECT_THAT(LoadError(head + "kind = 'pass_gate'\ntext = ''\n"),
              HasSubstr("'object' is missing"));
}

TEST(LoadScenario, ReadsEveryKindWithWhatItNeeds) {
  const auto file = std::filesystem::path(::testing::TempDir()) / "scenario_of_every_kind.toml";
  std::ofstream(file) << R"(
name = 'all'
module = 3
[[step]]
kind = 'grasp'
object = 'charge_m'
text = ''
[[step]]
kind = 'lift'
distance_m = 0.2
text = ''
[[step]]
kind = 'place_in_vessel'
object = 'can'
text = ''
[[step]]
kind = 'disrupt'
text = ''
[[step]]
kind = 'climb'
x_m = 4
y_m = 11.5
distance_m = 1.5
tolerance_m = 0.5
text = ''
[[step]]
kind = 'hold_still'
time_s = 10
tilt_deg = 18
text = ''
[[step]]
kind = 'retreat'
object = 'can'
distance_m = 10
text = ''
)";
  const Scenario dut = LoadScenario(file);
  ASSERT_EQ(dut.steps.size(), 7u);
  EXPECT_EQ(dut.steps[0].kind, TaskStep::Kind::kGrasp);
  EXPECT_EQ(dut.steps[0].object, "charge_m");
  EXPECT_EQ(dut.steps[1].kind, TaskStep::Kind::kLift);
  EXPECT_EQ(dut.steps[1].distance, 0.2);
  EXPECT_EQ(dut.steps[2].kind, TaskStep::Kind::kPlaceInVessel);
  EXPECT_EQ(dut.steps[3].kind, TaskStep::Kind::kDisrupt);
  EXPECT_EQ(dut.steps[4].kind, TaskStep::Kind::kClimb);
  EXPECT_EQ(dut.steps[4].y, 11.5);
  EXPECT_EQ(dut.steps[5].kind, TaskStep::Kind::kHoldStill);
  EXPECT_EQ(dut.steps[5].time, 10);
  EXPECT_NEAR(dut.steps[5].tilt, 18 * kDegree, 1e-15);
  EXPECT_EQ(dut.steps[6].kind, TaskStep::Kind::kRetreat);
  EXPECT_EQ(dut.steps[6].distance, 10);
}

TEST(LoadScenario, StepsThatLackWhatTheirKindNeedsAreRefused) {
  const std::string head = "name = 'a'\nmodule = 3\n[[step]]\ntext = ''\n";
  EXPECT_THAT(LoadError(head + "kind = 'grasp'\n"), HasSubstr("'object' is missing"));
  EXPECT_THAT(LoadError(head + "kind = 'lift'\n"), HasSubstr("'distance_m' is missing"));
  EXPECT_THAT(LoadError(head + "kind = 'place_in_vessel'\n"), HasSubstr("'object' is missing"));
  EXPECT_THAT(LoadError(head + "kind = 'hold_still'\n"), HasSubstr("'time_s' is missing"));
  EXPECT_THAT(LoadError(head + "kind = 'climb'\ndistance_m = 1\ntolerance_m = 1\n"),
              HasSubstr("'x_m' is missing"));
  EXPECT_EQ(LoadError(head + "kind = 'hold_still'\ntime_s = 1\ntilt_deg = 91\n"),
            "7: tilt_deg = 91, allowed 0 .. 90");
  EXPECT_EQ(LoadError(head + "kind = 'graps'\n"),
            "5: kind = 'graps' is unknown; did you mean 'grasp'?");
}

TEST(LoadScenario, ReadsAreaCriticalLightsAndInspection) {
  const auto file = std::filesystem::path(::testing::TempDir()) / "scenario_with_area.toml";
  std::ofstream(file) << R"(
name = 'all'
module = 3
critical = ['detonation', 'out_of_area']
[area]
corners_m = [[-2, -1], [2, -1], [0, 20]]
[weather]
lights = ['dusk', 'night']
[[step]]
kind = 'inspect'
object = 'plate_1'
point_m = [0, 0.1, 1.1]
camera = 'mast'
distance_m = 5
time_s = 2
text = ''
[[step]]
kind = 'grasp'
object = 'charge_m'
strict = true
text = ''
)";
  const Scenario dut = LoadScenario(file);
  ASSERT_EQ(dut.area.size(), 3u);
  EXPECT_EQ(dut.area[2], Eigen::Vector2d(0, 20));
  EXPECT_TRUE(Contains(dut.critical, FailReason::kExploded));
  EXPECT_TRUE(Contains(dut.critical, FailReason::kOutOfArea));
  EXPECT_TRUE(Contains(dut.critical, FailReason::kInstructor)) << "his word always counts";
  EXPECT_FALSE(Contains(dut.critical, FailReason::kRollover));
  EXPECT_EQ(dut.weather.light, Weather::Light::kDusk);
  EXPECT_EQ(dut.lights.size(), 2u);
  EXPECT_EQ(dut.steps[0].kind, TaskStep::Kind::kInspect);
  EXPECT_EQ(dut.steps[0].point, Eigen::Vector3d(0, 0.1, 1.1));
  EXPECT_EQ(dut.steps[0].camera, 3);
  EXPECT_EQ(dut.steps[0].line, 11u);
  EXPECT_TRUE(dut.steps[1].strict);
}

TEST(LoadScenario, ErrorsOfAreaCriticalLightsAndInspectionNameLineAndRemedy) {
  const std::string head = "name = 'a'\nmodule = 3\n";
  EXPECT_EQ(LoadError(head + "critical = ['detonation',\n 'rolover']\n"),
            "4: critical: 'rolover' is unknown; did you mean 'rollover'?");
  EXPECT_EQ(LoadError(head + "critical = 'rollover'\n"), "3: 'critical' has to be a list of texts");
  EXPECT_EQ(LoadError(head + "[area]\ncorners = []\n"),
            "4: unknown key 'corners'; did you mean 'corners_m'?");
  EXPECT_EQ(LoadError(head + "[area]\ncorners_m = [[0, 0], [1, 1]]\n"),
            "4: 'corners_m' has to be a list of at least 3 points [x, y] within -3000 .. 3000");
  EXPECT_THAT(LoadError(head + "[area]\ncorners_m = [[0, 0],\n[1, 1],\n[2]]\n"),
              StartsWith("6: 'corners_m' has to be"));
  EXPECT_EQ(LoadError(head + "[weather]\nlight = 'day'\nlights = ['day']\n"),
            "5: either light or lights");
  EXPECT_EQ(LoadError(head + "[weather]\nlights = ['nigth']\n"),
            "4: lights: 'nigth' is unknown; did you mean 'night'?");
  EXPECT_EQ(LoadError(head + "[start]\nposition = [0, 0, 0]\n"),
            "4: unknown key 'position'; did you mean 'position_m'?");
  EXPECT_EQ(LoadError(head + "[[place]]\nobject = 'a'\nspread_m = [1]\n"),
            "5: 'spread_m' has to be a list of 2 numbers within 0 .. 100");
  const std::string step = head + "[[step]]\ntext = ''\n";
  EXPECT_EQ(LoadError(step + "kind = 'inspect'\nobject = 'a'\ndistance_m = 1\ntime_s = 1\n"
                             "camera = 'mats'\n"),
            "9: camera = 'mats' is unknown; did you mean 'mast'?");
  EXPECT_EQ(LoadError(step + "kind = 'grasp'\nobject = 'a'\ncamera = 'mast'\n"),
            "7: 'camera' belongs to a step 'inspect'");
  EXPECT_EQ(LoadError(step + "kind = 'hold_still'\ntime_s = 1\nstrict = true\n"),
            "7: a step 'hold_still' takes its time and cannot be strict");
}

TEST(LoadScenario, FaultsSayWhatTheirKindNeedsAndNoMore) {
  const std::string head =
      "name = 'a'\nmodule = 3\n[[step]]\nkind = 'contact'\ntext = ''\n[[fault]]\n";
  EXPECT_EQ(LoadError(head + "kind = 'camera_dead'\ntarget = 'mats'\nat_s = 1\n"),
            "8: target = 'mats' is unknown; did you mean 'mast'?");
  EXPECT_EQ(LoadError(head + "kind = 'joint_stuck'\nat_s = 1\n"), "6: key 'target' is missing");
  EXPECT_EQ(LoadError(head + "kind = 'track_weak'\ntarget = 'left'\namount = 2\nat_s = 1\n"),
            "9: amount = 2, allowed 0 .. 1");
  EXPECT_EQ(LoadError(head + "kind = 'radio_loss'\ntarget = 'drive'\nat_s = 1\n"),
            "8: a fault 'radio_loss' has no target");
  EXPECT_EQ(LoadError(head + "kind = 'stuck_button'\ntarget = 'M23'\nat_s = 1\n"),
            "8: target = 'M23' is unknown; did you mean 'M03'?");
  EXPECT_EQ(LoadError(head + "kind = 'radio_loss'\n"),
            "6: a fault begins by one of at_s, after_step, on_grasp = true");
  EXPECT_EQ(LoadError(head + "kind = 'radio_loss'\nafter_step = 2\n"),
            "8: after_step = 2, allowed 1 .. 1, the number of steps");
}

TEST(LoadScenario, MoreStepsThanTheBoxCanShowAreRefused) {
  std::string text = "name = 'a'\nmodule = 3\n";
  for (int i = 0; i < 15; ++i) text += "[[step]]\nkind = 'contact'\ntext = ''\n";
  EXPECT_EQ(LoadError(text), "no error");
  EXPECT_EQ(LoadError(text + "[[step]]\nkind = 'contact'\ntext = ''\n"),
            "48: more than 15 steps, which the box cannot show");
}

TEST(LoadScenario, MissingFileIsNamed) {
  try {
    LoadScenario("/nowhere/at.toml");
    FAIL();
  } catch (const std::runtime_error& error) {
    EXPECT_STREQ(error.what(), "/nowhere/at.toml: no such scenario file");
  }
}

}  // namespace
}  // namespace eod::sim
