#include "sim/rules/rules.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include "tests/unit/disposal/bench.h"

namespace eod::sim {
namespace {

using ::testing::StartsWith;

/// The rules that the product ships, with one place changed.
class EditedRules {
 public:
  EditedRules() {
    std::ifstream in(kData / "sim/rules/eod_rules.toml");
    text_.assign(std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>());
  }
  ~EditedRules() { std::filesystem::remove(file_); }
  EditedRules(const EditedRules&) = delete;
  EditedRules& operator=(const EditedRules&) = delete;

  /// Message of the error; "" if there is none. `line` becomes that of the change.
  std::string ErrorWith(const std::string& from, const std::string& to) {
    std::string text = text_;
    const size_t at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    text.replace(at, from.size(), to);
    line = 1 + std::count(text.begin(), text.begin() + static_cast<long>(at), '\n');
    std::ofstream(file_) << text;
    try {
      LoadRules(file_);
    } catch (const std::runtime_error& error) {
      return error.what();
    }
    return "";
  }
  std::string Place() const { return file_.string() + ":" + std::to_string(line) + ": "; }

  long line = 0;

 private:
  std::filesystem::path file_ =
      std::filesystem::path(::testing::TempDir()) / ("rules_" + std::to_string(getpid()) + ".toml");
  std::string text_;
};

TEST(Rules, AnglesAreRadiansInside) {
  EXPECT_NEAR(TheRules().charge.disturbed, 5 * kDegree, 1e-12);
  EXPECT_NEAR(TheRules().charge.unstable, 15 * kDegree, 1e-12);
  EXPECT_NEAR(TheRules().grasp.across, 20 * kDegree, 1e-12);
}

TEST(Rules, ErrorsNameFileLineAndWhatIsAllowed) {
  EditedRules rules;
  std::string error = rules.ErrorWith("pad_m = 0.005", "pad_m = -1");
  EXPECT_EQ(error, rules.Place() + "pad_m = -1, allowed 0.0001 .. 100");
  error = rules.ErrorWith("drop_m = 0.15", "dropp_m = 0.15");
  EXPECT_EQ(error, rules.Place() + "unknown key 'dropp_m'; did you mean 'drop_m'?");
  error = rules.ErrorWith("steps = 3", "steps = 2.5");
  EXPECT_THAT(error, StartsWith(rules.Place() + "'steps' has to be"));
  error = rules.ErrorWith("max_range_m = 3.0", "max_range_m = 0.1");
  EXPECT_THAT(error, StartsWith(rules.Place() + "max_range_m = 0.1, allowed 0.2"));
  error = rules.ErrorWith("touch_points = 10", "touch_points = 101");
  EXPECT_EQ(error, rules.Place() + "touch_points = 101, allowed 0 .. 100");
  EXPECT_THAT(rules.ErrorWith("[vessel]", "[wessel]"), ::testing::HasSubstr("wessel"));
}

}  // namespace
}  // namespace eod::sim
