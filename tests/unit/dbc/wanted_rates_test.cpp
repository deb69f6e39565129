#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "dbc/control_map.h"
#include "tests/unit/dbc/samples.h"

namespace eod::dbc {
namespace {

class WantedRatesTest : public testing::Test {
 protected:
  static void SetUpTestSuite() { map_ = new ControlMap(LoadControlMap(ShippedMapFile())); }
  static void TearDownTestSuite() { delete map_; }

  double Rate(int motion) const {
    return WantedRates(*map_, panel_)[static_cast<size_t>(motion - 1)];
  }
  double Sum() const {
    double sum = 0;
    for (const double rate : WantedRates(*map_, panel_)) sum += rate;
    return sum;
  }

  static const ControlMap* map_;
  PanelState panel_;
};
const ControlMap* WantedRatesTest::map_ = nullptr;

TEST_F(WantedRatesTest, NothingHeldWantsNothing) { EXPECT_EQ(Sum(), 0); }

TEST_F(WantedRatesTest, ButtonsGiveTheJointRateAndDriveButtonsFullSpeed) {
  panel_.joint_rate = 0.4;
  panel_.motion[0] = true;  // M01
  panel_.motion[8] = true;  // M09
  EXPECT_EQ(Rate(1), 1);
  EXPECT_EQ(Rate(9), 0.4);
  panel_.speed_limit = 0.5;
  EXPECT_EQ(Rate(1), 0.5);
  EXPECT_EQ(Rate(9), 0.2);
}

TEST_F(WantedRatesTest, SticksBeginBeyondTheDeadZoneAndEndAtFullRate) {
  panel_.axis[0].value = 0.05;
  EXPECT_EQ(Rate(1), 0);
  panel_.axis[0].value = 0.525;  // half way from 0.05 to 1
  EXPECT_NEAR(Rate(1), 0.5, 1e-12);
  panel_.axis[0].value = 1;
  EXPECT_EQ(Rate(1), 1);
  EXPECT_EQ(Rate(2), 0);
  panel_.axis[0].value = -1;
  EXPECT_EQ(Rate(1), 0);
  EXPECT_EQ(Rate(2), 1);
}

TEST_F(WantedRatesTest, TheModeDecidesWhatAStickMoves) {
  panel_.axis[2].value = 1;  // right stick forward
  for (const auto& [mode, motion] :
       {std::pair(ControlMode::kArm, 9), std::pair(ControlMode::kFlipper, 7),
        std::pair(ControlMode::kCamera, 21)}) {
    panel_.mode = mode;
    EXPECT_EQ(Rate(motion), 1);
    EXPECT_EQ(Sum(), 1);
  }
  for (const ControlMode mode :
       {ControlMode::kNone, ControlMode::kPreset, ControlMode::kNotAvailable}) {
    panel_.mode = mode;
    EXPECT_EQ(Sum(), 0);
  }
}

TEST_F(WantedRatesTest, TheLargerOfButtonAndStickCounts) {
  panel_.mode = ControlMode::kArm;
  panel_.joint_rate = 0.3;
  panel_.motion[8] = true;  // M09
  panel_.axis[2].value = 0.2;
  EXPECT_EQ(Rate(9), 0.3);
  panel_.axis[2].value = 1;
  EXPECT_EQ(Rate(9), 1);
}

TEST_F(WantedRatesTest, OppositeButtonsAreBothKept) {
  panel_.motion[0] = panel_.motion[1] = true;
  EXPECT_EQ(Rate(1), 1);
  EXPECT_EQ(Rate(2), 1);
}

TEST_F(WantedRatesTest, AnyDoubtIsNoMotion) {
  panel_.axis[0] = {1, false};
  EXPECT_EQ(Sum(), 0);
  panel_.axis[0] = {std::nan(""), true};
  EXPECT_EQ(Sum(), 0);
  panel_.axis[0] = {};
  panel_.motion[8] = true;
  panel_.joint_rate = std::nan("");
  EXPECT_EQ(Sum(), 0);
  panel_.joint_rate = -1;
  EXPECT_EQ(Sum(), 0);
  panel_.joint_rate = 1;
  panel_.speed_limit = std::nan("");
  EXPECT_EQ(Sum(), 0);
  panel_.speed_limit = 1;
  panel_.button_channel_fault = true;
  EXPECT_EQ(Sum(), 0);
}

TEST_F(WantedRatesTest, IsNeverMoreThanFullRate) {
  panel_.axis[0].value = 7;
  panel_.motion[8] = true;
  panel_.joint_rate = std::numeric_limits<double>::infinity();
  panel_.speed_limit = 3;
  EXPECT_EQ(Rate(1), 1);
  EXPECT_EQ(Rate(9), 1);
}

}  // namespace
}  // namespace eod::dbc
