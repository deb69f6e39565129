#include "sim/stance/flipper_bearing.h"

#include <gtest/gtest.h>

#include "tests/unit/behaviour/terrain.h"

namespace eod::sim {
namespace {

constexpr double kTouch = -14.21;  // [deg] golden
constexpr uint32_t kFrontWheels = 0b11;

class Flippers : public ::testing::Test {
 protected:
  Driver driver_{Terrain().AddSlope(0, 0)};

  double front_deg() const { return driver_.state().joint[kFrontFlipper] / kDegree; }
  /// Until the wheels stop on the ground.
  void LowerFront() {
    driver_.Press({kFrontFlipperDown});
    while (driver_.Step().contact_parts == 0) {
    }
  }
};

TEST_F(Flippers, FirstTouchStopsAtTheGoldenAngleAndAlarms) {
  LowerFront();
  EXPECT_NEAR(front_deg(), kTouch, 0.08 + 0.005);
  EXPECT_EQ(driver_.dut.last().contact_parts, kFrontWheels);
  EXPECT_TRUE(driver_.dut.alarms().IsActive(AlarmCode::kCollision));
  const double stopped = front_deg();
  driver_.Hold({kFrontFlipperDown}, 0.4);  // not long enough
  driver_.Hold({}, 0.1);
  driver_.Hold({kFrontFlipperDown}, 0.4);  // nor is this: it counts anew
  EXPECT_EQ(front_deg(), stopped);
  EXPECT_EQ(driver_.pitch_deg(), 0);
}

TEST_F(Flippers, PressedOnTheyBearAndLiftTheFront) {
  LowerFront();
  driver_.Hold({kFrontFlipperDown}, 0.5);
  driver_.Hold({kFrontFlipperDown}, 0.1);
  EXPECT_FALSE(driver_.dut.alarms().IsActive(AlarmCode::kCollision));
  driver_.Hold({kFrontFlipperDown}, 3);
  EXPECT_NEAR(front_deg(), -45, 1e-6);
  // Tip of the flipper below the chassis' plane: 0.40 sin 45 deg + 0.10 - 0.20.
  const double below = 0.40 * std::sin(45 * kDegree) + 0.10 - 0.20;
  const double ahead = 0.375 + 0.375 + 0.40 * std::cos(45 * kDegree);  // of the rear belt's end
  EXPECT_NEAR(driver_.pitch_deg(), std::atan(below / ahead) / kDegree, 1.0);
  driver_.Rest();
  EXPECT_TRUE(driver_.state().at_rest);
}

TEST_F(Flippers, BothPairsLiftTheWholeRobotAndItDrivesOnThem) {
  LowerFront();
  driver_.Hold({kFrontFlipperDown, kRearFlipperDown}, 8);
  const double lifted = 0.40 * std::sin(45 * kDegree) + 0.10 - 0.20;
  EXPECT_NEAR(driver_.state().position.z(), lifted, 0.003);
  EXPECT_NEAR(driver_.pitch_deg(), 0, 0.01);
  const double y = driver_.state().position.y();
  driver_.Hold({kDriveForward}, 2);
  EXPECT_NEAR(driver_.state().position.y() - y, 0.6, 1e-3);
  EXPECT_EQ(driver_.dut.last().contact_parts, 0u);
}

TEST_F(Flippers, RaisedFromTheGroundTheyStopOnItAgain) {
  LowerFront();
  driver_.Hold({kFrontFlipperDown}, 2);
  EXPECT_GT(driver_.pitch_deg(), 1);
  driver_.Hold({kFrontFlipperUp}, 3);
  driver_.Rest();
  EXPECT_NEAR(driver_.pitch_deg(), 0, 1e-6);
  LowerFront();
  EXPECT_NEAR(front_deg(), kTouch, 0.08 + 0.005);
}

TEST_F(Flippers, PressingOnAChargeDoesNotBear) {
  RobotModel robot = TheRobot();
  const int b1 = FindIsector(robot, "B1");
  const auto& lines = robot.isectors[b1].segments;
  const auto down = std::find_if(lines.begin(), lines.end(),
                                 [](const SegmentSpec& line) { return line.name == "-Z"; });
  CastSegment cast;
  cast.isector = b1;
  cast.segment = static_cast<int>(down - lines.begin());
  cast.hit = {.hit = true, .object_class = kGround};
  const MotionSet blocks = SetOf(kFrontFlipperDown);
  EXPECT_TRUE(FlipperBearing::StopsOnGround(robot, cast, blocks));
  EXPECT_FALSE(FlipperBearing::StopsOnGround(robot, cast, 0));
  cast.hit.object_class = kModuleFlat | kBumpProxy | kBombObject;
  EXPECT_FALSE(FlipperBearing::StopsOnGround(robot, cast, blocks));
  cast.hit.object_class = kGround;
  cast.segment = 0;  // +X is no look down
  EXPECT_FALSE(FlipperBearing::StopsOnGround(robot, cast, blocks));
}

TEST(PaperFlippers, NeverBear) {
  Driver driver(Terrain().AddSlope(0, 0), {.coverage = Coverage::kPaper});
  driver.Hold({kFrontFlipperDown}, 9);
  EXPECT_NEAR(driver.state().joint[kFrontFlipper] / kDegree, kTouch, 0.08 + 0.005);
  EXPECT_EQ(driver.dut.last().contact_parts, kFrontWheels);
  EXPECT_EQ(driver.pitch_deg(), 0);
}

}  // namespace
}  // namespace eod::sim
