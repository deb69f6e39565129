#include <cmath>
#include <vector>

#include "tests/scenario/terrain_lanes.h"

namespace eod::lockstep {
namespace {

using namespace std::chrono_literals;

constexpr double kFoot = 8;       // [m] y of every first riser
constexpr double kMark = 6.5;     // [m] y where the mission begins and ends
constexpr double kReach = 0.875;  // [m] from the robot's middle to its level flippers' ends
constexpr double kBefore = 0.2;   // [m] from its middle to a last nosing, where flippers go down
constexpr double kBeyond = 0.5;   // [m] the same on the landing, where they are raised again
constexpr double kFlipper = 0.4;  // [m] between a flipper's axles ...
constexpr double kAxleHeight = 0.15, kWheel = 0.10;  // [m] ... its inner end and its outer wheel
constexpr size_t kPicture = 40 / 4;                  // simulator steps in a picture's time

/// Pitch from picture to picture, and how far up the robot came.
class PitchWatch {
 public:
  void Watch(LockStepRig& rig) {
    rig.SetStepSink([this](const sim::StepResult& step, const sim::AlarmTable& alarms) {
      Add(step);
      pushed_on_ |= alarms.IsActive(sim::AlarmCode::kPushAfterAlarm);
    });
  }
  double greatest() const { return greatest_; }       ///< [rad] pitch
  double most_in_a_picture() const { return most_; }  ///< [rad] by which it changed in 40 ms
  double highest() const { return highest_; }         ///< [m] of the robot's middle
  double farthest() const { return farthest_; }       ///< [m] y, the same
  bool pushed_on() const { return pushed_on_; }

 private:
  void Add(const sim::StepResult& step) {
    const double pitch = step.state.attitude.pitch;
    greatest_ = std::max(greatest_, pitch);
    highest_ = std::max(highest_, step.state.position.z());
    farthest_ = std::max(farthest_, step.state.position.y());
    pitch_.push_back(pitch);
    if (pitch_.size() <= kPicture) return;
    most_ = std::max(most_, std::abs(pitch - pitch_[pitch_.size() - 1 - kPicture]));
  }

  std::vector<double> pitch_;
  double greatest_ = 0, most_ = 0, highest_ = 0, farthest_ = 0;
  bool pushed_on_ = false;
};

struct Stair {
  double x, rise, run;  ///< [m]
  int steps;            ///< of a flight
  int flights;
  double landing;  ///< [m] between two flights

  double slope() const { return std::atan2(rise, run); }
  double flight() const { return steps * std::hypot(rise, run); }
  double top() const { return flights * steps * rise; }
  /// y of the last nosing of all.
  double last_nosing() const {
    return kFoot + flights * (steps - 1) * run + (flights - 1) * landing;
  }
};

std::string Travel(std::string_view motion, double metres) {
  return fmt::format("hold {} until travel {} {} within 120s\nwait 300ms\n", motion,
                     metres < 0 ? "<=" : ">=", metres);
}

/// Lowered flippers meet the first riser, forward then does nothing; raised, they let go of it.
std::string UntilTheRiserAndFree() {
  return "speed creep\nhold M06 until joint 1 <= -7 within 9s\n"
         "hold M01 until lamp collision on within 30s\nwait 500ms\n"
         "expect reason collision\nexpect inhibit M01\n"
         "hold M01 for 2s\nexpect travel < 0.001\nexpect lamp collision on\n"
         "hold preset stair_up until joint 3 <= 60.1 within 30s\nwait 300ms\n"
         "expect lamp collision off\nexpect inhibit none\n";
}

/// Both pairs from level to their stops: the robot stands on them.
const std::string kStandUp =
    "hold M06 M08 until joint 1 <= -44.9 within 9s\n"
    "hold M08 until joint 2 <= -44.9 within 9s\nwait 300ms\n";
const std::string kSitDown = "hold M05 M07 until joint 2 >= -2.5 within 9s\nwait 300ms\n";

/// To the last nosing of a flight whose line through the nosings begins `before` ahead.
std::string ToTheNosing(const Stair& stair, double before) {
  return Travel("M01", before + stair.flight() - kBefore);
}

std::string OverTheNosing() {
  return "hold M06 until joint 1 <= 0 within 9s\n" + kStandUp + Travel("M01", kBefore + kBeyond) +
         kSitDown;
}

/// Backwards over the nosing and down, and on by `beyond` from where the line begins.
std::string DownBackwards(const Stair& stair, double beyond) {
  return kStandUp + Travel("M02", -kBefore - kBeyond) + kSitDown +
         Travel("M02", kBefore - stair.flight() - beyond);
}

std::string UpAndDown(const Stair& stair) {
  // The line through the nosings begins a run before the first riser.
  const double between = stair.landing - kBeyond - stair.run;
  std::string text = UntilTheRiserAndFree() + ToTheNosing(stair, kReach - stair.run);
  text += OverTheNosing();
  for (int i = 1; i < stair.flights; ++i) {
    text += "hold M05 until joint 1 >= 49 within 9s\nwait 300ms\n" + ToTheNosing(stair, between) +
            OverTheNosing();
  }
  text += "wait 500ms\nexpect lamp collision off\nexpect lamp tilt off\n";
  for (int i = 1; i < stair.flights; ++i) text += DownBackwards(stair, between);
  return text + DownBackwards(stair, kFoot - kMark - stair.run) + "wait 1s\n";
}

class StairDrive : public ::testing::TestWithParam<Stair> {};

TEST_P(StairDrive, UpFromTheRiserWithFlippersAndDownBackwardsWithoutJumps) {
  const Stair stair = GetParam();
  Mission dut = RunMission(ToLane(stair.x) + UpAndDown(stair), "slope_stairs");
  PitchWatch seen;
  seen.Watch(dut.rig());
  PlayScript(dut, 400s);
  EXPECT_TRUE(seen.pushed_on());
  EXPECT_LT(seen.most_in_a_picture(), 1 * kDegree);
  EXPECT_NEAR(seen.greatest(), stair.slope(), 0.5 * kDegree);
  // On the platform it stands on its flippers, pressed down by 45 deg.
  const double lift = kFlipper * std::sin(45 * kDegree) + kWheel - kAxleHeight;
  EXPECT_GT(seen.highest(), stair.top());
  EXPECT_LT(seen.highest(), stair.top() + lift + 0.01);
  // The robot bridges the foot of each flight, so its way is a little shorter there.
  EXPECT_NEAR(seen.farthest(), stair.last_nosing() + kBeyond, 0.1 * stair.flights);
  const sim::RobotState& stands = dut.rig().simulator().last().state;
  EXPECT_NEAR(stands.position.y(), kMark, 0.1);
  EXPECT_NEAR(stands.position.z(), 0, 1e-6);
  EXPECT_NEAR(stands.attitude.pitch, 0, 1e-6);
}

INSTANTIATE_TEST_SUITE_P(Stairs, StairDrive,
                         ::testing::Values(Stair{-4, 0.150, 0.300, 10, 1, 0},
                                           Stair{-8, 0.165, 0.280, 9, 1, 0},
                                           Stair{-12, 0.175, 0.260, 6, 2, 1.5}),
                         [](const auto& stair) {
                           return fmt::format("Of{:.0f}Millimetres", 1000 * stair.param.rise);
                         });

TEST(Stairs, TopTakenWithFlippersUpTipsTheRobot) {
  const Stair stair{-4, 0.150, 0.300, 10, 1, 0};
  Mission dut = RunMission(
      ToLane(stair.x) + "hold preset stair_up until joint 3 <= 60.1 within 30s\nwait 300ms\n" +
          Travel("M01", kFoot - kMark - stair.run + stair.flight() + kBeyond),
      "slope_stairs");
  PitchWatch seen;
  seen.Watch(dut.rig());
  PlayScript(dut, 300s);
  EXPECT_GT(seen.most_in_a_picture(), 2 * kDegree);
  EXPECT_NEAR(dut.rig().simulator().last().state.position.z(), stair.top(), 1e-6);
}

TEST_P(StairDrive, PresetStairDownKeepsItFromTippingBackwards) {
  const Stair stair = GetParam();
  const double way = kFoot - kMark - stair.run + stair.flight() * stair.flights +
                     (stair.flights - 1) * (stair.landing - stair.run) + kBeyond;
  Mission dut = RunMission(
      ToLane(stair.x) + "hold preset stair_up until joint 3 <= 60.1 within 30s\nwait 300ms\n" +
          "speed low\n" + Travel("M01", way) +
          "hold preset stair_down until joint 1 <= 0.1 within 30s\nwait 300ms\nspeed creep\n" +
          Travel("M02", -way) + "wait 1s\nexpect lamp tilt off\nexpect mission run\n",
      "slope_stairs");
  double backwards = 0;
  bool is_up = false;
  dut.rig().SetStepSink([&](const sim::StepResult& step, const sim::AlarmTable&) {
    is_up |= step.state.position.z() > stair.top() - 1e-6 && step.speed < 0;
    if (is_up) backwards = std::max(backwards, step.state.attitude.pitch);
  });
  PlayScript(dut, 400s);
  EXPECT_TRUE(is_up);
  // Its tail meets the stairs by flippers that go on where the tracks end.
  EXPECT_LT(backwards, stair.slope() + 5 * kDegree);
  EXPECT_NEAR(dut.rig().simulator().last().state.position.z(), 0, 1e-6);
}

TEST(Stairs, CompleteScenarioIsDrivenToSuccess) {
  Mission dut(box::LoadScript(kData / "firmware_emu/scripts/slope_stairs.boxscript"),
              ShippedScenario("slope_stairs"));
  PitchWatch seen;
  seen.Watch(dut.rig());
  PlayScript(dut, 600s);
  EXPECT_EQ(dut.rig().simulator().last().task.state, sim::MissionState::kSuccess);
  EXPECT_LT(seen.most_in_a_picture(), 1 * kDegree);
}

}  // namespace
}  // namespace eod::lockstep
