// What a scenario file says about its score.
#include <fstream>
#include <numbers>

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include "tests/unit/score/judged.h"

namespace eod::sim {
namespace {

constexpr double kDegree = std::numbers::pi / 180;

class ScenarioText : public ::testing::Test {
 protected:
  ~ScenarioText() override { std::filesystem::remove(file_); }
  Scenario Load(const std::string& text) {
    std::ofstream(file_) << "name = 'a'\nmodule = 1\n" + text;
    return LoadScenario(file_);
  }
  /// Without the file's name.
  std::string Error(const std::string& text) {
    try {
      Load(text);
    } catch (const std::runtime_error& error) {
      return std::string(error.what()).substr(file_.string().size() + 1);
    }
    return "accepted";
  }

 private:
  std::filesystem::path file_ = std::filesystem::path(::testing::TempDir()) /
                                ("score_specs_" + std::to_string(getpid()) + ".toml");
};

TEST_F(ScenarioText, PrecisionIsReadInItsUnits) {
  const Scenario dut = Load(R"(
[[precision]]
kind = "path_error"
points_m = [[0, 1], [2, 3.5]]
best_m = 0.05
worst_m = 0.4
weight = 2
step = 3
box_m = [-1, -2, 3, 4]
[[precision]]
kind = "heading_error"
text = "Straight"
heading_deg = 90
best_deg = 1
worst_deg = 8
[[precision]]
kind = "contacts"
objects = ["a", "b"]
best = 0
worst = 5
)");
  ASSERT_EQ(dut.precision.size(), 3u);
  const PrecisionSpec& path = dut.precision[0];
  EXPECT_EQ(path.kind, PrecisionSpec::Kind::kPathError);
  EXPECT_EQ(path.points.at(1), Eigen::Vector2d(2, 3.5));
  EXPECT_EQ(path.weight, 2);
  EXPECT_EQ(path.step, 3);
  EXPECT_EQ(path.box.value(), Eigen::Vector4d(-1, -2, 3, 4));
  EXPECT_NEAR(dut.precision[1].heading, 90 * kDegree, 1e-12);
  EXPECT_NEAR(dut.precision[1].worst, 8 * kDegree, 1e-12);
  EXPECT_EQ(dut.precision[1].text, "Straight");
  EXPECT_EQ(dut.precision[2].objects, (std::vector<std::string>{"a", "b"}));
  EXPECT_EQ(dut.precision[2].worst, 5);
}

TEST_F(ScenarioText, ProcedureAndTiltAreRead) {
  const Scenario dut = Load(R"(
[[procedure]]
kind = "lamp_test"
before_step = 2
[[procedure]]
kind = "retreat_before_fire"
distance_m = 1.5
text = "Back off"
[score]
tilt_deg = 38
)");
  ASSERT_EQ(dut.procedure.size(), 2u);
  EXPECT_EQ(dut.procedure[0].kind, ProcedureSpec::Kind::kLampTest);
  EXPECT_EQ(dut.procedure[0].before_step, 2);
  EXPECT_EQ(dut.procedure[1].distance, 1.5);
  EXPECT_EQ(dut.procedure[1].text, "Back off");
  EXPECT_NEAR(dut.rubric.tilt, 38 * kDegree, 1e-12);
}

TEST_F(ScenarioText, MistakesAreNamedWithTheirLine) {
  const std::string precision = "[[precision]]\n";
  EXPECT_EQ(Error(precision + "kind = 'path_eror'\n"),
            "4: kind = 'path_eror' is unknown; did you mean 'path_error'?");
  EXPECT_EQ(Error(precision + "kind = 'tilt_peak'\nbest_dg = 1\nworst_deg = 2\n"),
            "5: unknown key 'best_dg'; did you mean 'best_deg'?");
  EXPECT_EQ(Error(precision + "kind = 'tilt_peak'\nbest_deg = 2\nworst_deg = 2\n"),
            "3: precision 'tilt_peak': best and worst are both " + fmt::format("{}", 2 * kDegree));
  EXPECT_EQ(
      Error(precision + "kind = 'path_error'\nbest_m = 0\nworst_m = 1\npoints_m = [[1, 2]]\n"),
      "3: precision 'path_error' needs points_m = [[x, y], [x, y], ...]");
  EXPECT_EQ(Error(precision + "kind = 'path_error'\nbest_m = 0\nworst_m = 1\npoints_m = [1, 2]\n"),
            "7: 'points_m' has to be a list of points [x, y] within -3000 .. 3000");
  EXPECT_EQ(Error(precision + "kind = 'contacts'\nbest = 0\nworst = 1\nobjects = [1]\n"),
            "7: 'objects' has to be a list of texts");
  EXPECT_EQ(Error(precision + "kind = 'contacts'\nbest = 0\nworst = 1\nbox_m = [1, 0, 0, 1]\n"),
            "7: box_m has to be [x0, y0, x1, y1] with x0 < x1, y0 < y1");
  EXPECT_EQ(Error("[[procedure]]\nkind = 'lamp_tset'\n"),
            "4: kind = 'lamp_tset' is unknown; did you mean 'lamp_test'?");
  EXPECT_EQ(Error("[[procedure]]\nkind = 'retreat_before_fire'\n"),
            "3: key 'distance_m' is missing");
}

TEST_F(ScenarioText, ShippedOnesFitTheirModules) {
  const WorldModel world = LoadWorld(kData / "sim/worlds/training_ground.sdf");
  for (const auto& entry : std::filesystem::directory_iterator(kData / "sim/scenarios")) {
    const Scenario scenario = LoadScenario(entry.path());
    EXPECT_NO_THROW(Scorer(scenario, world.Module(scenario.module), TheRules())) << entry.path();
  }
}

}  // namespace
}  // namespace eod::sim
