#include "sim/alarms/alarm_table.h"

#include <algorithm>
#include <array>

namespace eod::sim {
namespace {

constexpr std::array kGravestFirst = {
    AlarmCode::kDetonation,  AlarmCode::kEstop,          AlarmCode::kLink,
    AlarmCode::kBoxFault,    AlarmCode::kRollover,       AlarmCode::kBombUnstable,
    AlarmCode::kBombTouched, AlarmCode::kPushAfterAlarm, AlarmCode::kCollision,
    AlarmCode::kTilt,        AlarmCode::kBattery,        AlarmCode::kJointLimit};

auto Rank(AlarmCode code) {
  return std::find(kGravestFirst.begin(), kGravestFirst.end(), code) - kGravestFirst.begin();
}

}  // namespace

AlarmTable::AlarmTable() { active_.reserve(kGravestFirst.size()); }

void AlarmTable::Set(AlarmCode code, bool on, uint32_t parts, std::vector<AlarmChange>& changes) {
  const auto known = std::find_if(active_.begin(), active_.end(),
                                  [code](const ActiveAlarm& alarm) { return alarm.code == code; });
  if (known == active_.end()) {
    if (!on) return;
    const auto lighter = std::find_if(active_.begin(), active_.end(), [code](const auto& alarm) {
      return Rank(alarm.code) > Rank(code);
    });
    active_.insert(lighter, {.code = code, .parts = parts});
  } else if (!on) {
    parts = known->parts;
    active_.erase(known);
  } else if (known->parts != parts) {
    known->parts = parts;
  } else {
    return;
  }
  changes.push_back({.code = code, .raised = on, .parts = parts});
}

bool AlarmTable::IsActive(AlarmCode code) const {
  return std::any_of(active_.begin(), active_.end(),
                     [code](const ActiveAlarm& alarm) { return alarm.code == code; });
}

}  // namespace eod::sim
