#include <gtest/gtest.h>

#include "tests/unit/behaviour/terrain.h"

namespace eod::sim {
namespace {

constexpr double kFoot = 1.5;  // [m] the first riser
constexpr int kSteps = 10;
constexpr uint32_t kFrontWheels = 0b11;

struct Flight {
  double rise, run;  // [m]
  double angle_deg() const { return std::atan(rise / run) / kDegree; }
  double last_nosing() const { return kFoot + (kSteps - 1) * run; }
  double top() const { return kSteps * rise; }
};

class Stair : public ::testing::TestWithParam<Flight> {
 protected:
  Driver driver_{Stairs(GetParam().rise, GetParam().run, kSteps, kFoot)};

  Stair() { driver_.command.speed_range = 0; }

  void ReadyToClimb() {
    driver_.Flipper(kFrontFlipper, 45);
    driver_.Flipper(kRearFlipper, 0);
  }
  /// All of the robot on the nosings.
  bool IsOnTheFlight(const RobotState& state) const {
    return state.position.y() > kFoot + 0.55 && state.position.y() < GetParam().last_nosing() - 0.6;
  }
};

/// How much the pitch changes from step to step, and from picture to picture (40 ms).
struct PitchWatch {
  std::vector<double> pitch_deg;
  double step = 0, picture = 0;

  void Add(double degrees) {
    pitch_deg.push_back(degrees);
    const size_t n = pitch_deg.size();
    if (n > 1) step = std::max(step, std::abs(degrees - pitch_deg[n - 2]));
    if (n > 10) picture = std::max(picture, std::abs(degrees - pitch_deg[n - 11]));
  }
};

TEST_P(Stair, TouchedRiserStopsTheRobotUntilTheFlipperIsRaised) {
  driver_.Flipper(kRearFlipper, 0);
  ASSERT_TRUE(driver_.Hold({kFrontFlipperDown}, 10, [](const StepResult& result) {
    return result.contact_parts == kFrontWheels;
  }));
  EXPECT_FALSE(driver_.DriveTo(kFoot, kDriveForward, 20));
  EXPECT_EQ(driver_.dut.last().contact_parts, kFrontWheels);
  EXPECT_TRUE(driver_.dut.alarms().IsActive(AlarmCode::kCollision));
  driver_.Press({kDriveForward});
  EXPECT_EQ(driver_.Step().inhibited & SetOf(kDriveForward), SetOf(kDriveForward));
  EXPECT_EQ(driver_.dut.last().inhibit_reason, kReasonCollision);
  // Wheels of 0.10 m with their skin of 0.02 m, 0.775 m ahead: before the riser.
  EXPECT_LT(driver_.state().position.y(), kFoot - 0.775);
  driver_.Flipper(kFrontFlipper, 45);
  EXPECT_EQ(driver_.dut.last().inhibited, 0u);
  EXPECT_TRUE(driver_.DriveTo(kFoot + 1));
  EXPECT_NEAR(driver_.pitch_deg(), GetParam().angle_deg(), 0.01);
}

TEST_P(Stair, IsClimbedAlongTheNosingLineWithoutJumps) {
  ReadyToClimb();
  PitchWatch everywhere, flight;
  driver_.watch = [&](const StepResult& result) {
    const double degrees = result.state.attitude.pitch / kDegree;
    everywhere.Add(degrees);
    if (!IsOnTheFlight(result.state)) return;
    flight.Add(degrees);
    ASSERT_NEAR(degrees, GetParam().angle_deg(), 0.05);
    ASSERT_EQ(result.inhibited, 0u);
  };
  ASSERT_TRUE(driver_.DriveTo(GetParam().last_nosing() + 1.5));
  driver_.Rest();
  EXPECT_NEAR(driver_.state().position.z(), GetParam().top(), 1e-6);
  EXPECT_LT(everywhere.step, 1.0);
  EXPECT_LT(flight.step, 1.0);
  EXPECT_LT(flight.picture, 1.0);
  EXPECT_GT(flight.pitch_deg.size(), 1000u);
}

TEST_P(Stair, IsGoneDownBackwards) {
  ReadyToClimb();
  ASSERT_TRUE(driver_.DriveTo(GetParam().last_nosing() + 1.5));
  PitchWatch everywhere;
  driver_.watch = [&](const StepResult& result) {
    everywhere.Add(result.state.attitude.pitch / kDegree);
    ASSERT_EQ(result.inhibited, 0u);
  };
  ASSERT_TRUE(driver_.DriveTo(0, kDriveReverse));
  driver_.Rest();
  EXPECT_NEAR(driver_.state().position.z(), 0, 1e-6);
  EXPECT_LT(everywhere.step, 1.0);
}

TEST_P(Stair, LoweredFlippersBreakTheFallOnTheLanding) {
  const auto hardest_tip = [this](double front_deg) {
    Driver driver(Stairs(GetParam().rise, GetParam().run, kSteps, kFoot));
    driver.command.speed_range = 0;
    driver.Flipper(kFrontFlipper, 45);
    driver.Flipper(kRearFlipper, 0);
    driver.DriveTo(GetParam().last_nosing() - 0.3);
    driver.Flipper(kFrontFlipper, front_deg);
    double fastest = 0;
    driver.watch = [&](const StepResult& result) {
      fastest = std::max(fastest, result.state.fall_speed);
    };
    EXPECT_TRUE(driver.DriveTo(GetParam().last_nosing() + 1.5));
    return fastest;
  };
  EXPECT_LT(hardest_tip(-40), hardest_tip(45) - 0.1);
}

TEST_P(Stair, StandsStillOnTheFlight) {
  ReadyToClimb();
  driver_.DriveTo(kFoot + 1);
  driver_.Rest();
  const RobotState stands = driver_.state();
  driver_.Hold({}, 3);
  EXPECT_EQ(driver_.state(), stands);
  EXPECT_TRUE(stands.at_rest);
}

INSTANTIATE_TEST_SUITE_P(Stairs, Stair,
                         ::testing::Values(Flight{0.150, 0.300}, Flight{0.165, 0.280},
                                           Flight{0.175, 0.260}),
                         [](const auto& flight) {
                           return std::to_string(std::lround(flight.param.rise * 1000)) + "by" +
                                  std::to_string(std::lround(flight.param.run * 1000));
                         });

}  // namespace
}  // namespace eod::sim
