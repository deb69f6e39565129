#include "recorder/run_folder.h"

#include <fstream>
#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace eod::recorder {
namespace {

namespace fs = std::filesystem;

class RunFolderTest : public testing::Test {
 protected:
  RunFolderTest() { fs::remove_all(root_); }
  ~RunFolderTest() override { fs::remove_all(root_); }

  static std::string Text(const fs::path& file) {
    std::ostringstream text;
    text << std::ifstream(file).rdbuf();
    return text.str();
  }

  const fs::path root_ =
      fs::path(testing::TempDir()) / testing::UnitTest::GetInstance()->current_test_info()->name();
};

TEST_F(RunFolderTest, IsMadeWithItsParents) {
  const RunFolder dut(root_ / "a" / "b");
  EXPECT_TRUE(fs::is_directory(root_ / "a" / "b" / "camera"));
  EXPECT_TRUE(fs::is_empty(root_ / "a" / "b" / "camera"));
}

TEST_F(RunFolderTest, RefusesAPlaceBehindAFileInOneLine) {
  fs::create_directories(root_);
  std::ofstream(root_ / "file") << "in the way";
  try {
    const RunFolder dut(root_ / "file" / "out");
    FAIL() << "accepted";
  } catch (const std::runtime_error& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr((root_ / "file" / "out").string()));
    EXPECT_THAT(error.what(), testing::Not(testing::HasSubstr("\n")));
  }
  EXPECT_EQ(Text(root_ / "file"), "in the way");
}

TEST_F(RunFolderTest, RemovesAnEarlierRunButNotWhatOthersPutThere) {
  const RunFolder dut(root_);
  for (const fs::path& file :
       {dut.can_log(), dut.summary(), dut.picture(1, "drive"), root_ / "notes.txt"}) {
    std::ofstream(file) << "old";
  }
  dut.RemoveEarlierRun();
  EXPECT_FALSE(fs::exists(dut.can_log()));
  EXPECT_FALSE(fs::exists(dut.summary()));
  EXPECT_FALSE(fs::exists(dut.picture(1, "drive")));
  EXPECT_EQ(Text(root_ / "notes.txt"), "old");
}

TEST_F(RunFolderTest, NamesPicturesSoThatTheySortByTime) {
  const RunFolder dut(root_);
  EXPECT_EQ(dut.picture(9.5, "mast").filename(), "0009.500-mast.jpg");
  EXPECT_LT(dut.picture(9.5, "mast"), dut.picture(10.25, "drive"));
}

TEST_F(RunFolderTest, WritesWholeFilesOnly) {
  const RunFolder dut(root_);
  WriteWhole(dut.summary(), std::string_view("{}"));
  EXPECT_EQ(Text(dut.summary()), "{}");
  EXPECT_THROW(WriteWhole(root_ / "nowhere" / "x.json", std::string_view("{}")),
               std::runtime_error);
  // The summary and the folder for pictures, no temporary.
  EXPECT_EQ(std::distance(fs::directory_iterator(root_), fs::directory_iterator()), 2);
}

}  // namespace
}  // namespace eod::recorder
