#pragma once

#include <cstdint>
#include <vector>

#include "sim/alarms/alarm_table.h"
#include "sim/rules/rules.h"

namespace eod::sim {

/// What a step found, as far as alarms are concerned.
struct AlarmInputs {
  double dt_s = 0;
  uint32_t contact_parts = 0;     ///< parts with a blocking contact, bits of Part
  bool pushing = false;           ///< a motion is commanded although a contact blocks it
  uint32_t limit_flags = 0;       ///< joints that stand on a limit, bit j is joint j
  uint32_t driven_joints = 0;     ///< joints that are commanded against the limit they stand on
  double tilt = 0;                ///< [rad] between the robot's up axis and the vertical
  bool rolls_over = false;        ///< its centre of gravity is beyond its support
  bool charge_touched = false;    ///< a charge is in contact with the robot, and not held
  bool charge_disturbed = false;  ///< one is tilted beyond the first limit
  bool charge_unstable = false;   ///< beyond the second
  bool detonated = false;
  bool battery_low = false;
};

/// When an alarm goes on and off.
///
/// Collision: from a new contact until it is gone. Push after alarm: a blocked motion held for more
/// than 1 s after the alarm; until it is let go. Joint limit: once a joint is driven against its
/// limit; until it has left it. Tilt and rollover: beyond the angles of TiltRules; rollover also
/// while the robot rolls over. Bomb touched: in contact, or disturbed; it goes on as bomb unstable,
/// and ends as detonation. Battery: while its voltage is low.
class AlarmRules {
 public:
  explicit AlarmRules(const TiltRules& tilt) : tilt_(tilt) {}

  void Update(const AlarmInputs& inputs, AlarmTable& table, std::vector<AlarmChange>& changes);

 private:
  TiltRules tilt_;
  int pushed_steps_ = 0;
  bool was_pushing_ = false;
  uint32_t limited_joints_ = 0;
};

}  // namespace eod::sim
