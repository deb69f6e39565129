#include "sim/scenario/catalogue.h"

#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace eod::sim {
namespace {

using ::testing::ElementsAre;
using ::testing::EndsWith;
using ::testing::HasSubstr;

/// A folder of scenarios that is there during a test.
class CatalogueTest : public ::testing::Test {
 protected:
  CatalogueTest()
      : folder_(std::filesystem::path(::testing::TempDir()) /
                ::testing::UnitTest::GetInstance()->current_test_info()->name()) {
    std::filesystem::remove_all(folder_);
    std::filesystem::create_directories(folder_);
  }
  ~CatalogueTest() override { std::filesystem::remove_all(folder_); }
  CatalogueTest(const CatalogueTest&) = delete;
  CatalogueTest& operator=(const CatalogueTest&) = delete;

  void Write(const std::string& file, const std::string& name, int module, int difficulty,
             const std::string& more = "") const {
    std::ofstream(folder_ / file) << "name = '" << name << "'\nmodule = " << module
                                  << "\ndifficulty = " << difficulty << "\n"
                                  << more;
  }
  template <typename Function>
  std::string ErrorOf(Function function) const {
    try {
      function();
    } catch (const std::runtime_error& error) {
      return error.what();
    }
    return "no error";
  }

  std::filesystem::path folder_;
};

TEST_F(CatalogueTest, IsSortedByModuleDifficultyAndName) {
  Write("1.toml", "walk", 3, 1);
  Write("2.toml", "swim", 1, 5);
  Write("3.toml", "run", 1, 2);
  Write("4.toml", "hop", 1, 2);
  std::ofstream(folder_ / "notes.txt") << "no scenario";
  std::vector<std::string> names;
  for (const Scenario& one : LoadCatalogue(folder_)) names.push_back(one.name);
  EXPECT_THAT(names, ElementsAre("hop", "run", "swim", "walk"));
}

TEST_F(CatalogueTest, NameGivenTwiceIsRefusedWithBothFiles) {
  Write("a.toml", "same", 1, 1);
  Write("b.toml", "same", 2, 1);
  EXPECT_EQ(ErrorOf([&] { LoadCatalogue(folder_); }), (folder_ / "b.toml").string() +
                                                          ": name 'same' is that of " +
                                                          (folder_ / "a.toml").string() + " too");
}

TEST_F(CatalogueTest, BrokenFileIsNamedWithItsLine) {
  Write("a.toml", "a", 1, 9);
  EXPECT_EQ(ErrorOf([&] { LoadCatalogue(folder_); }),
            (folder_ / "a.toml").string() + ":3: difficulty = 9, allowed 1 .. 5");
  EXPECT_THAT(ErrorOf([&] { LoadCatalogue(folder_ / "none"); }),
              EndsWith("none: no such folder of scenarios"));
}

TEST_F(CatalogueTest, ScenarioIsFoundByNameOrFile) {
  Write("a.toml", "first_drive", 1, 1);
  Write("b.toml", "night_drive", 1, 3);
  EXPECT_EQ(LoadScenario("night_drive", folder_).difficulty, 3);
  EXPECT_EQ(LoadScenario((folder_ / "a.toml").string(), folder_).name, "first_drive");
  EXPECT_EQ(ErrorOf([&] { LoadScenario("night_drvie", folder_); }),
            "scenario 'night_drvie' is unknown; did you mean 'night_drive'?");
  EXPECT_EQ(ErrorOf([&] { LoadScenario("elsewhere.toml", folder_); }),
            "elsewhere.toml: no such scenario file");
}

TEST_F(CatalogueTest, TableTellsWhatAnInstructorChoosesBy) {
  Write("a.toml", "night_drive", 1, 3, R"(title = 'Drive by night'
par_time_s = 480
[weather]
light = 'night'
rain_mm_per_h = 2
[link]
kind = 'radio'
commands = { delay_ms = 200 }
[[fault]]
kind = 'camera_dead'
target = 'mast'
at_s = 60
)");
  const std::string table = DescribeCatalogue(LoadCatalogue(folder_));
  EXPECT_THAT(table, HasSubstr("night_drive "));
  EXPECT_THAT(table, HasSubstr(" flat "));
  EXPECT_THAT(table, HasSubstr(" 480 "));
  EXPECT_THAT(table, HasSubstr("night, rain 2 mm/h"));
  EXPECT_THAT(table, HasSubstr("radio, 200 ms"));
  EXPECT_THAT(table, EndsWith(" 1  Drive by night\n"));
}

}  // namespace
}  // namespace eod::sim
