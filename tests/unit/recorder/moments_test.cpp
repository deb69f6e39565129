#include "recorder/moments.h"

#include <algorithm>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace eod::recorder {
namespace {

using testing::ElementsAre;
using testing::SizeIs;

// A "picture" that tells its own time.
Jpeg PictureOf(double t) { return {static_cast<uint8_t>(t)}; }

// Pictures of one camera, ten a second, from `begin` up to `end`.
void Film(Moments& dut, double begin, double end, Camera camera = Camera::kDrive) {
  for (int i = 0; begin + 0.1 * i < end - 1e-9; ++i) {
    const double t = begin + 0.1 * i;
    dut.AddPicture(camera, t, PictureOf(t), {}, 0.1 * t);
  }
}

std::vector<std::string> Labels(const std::vector<Moment>& moments) {
  std::vector<std::string> labels;
  for (const Moment& moment : moments) labels.push_back(moment.label);
  return labels;
}

TEST(Moments, AreNoneWithoutPictures) {
  Moments dut;
  dut.Mark(1, "contact");
  EXPECT_THAT(dut.Select(9), SizeIs(0));
}

TEST(Moments, KeepTheFirstPictureAtOrAfterAMark) {
  Moments dut;
  Film(dut, 0, 15);
  dut.Mark(15.02, "contact");
  Film(dut, 15.1, 30);
  const auto moments = dut.Select(3);
  ASSERT_THAT(Labels(moments), ElementsAre("First picture", "contact", "End"));
  EXPECT_NEAR(moments[1].t, 15.1, 1e-9);
  EXPECT_NEAR(moments[1].speed_mps, 1.51, 1e-9);
}

TEST(Moments, LeaveOutFirstAndLastWhereAMarkShowsTheSame) {
  Moments dut;
  Film(dut, 0, 3);
  dut.Mark(3, "start");
  Film(dut, 3, 30);
  dut.Mark(30, "e-stop");
  Film(dut, 30, 33);
  EXPECT_THAT(Labels(dut.Select(2)), ElementsAre("start", "e-stop"));
}

TEST(Moments, DropTheClosestOfTooManyMarks) {
  Moments dut;
  for (const int t : {10, 20, 30, 32, 40}) {
    dut.Mark(t, std::to_string(t));
    Film(dut, t, t + 0.35);
  }
  EXPECT_THAT(Labels(dut.Select(4)), ElementsAre("10", "20", "30", "40"));
}

TEST(Moments, KeepWhatCameShortlyBeforeAnEvent) {
  Moments dut;
  Film(dut, 0, 20);
  dut.MarkWithApproach(20, "before", "contact");
  Film(dut, 20, 30);
  const auto moments = dut.Select(4);
  ASSERT_THAT(Labels(moments), ElementsAre("First picture", "before", "contact", "End"));
  // 5 s before; kept four times a second at most, so up to 0.3 s earlier.
  EXPECT_LE(moments[1].t, 15.0);
  EXPECT_GE(moments[1].t, 14.6);
}

TEST(Moments, DoNotTakeTheTimeBeforeAnEarlierMarkForAnApproach) {
  Moments dut;
  Film(dut, 0, 17);
  dut.Mark(17, "contact");
  Film(dut, 17, 20);
  dut.MarkWithApproach(20, "backing off", "free");
  Film(dut, 20, 21);
  EXPECT_THAT(Labels(dut.Select(3)), ElementsAre("First picture", "contact", "free"));
}

TEST(Moments, TakeMarksWithinASecondForOne) {
  Moments dut;
  Film(dut, 0, 15);
  dut.Mark(15.0, "contact");
  dut.Mark(15.4, "step done");
  Film(dut, 15, 30);
  EXPECT_THAT(Labels(dut.Select(3)), ElementsAre("First picture", "contact", "End"));
}

TEST(Moments, HoldBothCameras) {
  Moments dut;
  for (double t = 0; t < 5; t += 0.1) {
    dut.AddPicture(Camera::kDrive, t, PictureOf(t), {}, 0);
    dut.AddPicture(Camera::kMast, t + 0.01, PictureOf(t), {}, 0);
    if (t > 2.95 && t < 3.05) dut.Mark(3.0, "contact");
  }
  for (const Moment& moment : dut.Select(9)) EXPECT_THAT(moment.pictures, SizeIs(2)) << moment.t;
}

TEST(Moments, FillUpEvenly) {
  Moments dut;
  Film(dut, 0, 8.05);
  const auto moments = dut.Select(9);
  ASSERT_THAT(moments, SizeIs(9));
  EXPECT_TRUE(std::ranges::is_sorted(moments, {}, &Moment::t));
  // First at 0, last at 8: seven samples in between, one a second.
  for (size_t i = 1; i < moments.size(); ++i) {
    EXPECT_NEAR(moments[i].t - moments[i - 1].t, 1.0, 0.11);
  }
}

TEST(Moments, StayBoundedOverALongRun) {
  Moments dut;
  Film(dut, 0, 3600);
  const auto moments = dut.Select(1000);
  EXPECT_LE(moments.size(), 70U);
  EXPECT_NEAR(moments.front().t, 0, 1e-9);
  EXPECT_NEAR(moments.back().t, 3599.9, 1e-6);
}

}  // namespace
}  // namespace eod::recorder
