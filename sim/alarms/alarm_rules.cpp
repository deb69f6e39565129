#include "sim/alarms/alarm_rules.h"

#include <array>

#include "sim/robot/motion_id.h"

namespace eod::sim {
namespace {

constexpr double kPushDelay = 1.0;  // [s]

constexpr uint32_t BitOf(Part part) { return 1u << static_cast<int>(part); }

/// The part that a joint moves first, for the display: J1 .. J9.
constexpr std::array<uint32_t, kJointCount> kPartsOfJoint = {
    BitOf(Part::kFrontLeftWheel) | BitOf(Part::kFrontRightWheel),
    BitOf(Part::kRearLeftWheel) | BitOf(Part::kRearRightWheel),
    BitOf(Part::kBigArm),
    BitOf(Part::kSmallArm),
    BitOf(Part::kCrossbeam),
    BitOf(Part::kCrossbeam),
    BitOf(Part::kLeftHand) | BitOf(Part::kRightHand),
    BitOf(Part::kMast),
    BitOf(Part::kMast)};

uint32_t PartsOf(uint32_t joints) {
  uint32_t parts = 0;
  for (int j = 0; j < kJointCount; ++j) {
    if ((joints >> j & 1u) != 0) parts |= kPartsOfJoint[j];
  }
  return parts;
}

}  // namespace

void AlarmRules::Update(const AlarmInputs& inputs, AlarmTable& table,
                        std::vector<AlarmChange>& changes) {
  table.Set(AlarmCode::kCollision, inputs.contact_parts != 0, inputs.contact_parts, changes);

  // The step that raises the alarm counts nothing yet: the operator cannot have known.
  pushed_steps_ = inputs.pushing && was_pushing_ ? pushed_steps_ + 1 : 0;
  was_pushing_ = inputs.pushing;
  const bool pushed_on = pushed_steps_ * inputs.dt_s > kPushDelay;
  table.Set(AlarmCode::kPushAfterAlarm, pushed_on, inputs.contact_parts, changes);

  limited_joints_ = (limited_joints_ | inputs.driven_joints) & inputs.limit_flags;
  table.Set(AlarmCode::kJointLimit, limited_joints_ != 0, PartsOf(limited_joints_), changes);

  const bool rolled_over = inputs.rolls_over || inputs.tilt > tilt_.rollover;
  table.Set(AlarmCode::kTilt, inputs.tilt > tilt_.alarm && !rolled_over, BitOf(Part::kChassis),
            changes);
  table.Set(AlarmCode::kRollover, rolled_over, BitOf(Part::kChassis), changes);

  constexpr uint32_t kBomb = BitOf(Part::kHeldBomb);
  const bool touched = inputs.charge_touched || inputs.charge_disturbed;
  table.Set(AlarmCode::kBombTouched, touched, kBomb, changes);
  table.Set(AlarmCode::kBombUnstable, inputs.charge_unstable, kBomb, changes);
  table.Set(AlarmCode::kBattery, inputs.battery_low, 0, changes);
  table.Set(AlarmCode::kDetonation, inputs.detonated, kBomb, changes);
}

}  // namespace eod::sim
