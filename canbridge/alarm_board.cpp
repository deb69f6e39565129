#include "canbridge/alarm_board.h"

#include <algorithm>
#include <limits>

namespace eod::bridge {
namespace {

constexpr int kNoPriority = std::numeric_limits<int>::min();

// 0x10 collision, 0x11 push after alarm: their parts are those that touch.
bool IsContact(int code) { return (code & 0xF0) == 0x10; }

}  // namespace

AlarmBoard::AlarmBoard(const dbc::ControlMap& map) : map_(map) {
  simulator_.reserve(AlarmReport::kCapacity);
  bridge_.reserve(AlarmReport::kCapacity);
}

void AlarmBoard::SetSimulatorAlarms(std::span<const ActiveAlarm> active) {
  Replace(simulator_, active);
}

void AlarmBoard::SetBridgeAlarms(std::span<const ActiveAlarm> active) { Replace(bridge_, active); }

void AlarmBoard::Acknowledge() {
  is_silenced_ = true;
  Refresh();
}

void AlarmBoard::Replace(std::vector<ActiveAlarm>& set, std::span<const ActiveAlarm> active) {
  if (std::ranges::equal(set, active)) return;
  const bool is_new = std::ranges::any_of(
      active, [this](const ActiveAlarm& alarm) { return !IsActive(alarm.code); });
  if (is_new) is_silenced_ = false;
  set.assign(active.begin(), active.end());
  Refresh();
}

bool AlarmBoard::IsActive(int code) const {
  const auto has_code = [code](const ActiveAlarm& alarm) { return alarm.code == code; };
  return std::ranges::any_of(simulator_, has_code) || std::ranges::any_of(bridge_, has_code);
}

void AlarmBoard::Refresh() {
  display_ = {};
  int shown_priority = kNoPriority;
  uint32_t shown_parts = 0;
  std::array<int, dbc::kLampCount> lamp_priority;
  lamp_priority.fill(kNoPriority);
  const auto add = [&](const ActiveAlarm& alarm) {
    const dbc::AlarmMap* entry = map_.FindAlarm(alarm.code);
    if (entry == nullptr) return;
    if (IsContact(alarm.code)) display_.hit_parts |= alarm.parts;
    if (entry->lamp) {
      const auto lamp = static_cast<std::size_t>(*entry->lamp);
      if (entry->priority > lamp_priority[lamp]) {
        lamp_priority[lamp] = entry->priority;
        display_.lamp[lamp] = entry->pattern;
      }
    }
    if (entry->priority > shown_priority) {
      shown_priority = entry->priority;
      shown_parts = alarm.parts;
      display_.code = alarm.code;
      display_.buzzer = entry->buzzer;
    }
  };
  std::ranges::for_each(bridge_, add);
  std::ranges::for_each(simulator_, add);
  display_.hit_parts |= shown_parts;
  if (is_silenced_) display_.buzzer = dbc::BuzzerPattern::kOff;
}

}  // namespace eod::bridge
