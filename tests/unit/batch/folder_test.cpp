#include <map>
#include <stdexcept>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/unit/batch/batch_setup.h"

namespace eod::batch {
namespace {

using testing::HasSubstr;

class Merging : public testing::Test {
 protected:
  static constexpr uint64_t kRepetitions = 3;

  void DriveShards(int count) {
    for (int i = 0; i < count; ++i) {
      shards_.push_back(out_ / ("shard-" + std::to_string(i)));
      Drive(exercise_.MakePlan(), kRepetitions, {.index = i, .count = count}, 2, shards_.back());
    }
  }
  std::string ErrorOfMerging() const {
    try {
      MergeFolders(shards_, out_ / "merged");
    } catch (const std::runtime_error& error) {
      return error.what();
    }
    return "no error";
  }
  static std::map<std::string, std::string> BytesOf(const std::filesystem::path& folder) {
    std::map<std::string, std::string> bytes;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
      if (!entry.is_regular_file()) continue;
      bytes[std::filesystem::relative(entry.path(), folder)] = ReadText(entry.path());
    }
    return bytes;
  }

  ShortExercise exercise_;
  ScratchFolder out_;
  std::vector<std::filesystem::path> shards_;
};

TEST_F(Merging, ShardsGiveTheBytesOfTheWholeBatch) {
  Drive(exercise_.MakePlan(), kRepetitions, {}, 2, out_ / "whole");
  DriveShards(3);
  MergeFolders(shards_, out_ / "merged");
  EXPECT_EQ(BytesOf(out_ / "merged"), BytesOf(out_ / "whole"));
}

TEST_F(Merging, TheOrderOfTheShardsDoesNotMatter) {
  DriveShards(3);
  MergeFolders(shards_, out_ / "merged");
  std::swap(shards_.front(), shards_.back());
  MergeFolders(shards_, out_ / "again");
  EXPECT_EQ(BytesOf(out_ / "merged"), BytesOf(out_ / "again"));
}

TEST_F(Merging, AMissingShardIsNamed) {
  DriveShards(3);
  shards_.erase(shards_.begin() + 1);
  EXPECT_THAT(ErrorOfMerging(), HasSubstr("5 of 15 runs are missing, the first is short.0001"));
  EXPECT_FALSE(std::filesystem::exists(out_ / "merged/results.csv"));
}

TEST_F(Merging, AnotherBatchIsRefused) {
  DriveShards(2);
  exercise_.folder().Put("scripts/short.boxscript", ShortExercise::kPowerUp);
  Drive(exercise_.MakePlan(), kRepetitions, {.index = 1, .count = 2}, 2, shards_[1]);
  EXPECT_THAT(ErrorOfMerging(), HasSubstr("shard-1: is of another batch than "));
}

TEST_F(Merging, AFolderOfNoBatchIsRefused) {
  shards_.push_back(out_ / "nothing");
  EXPECT_THAT(ErrorOfMerging(), HasSubstr("batch.json: cannot be read"));
  out_.Put("nothing/batch.json", "{}");
  EXPECT_THAT(ErrorOfMerging(), HasSubstr("batch.json: is of no batch"));
}

}  // namespace
}  // namespace eod::batch
