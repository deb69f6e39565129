// Debounce, scanner: what the firmware believes of its controls.
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "firmware_emu/debounce.h"
#include "firmware_emu/panel_scanner.h"
#include "tests/unit/firmware_emu/box_rig.h"

namespace eod::box {
namespace {

using dbc::Deadman;

class Scanner : public testing::Test {
 protected:
  const dbc::PanelState& Run(int ticks) {
    for (int i = 0; i < ticks; ++i) {
      now_ += milliseconds(1);
      dut_.Scan(now_, inputs_);
    }
    return dut_.state();
  }
  TimePoint now_{};
  PanelInputs inputs_;
  PanelScanner dut_{ScannerConfig{}};
};

TEST(Debounce, TakesAPositionOnlyAfterItRested) {
  Debounced<bool> dut(false);
  EXPECT_FALSE(dut.Update(At(milliseconds(100)), true, milliseconds(10)));
  EXPECT_FALSE(dut.Update(At(milliseconds(109)), true, milliseconds(10)));
  EXPECT_TRUE(dut.Update(At(milliseconds(110)), true, milliseconds(10)));
}

TEST(Debounce, StartsAnewWhenTheContactBounces) {
  Debounced<bool> dut(false);
  dut.Update(At(milliseconds(100)), true, milliseconds(10));
  dut.Update(At(milliseconds(105)), false, milliseconds(10));
  EXPECT_FALSE(dut.Update(At(milliseconds(110)), true, milliseconds(10)));
  EXPECT_FALSE(dut.Update(At(milliseconds(119)), true, milliseconds(10)));
  EXPECT_TRUE(dut.Update(At(milliseconds(120)), true, milliseconds(10)));
}

TEST(Debounce, BouncingContactAlternatesThenRests) {
  BouncingContact<bool> dut(false);
  std::vector<bool> seen;
  for (int ms = 100; ms < 105; ++ms) {
    seen.push_back(dut.Update(At(milliseconds(ms)), true, milliseconds(3)));
  }
  EXPECT_EQ(seen, (std::vector<bool>{true, false, true, true, true}));
}

TEST_F(Scanner, ReportsAButtonAfterTheSettleTime) {
  Run(1);
  inputs_.controls.motion[0] = true;
  EXPECT_FALSE(Run(10).motion[0]);  // first seen in the first tick, so 10 ms old in the 11th
  EXPECT_TRUE(Run(1).motion[0]);
}

TEST_F(Scanner, ABouncingButtonGivesOneCleanEdge) {
  PanelScanner dut(ScannerConfig{.bounce_time = milliseconds(6)});
  int edges = 0;
  bool last = false;
  for (int ms = 0; ms < 200; ++ms) {
    inputs_.controls.motion[4] = ms >= 50 && ms < 120;
    const bool now_down = dut.Scan(At(milliseconds(ms)), inputs_).motion[4];
    edges += now_down != last ? 1 : 0;
    last = now_down;
  }
  EXPECT_EQ(edges, 2);
}

TEST_F(Scanner, PressedEstopIsBelievedAtOnceAndItsReleaseOnlyAfterSettling) {
  Run(20);
  inputs_.estop_pressed = true;
  EXPECT_FALSE(Run(1).estop_a);
  EXPECT_TRUE(dut_.state().estop_b);
  inputs_.estop_pressed = false;
  EXPECT_FALSE(Run(10).estop_a);
  EXPECT_TRUE(Run(1).estop_a);
  EXPECT_FALSE(dut_.state().estop_b);
}

TEST_F(Scanner, LeavingTheEnabledPositionIsBelievedAtOnce) {
  inputs_.controls.deadman = Deadman::kEnabled;
  EXPECT_EQ(Run(10).deadman, Deadman::kReleased);
  EXPECT_EQ(Run(1).deadman, Deadman::kEnabled);
  inputs_.controls.deadman = Deadman::kReleased;
  EXPECT_EQ(Run(1).deadman, Deadman::kReleased);
}

TEST_F(Scanner, AfterPanicTheMiddlePositionEnablesNothingUntilLetGo) {
  inputs_.controls.deadman = Deadman::kPanic;
  EXPECT_EQ(Run(1).deadman, Deadman::kPanic);
  inputs_.controls.deadman = Deadman::kEnabled;
  EXPECT_EQ(Run(50).deadman, Deadman::kReleased);
  inputs_.controls.deadman = Deadman::kReleased;
  Run(1);
  inputs_.controls.deadman = Deadman::kEnabled;
  EXPECT_EQ(Run(11).deadman, Deadman::kEnabled);
}

TEST_F(Scanner, EstopContactsThatAgreeForMoreThan60MillisecondsAreAFault) {
  Run(1);
  inputs_.estop_a_fault = true;  // A reads pressed, B reads healthy: both 0
  EXPECT_FALSE(Run(1).estop_a);
  EXPECT_FALSE(dut_.state().estop_b);
  Run(59);
  EXPECT_FALSE(dut_.has_channel_fault());  // agreed for 60 ms
  Run(1);
  EXPECT_TRUE(dut_.has_channel_fault());
}

TEST_F(Scanner, SticksReadZeroInsideTheDeadZoneAndTheirDeflectionOutside) {
  const auto read = [this](double value) {
    inputs_.controls.axis[0].value = value;
    return Run(1).axis[0].value;
  };
  EXPECT_EQ(read(0.019), 0);
  EXPECT_EQ(read(-0.019), 0);
  // One step of the 12-bit converter is 1/2047 of full deflection.
  EXPECT_NEAR(read(0.021), 0.021, 0.5 / 2047);
  EXPECT_NEAR(read(0.5), 0.5, 0.5 / 2047);
  EXPECT_EQ(read(1.5), 1);
  EXPECT_EQ(read(-1.5), -1);
}

TEST_F(Scanner, SticksComeInStepsOfTheConverter) {
  inputs_.controls.axis[2].value = 0.3;  // 614.1 steps
  EXPECT_EQ(Run(1).axis[2].value, 614.0 / 2047);
}

TEST_F(Scanner, AStickWithoutAValueIsAFault) {
  inputs_.controls.axis[1].value = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(Run(1).axis[1].valid);
  EXPECT_EQ(dut_.state().axis[1].value, 0);
  EXPECT_TRUE(dut_.has_axis_fault());
}

TEST_F(Scanner, AButtonHeldAtTheNeutralCheckIsIgnoredUntilLetGo) {
  inputs_.controls.motion[0] = true;
  Run(20);
  dut_.CheckNeutral();
  EXPECT_FALSE(Run(100).motion[0]);
  EXPECT_TRUE(dut_.state().button_channel_fault);
  EXPECT_TRUE(dut_.has_stuck_control());
  inputs_.controls.motion[0] = false;
  Run(11);
  EXPECT_FALSE(dut_.has_stuck_control());
  inputs_.controls.motion[0] = true;
  EXPECT_TRUE(Run(11).motion[0]);
}

TEST_F(Scanner, AStickHeldAtTheNeutralCheckIsIgnoredUntilCentred) {
  inputs_.controls.axis[3].value = 0.8;
  Run(20);
  dut_.CheckNeutral();
  EXPECT_EQ(Run(10).axis[3].value, 0);
  EXPECT_TRUE(dut_.has_stuck_control());
  inputs_.controls.axis[3].value = 0;
  Run(1);
  EXPECT_FALSE(dut_.has_stuck_control());
  inputs_.controls.axis[3].value = 0.8;
  EXPECT_GT(Run(1).axis[3].value, 0.79);
}

TEST_F(Scanner, ATiedDownEnablingSwitchEnablesNothingUntilLetGo) {
  inputs_.controls.deadman = Deadman::kEnabled;
  Run(20);
  dut_.CheckNeutral();
  EXPECT_EQ(Run(50).deadman, Deadman::kReleased);
  EXPECT_TRUE(dut_.has_stuck_control());
  inputs_.controls.deadman = Deadman::kReleased;
  Run(11);
  EXPECT_FALSE(dut_.has_stuck_control());
  inputs_.controls.deadman = Deadman::kEnabled;
  EXPECT_EQ(Run(11).deadman, Deadman::kEnabled);
}

}  // namespace
}  // namespace eod::box
