#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sim/alarms/alarm_rules.h"
#include "tests/unit/behaviour/fixture.h"

namespace eod::sim {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

constexpr uint32_t kFrontWheels = 0b11;

/// Rules and table together; returns the changes of one step.
struct Board {
  AlarmRules rules{{.alarm = 25 * kDegree, .rollover = 45 * kDegree}};
  AlarmTable table;

  std::vector<AlarmChange> Step(const AlarmInputs& inputs) {
    std::vector<AlarmChange> changes;
    rules.Update(inputs, table, changes);
    return changes;
  }
};

AlarmInputs Contact(uint32_t parts, bool pushing = false) {
  AlarmInputs inputs;
  inputs.dt_s = 0.004;
  inputs.contact_parts = parts;
  inputs.pushing = pushing;
  return inputs;
}

TEST(AlarmTable, TellsNewsOnly) {
  AlarmTable dut;
  std::vector<AlarmChange> changes;
  dut.Set(AlarmCode::kCollision, false, 0, changes);
  EXPECT_THAT(changes, IsEmpty());
  dut.Set(AlarmCode::kCollision, true, 1, changes);
  dut.Set(AlarmCode::kCollision, true, 1, changes);
  dut.Set(AlarmCode::kCollision, true, 3, changes);
  dut.Set(AlarmCode::kCollision, false, 0, changes);
  EXPECT_THAT(changes, ElementsAre(AlarmChange{AlarmCode::kCollision, true, 1},
                                   AlarmChange{AlarmCode::kCollision, true, 3},
                                   AlarmChange{AlarmCode::kCollision, false, 3}));
}

TEST(AlarmTable, StandsGravestFirst) {
  AlarmTable dut;
  std::vector<AlarmChange> changes;
  for (const AlarmCode code : {AlarmCode::kJointLimit, AlarmCode::kRollover, AlarmCode::kCollision,
                               AlarmCode::kPushAfterAlarm, AlarmCode::kDetonation}) {
    dut.Set(code, true, 0, changes);
  }
  std::vector<AlarmCode> codes;
  for (const ActiveAlarm& alarm : dut.active()) codes.push_back(alarm.code);
  EXPECT_THAT(codes,
              ElementsAre(AlarmCode::kDetonation, AlarmCode::kRollover, AlarmCode::kPushAfterAlarm,
                          AlarmCode::kCollision, AlarmCode::kJointLimit));
}

TEST(AlarmRules, CollisionIsRaisedOnceAndClearedWithTheContact) {
  Board dut;
  EXPECT_THAT(dut.Step(Contact(kFrontWheels)),
              ElementsAre(AlarmChange{AlarmCode::kCollision, true, kFrontWheels}));
  for (int i = 0; i < 100; ++i) EXPECT_THAT(dut.Step(Contact(kFrontWheels)), IsEmpty());
  EXPECT_THAT(dut.Step(Contact(0)),
              ElementsAre(AlarmChange{AlarmCode::kCollision, false, kFrontWheels}));
  EXPECT_THAT(dut.table.active(), IsEmpty());
}

TEST(AlarmRules, PushingOnForMoreThanASecondIsAnAlarmUntilItIsLetGo) {
  Board dut;
  dut.Step(Contact(kFrontWheels, true));
  // 250 steps of 4 ms after the alarm are 1 s: not yet more.
  for (int i = 0; i < 250; ++i) EXPECT_THAT(dut.Step(Contact(kFrontWheels, true)), IsEmpty());
  EXPECT_THAT(dut.Step(Contact(kFrontWheels, true)),
              ElementsAre(AlarmChange{AlarmCode::kPushAfterAlarm, true, kFrontWheels}));
  EXPECT_THAT(dut.Step(Contact(kFrontWheels, false)),
              ElementsAre(AlarmChange{AlarmCode::kPushAfterAlarm, false, kFrontWheels}));
  // A fresh push starts a fresh second.
  EXPECT_THAT(dut.Step(Contact(kFrontWheels, true)), IsEmpty());
}

TEST(AlarmRules, JointLimitIsRaisedOnceAContact) {
  Board dut;
  AlarmInputs inputs;
  inputs.limit_flags = 1u << kBigArm;  // stands there, nobody pushes: no alarm
  EXPECT_THAT(dut.Step(inputs), IsEmpty());
  inputs.driven_joints = 1u << kBigArm;
  const uint32_t big_arm = 1u << static_cast<int>(Part::kBigArm);
  EXPECT_THAT(dut.Step(inputs), ElementsAre(AlarmChange{AlarmCode::kJointLimit, true, big_arm}));
  EXPECT_THAT(dut.Step(inputs), IsEmpty());
  inputs.driven_joints = 0;  // let go, but still there
  EXPECT_THAT(dut.Step(inputs), IsEmpty());
  inputs.limit_flags = 0;
  EXPECT_THAT(dut.Step(inputs), ElementsAre(AlarmChange{AlarmCode::kJointLimit, false, big_arm}));
}

TEST(AlarmRules, TiltAndRolloverFollowTheInclination) {
  const auto active = [](double degrees) {
    Board dut;
    AlarmInputs inputs;
    inputs.tilt = degrees * kDegree;
    dut.Step(inputs);
    std::vector<AlarmCode> codes;
    for (const ActiveAlarm& alarm : dut.table.active()) codes.push_back(alarm.code);
    return codes;
  };
  EXPECT_THAT(active(24.9), IsEmpty());
  EXPECT_THAT(active(25.1), ElementsAre(AlarmCode::kTilt));
  EXPECT_THAT(active(44.9), ElementsAre(AlarmCode::kTilt));
  EXPECT_THAT(active(45.1), ElementsAre(AlarmCode::kRollover));
}

TEST(AlarmRules, ChargeIsToldWhenTouchedOrDisturbedUnstableAndBlown) {
  constexpr uint32_t kBomb = 1u << static_cast<int>(Part::kHeldBomb);
  Board dut;
  AlarmInputs inputs;
  inputs.charge_touched = true;
  EXPECT_THAT(dut.Step(inputs), ElementsAre(AlarmChange{AlarmCode::kBombTouched, true, kBomb}));
  inputs.charge_touched = false;
  inputs.charge_disturbed = true;  // let go of, but leaning
  EXPECT_THAT(dut.Step(inputs), IsEmpty());
  inputs.charge_unstable = true;
  EXPECT_THAT(dut.Step(inputs), ElementsAre(AlarmChange{AlarmCode::kBombUnstable, true, kBomb}));
  inputs = {};
  inputs.detonated = true;
  EXPECT_THAT(dut.Step(inputs), ElementsAre(AlarmChange{AlarmCode::kBombTouched, false, kBomb},
                                            AlarmChange{AlarmCode::kBombUnstable, false, kBomb},
                                            AlarmChange{AlarmCode::kDetonation, true, kBomb}));
  EXPECT_EQ(dut.table.active().front().code, AlarmCode::kDetonation);
}

}  // namespace
}  // namespace eod::sim
