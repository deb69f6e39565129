#include "firmware_emu/transmit_schedule.h"

#include <algorithm>
#include <chrono>

namespace eod::box {

using dbc::BoxMessage;

bool TransmitSchedule::Batch::Contains(BoxMessage wanted) const {
  return std::find(begin(), end(), wanted) != end();
}

TransmitSchedule::TransmitSchedule(const dbc::BoxCodec& codec) {
  for (int i = 0; i < dbc::kBoxMessageCount; ++i) {
    entries_[i].cycle = codec.cycle_time(static_cast<BoxMessage>(i));
  }
}

// Spread over the 20 ms of the fastest frames; the 50 ms panel frame falls on 8 and 18 in turn.
Duration TransmitSchedule::Offset(BoxMessage role) {
  switch (role) {
    case BoxMessage::kSafety:
      return std::chrono::milliseconds(0);
    case BoxMessage::kMotion:
      return std::chrono::milliseconds(5);
    case BoxMessage::kPanel:
      return std::chrono::milliseconds(8);
    case BoxMessage::kAxes:
      return std::chrono::milliseconds(10);
    case BoxMessage::kHeartbeat:
      return std::chrono::milliseconds(13);
    case BoxMessage::kFire:
      return std::chrono::milliseconds(15);
    case BoxMessage::kEmergency:
      break;
  }
  return {};
}

void TransmitSchedule::Start(int index, TimePoint start) {
  entries_[index].running = entries_[index].cycle > Duration::zero();
  entries_[index].due = start + Offset(static_cast<BoxMessage>(index));
}

void TransmitSchedule::StartHeartbeat(TimePoint start) {
  Start(static_cast<int>(BoxMessage::kHeartbeat), start);
}

void TransmitSchedule::StartProcessData(TimePoint start) {
  for (int i = 0; i < dbc::kBoxMessageCount; ++i) {
    if (static_cast<BoxMessage>(i) != BoxMessage::kHeartbeat) Start(i, start);
  }
}

void TransmitSchedule::StopAll() {
  for (Entry& entry : entries_) entry.running = false;
}

TransmitSchedule::Batch TransmitSchedule::TakeDue(TimePoint now) {
  Batch batch;
  late_ = Duration::zero();
  for (int i = 0; i < dbc::kBoxMessageCount; ++i) {
    Entry& entry = entries_[i];
    if (!entry.running || entry.due > now) continue;
    const int64_t missed = (now - entry.due) / entry.cycle;
    skipped_ += static_cast<uint64_t>(missed);
    entry.due += missed * entry.cycle;
    late_ = std::max(late_, now - entry.due);
    entry.due += entry.cycle;
    batch.role[batch.count++] = static_cast<BoxMessage>(i);
  }
  max_late_ = std::max(max_late_, late_);
  return batch;
}

}  // namespace eod::box
