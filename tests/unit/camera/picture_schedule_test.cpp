#include "sim/camera/picture_schedule.h"

#include <algorithm>
#include <array>

#include <gtest/gtest.h>

#include "sim/camera/camera_choice.h"

namespace eod::sim {
namespace {

using std::chrono::milliseconds;

TimePoint At(int64_t ms) { return TimePoint{milliseconds(ms)}; }

TEST(PictureSchedule, DrawsEachCameraAtItsRate) {
  // 25 Hz is a period of 40 ms: pictures are due at 0, 40, ... 960 in a second of 4 ms steps, and
  // the one due at 1000 may be drawn a quarter of a period early, from 990 on: 26 of each.
  PictureSchedule dut(2, 25);
  std::array<int, 2> drawn{};
  for (int64_t ms = 0; ms < 1000; ms += 4) {
    while (const auto camera = dut.Due(At(ms))) {
      dut.Drawn(*camera, At(ms));
      ++drawn.at(*camera);
    }
  }
  EXPECT_EQ(drawn[0], 26);
  EXPECT_EQ(drawn[1], 26);
}

TEST(PictureSchedule, KeepsTheMeanRateWhenStepsDoNotFitThePeriod) {
  // 30 Hz on a 4 ms grid: 33.3 ms are 8 or 9 steps; 300 pictures in ten seconds all the same, and
  // the next one a little early.
  PictureSchedule dut(1, 30);
  int drawn = 0;
  for (int64_t ms = 0; ms < 10000; ms += 4) {
    if (!dut.Due(At(ms))) continue;
    dut.Drawn(0, At(ms));
    ++drawn;
  }
  EXPECT_EQ(drawn, 301);
}

TEST(PictureSchedule, LosesNoSnapshotThatComesAtItsOwnRate) {
  // Snapshots every 32 or 36 ms, on average every 33.3 ms: some come 1.3 ms before a picture is
  // due. One is missed (the camera was busy); the next must not be taken for too early.
  PictureSchedule dut(1, 30);
  for (int64_t n = 0; n < 100; ++n) {
    if (n == 10) continue;
    const TimePoint now = At(n * 100 / 3 / 4 * 4);
    EXPECT_TRUE(dut.Due(now).has_value()) << n;
    dut.Drawn(0, now);
  }
}

TEST(PictureSchedule, TakesTurnsWhenThereIsNoTimeForAll) {
  // Every snapshot is overdue for both, but only one picture is drawn of each.
  PictureSchedule dut(2, 50);
  std::array<int, 2> drawn{};
  for (int64_t ms = 0; ms < 1000; ms += 50) {
    const auto camera = dut.Due(At(ms));
    ASSERT_TRUE(camera.has_value());
    dut.Drawn(*camera, At(ms));
    ++drawn.at(*camera);
  }
  EXPECT_EQ(drawn[0], 10);
  EXPECT_EQ(drawn[1], 10);
}

TEST(PictureSchedule, DoesNotCatchUpAfterAPause) {
  PictureSchedule dut(1, 50);
  dut.Drawn(0, At(0));
  ASSERT_TRUE(dut.Due(At(1000)).has_value());
  dut.Drawn(0, At(1000));
  EXPECT_FALSE(dut.Due(At(1004)).has_value());
  EXPECT_TRUE(dut.Due(At(1020)).has_value());
}

TEST(PictureSchedule, StartsAnewWhenTimeJumpsBack) {
  PictureSchedule dut(1, 50);
  dut.Drawn(0, At(60000));
  EXPECT_TRUE(dut.Due(At(0)).has_value());
}

/// Pictures of each of four cameras in a second of snapshots at the full rate of 25 Hz.
std::array<int, 4> DrawnInASecond(PictureSchedule& dut, int64_t from_ms, int* most = nullptr) {
  std::array<int, 4> drawn{};
  for (int64_t ms = from_ms; ms < from_ms + 1000; ms += 40) {
    int now = 0;
    while (const auto camera = dut.Due(At(ms))) {
      dut.Drawn(*camera, At(ms));
      ++drawn.at(*camera);
      ++now;
    }
    if (most != nullptr) *most = std::max(*most, now);
  }
  return drawn;
}

TEST(PictureSchedule, DrawsWhatIsChosenAndNothingElse) {
  PictureSchedule dut(4, 25);
  dut.Choose(std::array{1, 0, 1, 0}, At(0));
  EXPECT_EQ(DrawnInASecond(dut, 0), (std::array{25, 0, 25, 0}));
  dut.Choose(std::array{0, 1, 1, 0}, At(1000));
  EXPECT_EQ(DrawnInASecond(dut, 1000), (std::array{0, 25, 25, 0}));
}

TEST(PictureSchedule, FourAtHalfTheRateTakeTurnsSoThatNoPictureWaitsForThree) {
  PictureSchedule dut(4, 25);
  dut.Choose(std::array{2, 2, 2, 2}, At(0));
  int most = 0;
  const std::array<int, 4> drawn = DrawnInASecond(dut, 0, &most);
  for (const int pictures : drawn) EXPECT_NEAR(pictures, 12.5, 0.5);
  EXPECT_EQ(most, 2);
}

TEST(PictureSchedule, ChoosingTheSameAgainChangesNothing) {
  PictureSchedule dut(4, 25);
  for (int64_t ms = 0; ms < 1000; ms += 4) {
    dut.Choose(std::array{2, 2, 2, 2}, At(ms));
    while (const auto camera = dut.Due(At(ms))) dut.Drawn(*camera, At(ms));
  }
  // All were drawn within the last 80 ms.
  EXPECT_FALSE(dut.Due(At(1000 - 4)).has_value());
}

TEST(PictureInterval, GivesTheFullRateToTheChosenCameraAndItsCompanion) {
  const auto intervals = [](int choice) {
    return std::array{PictureInterval(choice, "drive"), PictureInterval(choice, "gripper"),
                      PictureInterval(choice, "mast"), PictureInterval(choice, "rear")};
  };
  EXPECT_EQ(intervals(0), (std::array{0, 0, 0, 0})) << "quad";
  EXPECT_EQ(PictureInterval(0, "quad"), 1);
  EXPECT_EQ(PictureInterval(1, "quad"), 0);
  EXPECT_EQ(intervals(1), (std::array{1, 0, 1, 0})) << "drive, and the mast";
  EXPECT_EQ(intervals(2), (std::array{0, 1, 1, 0})) << "gripper, and the mast";
  EXPECT_EQ(intervals(3), (std::array{1, 0, 1, 0})) << "mast, and drive";
  EXPECT_EQ(intervals(4), (std::array{1, 0, 0, 1})) << "rear, and drive";
  EXPECT_EQ(intervals(7), intervals(1)) << "no choice";
}

}  // namespace
}  // namespace eod::sim
