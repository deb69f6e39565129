#include "sim/disposal/fire_circuit.h"

#include <set>

#include <gtest/gtest.h>

#include "tests/unit/disposal/bench.h"

namespace eod::sim {
namespace {

/// A box whose operator does everything right, unless a test says otherwise.
class Firing : public ::testing::Test {
 protected:
  static constexpr int kSecond = 250;  // steps

  bool Step(int times = 1) {
    bool fired = false;
    for (int i = 0; i < times; ++i) {
      if (echoes_) panel_.nonce_echo = dut_.nonce();
      fired = dut_.Advance(panel_, still_, ++step_, kStep) || fired;
    }
    return fired;
  }
  void Arm() {
    panel_ = {.arm_key = 1, .fire_left = 1, .fire_right = 1, .circuit = 2};
    Step();
    panel_.arm_key = 2;
    Step(kSecond + 1);
  }
  void Press(bool left, bool right) {
    panel_.fire_left = left ? 2 : 1;
    panel_.fire_right = right ? 2 : 1;
  }

  FireCircuit dut_{TheRules().disrupter, 7};
  FirePanel panel_;
  bool still_ = true;
  bool echoes_ = true;
  int64_t step_ = 0;
};

TEST_F(Firing, APanelThatNeverSpokeIsSafe) {
  EXPECT_FALSE(Step(10));
  EXPECT_EQ(dut_.state(), FireState::kSafe);
  EXPECT_EQ(dut_.continuity(), 0b111);
  EXPECT_EQ(dut_.nonce(), 0);
}

TEST_F(Firing, AKeyThatWasArmedFromTheStartHasToBeTurnedBackFirst) {
  panel_ = {.arm_key = 2, .fire_left = 1, .fire_right = 1, .circuit = 1};
  Step(2 * kSecond);
  EXPECT_EQ(dut_.state(), FireState::kSafe);
  panel_.arm_key = 1;
  Step();
  panel_.arm_key = 2;
  Step();
  EXPECT_EQ(dut_.state(), FireState::kArmedWait);
}

TEST_F(Firing, ArmedForASecondItIsReady) {
  Arm();
  EXPECT_EQ(dut_.state(), FireState::kReady);
  panel_.arm_key = 1;
  Step();
  EXPECT_EQ(dut_.state(), FireState::kSafe);
  panel_.arm_key = 2;
  Step(kSecond);
  EXPECT_EQ(dut_.state(), FireState::kArmedWait);
  Step();
  EXPECT_EQ(dut_.state(), FireState::kReady);
}

TEST_F(Firing, BothButtonsHeldForThreeTenthsFireOnceAndUseTheCartridge) {
  Arm();
  Press(true, true);
  EXPECT_FALSE(Step(75));  // 0.3 s: begun, not yet over
  EXPECT_TRUE(Step());
  EXPECT_EQ(dut_.state(), FireState::kFired);
  EXPECT_EQ(dut_.continuity(), 0b101);
  EXPECT_FALSE(Step(kSecond));
  // The same circuit again has nothing to fire with.
  Arm();
  EXPECT_EQ(dut_.state(), FireState::kArmedWait);
  panel_.circuit = 3;
  Step();
  EXPECT_EQ(dut_.state(), FireState::kReady);
}

TEST_F(Firing, TheButtonsMayBeHalfASecondApart) {
  for (const int apart : {125, 126}) {
    dut_.Reset();
    Arm();
    Press(true, false);
    Step(apart);
    Press(true, true);
    EXPECT_EQ(Step(kSecond), apart == 125) << apart;
  }
}

TEST_F(Firing, AButtonLetGoStartsAnew) {
  Arm();
  Press(true, true);
  Step(50);
  Press(true, false);
  Step();
  Press(true, true);
  EXPECT_FALSE(Step(75));
  EXPECT_TRUE(Step());
}

TEST_F(Firing, AStuckOrEarlyButtonNeverFires) {
  panel_ = {.arm_key = 1, .fire_left = 2, .fire_right = 1, .circuit = 1};
  Step();
  panel_.arm_key = 2;
  Step(kSecond + 1);
  Press(true, true);
  EXPECT_FALSE(Step(kSecond));
  // Pressed while it was not ready yet.
  dut_.Reset();
  Arm();
  panel_.arm_key = 1;
  Press(false, false);
  Step();
  panel_.arm_key = 2;
  Step(10);
  Press(true, true);
  EXPECT_FALSE(Step(2 * kSecond));
}

TEST_F(Firing, AWrongNonceAMovingRobotOrNoCircuitDoNotFire) {
  Arm();
  echoes_ = false;
  panel_.nonce_echo = dut_.nonce() ^ 1;
  Press(true, true);
  EXPECT_FALSE(Step(kSecond));
  dut_.Reset();
  echoes_ = true;
  Arm();
  still_ = false;
  Press(true, true);
  EXPECT_FALSE(Step(kSecond));
  EXPECT_EQ(dut_.state(), FireState::kArmedWait);
  dut_.Reset();
  still_ = true;
  Arm();
  panel_.circuit = 0;
  Press(true, true);
  EXPECT_FALSE(Step(kSecond));
}

TEST_F(Firing, TimesOutAfterThirtySeconds) {
  Arm();
  EXPECT_FALSE(Step(29 * kSecond));
  EXPECT_EQ(dut_.state(), FireState::kReady);
  Step();
  EXPECT_EQ(dut_.state(), FireState::kTimeOut);
  Press(true, true);
  EXPECT_FALSE(Step(kSecond));
  Press(false, false);
  panel_.arm_key = 1;
  Step();
  EXPECT_EQ(dut_.state(), FireState::kSafe);
}

TEST_F(Firing, ContactsOfZeroOrThreeAreAFaultUntilAllIsSafe) {
  for (const int broken : {0, 3}) {
    for (int FirePanel::*contact :
         {&FirePanel::arm_key, &FirePanel::fire_left, &FirePanel::fire_right}) {
      dut_.Reset();
      Arm();
      const FirePanel good = panel_;
      panel_.*contact = broken;
      Step();
      EXPECT_EQ(dut_.state(), FireState::kFault);
      EXPECT_EQ(dut_.nonce(), 0);
      panel_ = good;
      Step(10);
      EXPECT_EQ(dut_.state(), FireState::kFault);  // the key is still armed
      panel_.arm_key = 1;
      Step();
      EXPECT_EQ(dut_.state(), FireState::kSafe);
    }
  }
}

TEST_F(Firing, EveryArmingHasANonceOfItsOwnAndTheSameInTwoRuns) {
  const auto nonces = [this] {
    dut_.Reset();
    step_ = 0;
    std::vector<int> seen;
    for (int i = 0; i < 50; ++i) {
      Arm();
      seen.push_back(dut_.nonce());
      EXPECT_GE(seen.back(), 1);
      EXPECT_LE(seen.back(), 255);
      if (i > 0) {
        EXPECT_NE(seen[i], seen[i - 1]);
      }
    }
    return seen;
  };
  const std::vector<int> first = nonces();
  EXPECT_EQ(first, nonces());
  EXPECT_GT(std::set<int>(first.begin(), first.end()).size(), 30u);
}

}  // namespace
}  // namespace eod::sim
