// Distances by the displayed speed: how far the odometer is from the truth.
#include "firmware_emu/odometer.h"

#include <algorithm>
#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include "tests/unit/firmware_emu/box_rig.h"

namespace eod::box {
namespace {

constexpr double kTick = 0.001;        // [s]
constexpr double kAcceleration = 1.0;  // [m/s^2], braking twice that
constexpr double kCycle = 0.05;        // [s] of ROB_POSE
// [m] what a straight line cuts off where acceleration begins or ends between two frames.
constexpr double kCorner = kAcceleration * kCycle * kCycle / 8;

/// A robot that drives at `speed_mps` until the odometer shows `goal_m`, and shows its speed every
/// 50 ms, rounded to 1 mm/s, `phase_ms` after the start.
struct Drive {
  double speed_mps = 0;
  double goal_m = 0;
  int phase_ms = 0;

  double path_m = 0;          ///< true path when it stands again
  double path_at_goal_m = 0;  ///< true path when the odometer showed the goal
  double shown_m = 0;         ///< by the odometer when it stands again

  void Run() {
    PanelStatus status;
    Odometer dut;
    TimePoint now = At(seconds(1000));
    status.pose_time = now;
    dut.Restart(now, status);
    double speed = 0;
    bool has_arrived = false;
    for (int ms = 1; ms < 60'000; ++ms) {
      now += milliseconds(1);
      const double before = speed;
      speed = has_arrived ? std::max(speed - 2 * kAcceleration * kTick, 0.0)
                          : std::min(speed + kAcceleration * kTick, speed_mps);
      path_m += (before + speed) / 2 * kTick;
      if ((ms - phase_ms) % 50 == 0) {
        status.feedback.speed_mps = std::round(speed * 1000) / 1000;
        status.pose_time = now;
      }
      dut.Update(now, status);
      if (!has_arrived && dut.travel_m() >= goal_m) {
        has_arrived = true;
        path_at_goal_m = path_m;
      }
      if (has_arrived && speed == 0 && status.feedback.speed_mps == 0) break;
    }
    shown_m = dut.travel_m();
  }
};

TEST(Odometer, StopsByTravelWithinMillimetresWhateverThePhaseOfTheFrames) {
  for (const double speed : {0.1, 0.3, 0.67}) {  // creep, low, high
    for (int phase = 0; phase < 50; phase += 7) {
      SCOPED_TRACE(std::to_string(speed) + " m/s, phase " + std::to_string(phase) + " ms");
      Drive drive{.speed_mps = speed, .goal_m = 1.0, .phase_ms = phase};
      drive.Run();
      EXPECT_NEAR(drive.path_at_goal_m, 1.0, kCorner + speed * kTick);
      EXPECT_NEAR(drive.shown_m, drive.path_m, 4 * kCorner) << "two corners of braking more";
    }
  }
}

TEST(Odometer, ShortMovesOfTwoCentimetresAreRightToo) {
  for (int phase = 0; phase < 50; phase += 7) {
    Drive drive{.speed_mps = 0.1, .goal_m = 0.02, .phase_ms = phase};
    drive.Run();
    EXPECT_NEAR(drive.path_at_goal_m, 0.02, kCorner + drive.speed_mps * kTick);
    EXPECT_NEAR(drive.shown_m, drive.path_m, 4 * kCorner);
  }
}

TEST(Odometer, GoesOnForAHundredMillisecondsWithoutAFrame) {
  PanelStatus status;
  Odometer dut;
  status.feedback.speed_mps = 0.5;
  status.pose_time = At(seconds(7));
  dut.Restart(At(seconds(7)), status);
  dut.Update(At(milliseconds(7040)), status);
  EXPECT_NEAR(dut.travel_m(), 0.5 * 0.04, 1e-12);
  dut.Update(At(seconds(9)), status);
  EXPECT_NEAR(dut.travel_m(), 0.5 * 0.1, 1e-12);
}

TEST(Odometer, CountsNothingAcrossABoxThatWasOff) {
  PanelStatus status;
  Odometer dut;
  status.feedback.speed_mps = 0.5;
  status.pose_time = At(seconds(7));
  dut.Restart(At(seconds(7)), status);
  dut.Update(At(seconds(8)), PanelStatus{});
  status.pose_time = At(seconds(60));
  dut.Update(At(seconds(60)), status);
  EXPECT_NEAR(dut.travel_m(), 0, 1e-12);
}

}  // namespace
}  // namespace eod::box
