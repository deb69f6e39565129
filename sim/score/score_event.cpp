#include "sim/score/score_event.h"

namespace eod::sim {

void EventList::Clear() {
  events_.clear();
  left_out_ = 0;
}

int EventList::Add(const ScoreMoment& moment, ScoreMark mark, double points, int index, int object,
                   double amount) {
  if (events_.size() == kRoom) {
    ++left_out_;
    return -1;
  }
  events_.push_back({.mark = mark,
                     .time_s = moment.now->mission_s,
                     .points = points,
                     .position = moment.p_M.head<2>(),
                     .index = index,
                     .object = object,
                     .amount = amount});
  return static_cast<int>(events_.size()) - 1;
}

void EventList::Extend(int place, double points, double amount) {
  if (place < 0) return;
  events_[static_cast<size_t>(place)].points = points;
  events_[static_cast<size_t>(place)].amount = amount;
}

void EventList::Antedate(int place, double time_s) {
  if (place >= 0) events_[static_cast<size_t>(place)].time_s = time_s;
}

}  // namespace eod::sim
