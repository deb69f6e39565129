#include "sim/score/procedure_watch.h"

#include <array>
#include <bit>

#include "sim/disposal/disposal_status.h"

namespace eod::sim {
namespace {

using Kind = ProcedureSpec::Kind;
constexpr int kHighSpeed = 2;  // numbers of box_command_t
constexpr int kArmed = 2;
constexpr int kQuad = 0;
constexpr uint32_t kFourCameras = 0b11110;

bool Drives(const ScoreSample& now) { return now.speed_mps != 0 || now.turn_rate_dps != 0; }

}  // namespace

std::string_view NameOf(ProcedureResult result) {
  constexpr std::array<std::string_view, 6> kNames = {"open",    "done", "out of order",
                                                      "missing", "kept", "broken"};
  return kNames[static_cast<size_t>(result)];
}

ProcedureWatch::ProcedureWatch(const Scenario& scenario, const ScoreRules& rules) : rules_(rules) {
  for (const ProcedureSpec& spec : scenario.procedure)
    items_.push_back({.spec = spec, .state = {}});
}

void ProcedureWatch::Reset() {
  for (Item& item : items_) item.state = {};
  failed_ = 0;
  cameras_ = 0;
  grasps_ = has_grasped_ = false;
  fires_ = has_fired_ = false;
  has_honked_ = false;
  carried_out_ = 0;
}

void ProcedureWatch::Advance(const ScoreMoment& moment, EventList& events) {
  const ScoreSample& now = *moment.now;
  NoteCameras(moment);
  grasps_ = !has_grasped_ && !now.held_object.empty();
  has_grasped_ = has_grasped_ || grasps_;
  fires_ = !has_fired_ && now.fire_state == static_cast<int>(FireState::kFired);
  has_fired_ = has_fired_ || fires_;
  has_honked_ = has_honked_ || now.horn;
  const double reach = (moment.charge_M - moment.p_M).head<2>().norm();
  const bool is_out = !now.held_object.empty() && reach > rules_.travel_reach;
  carried_out_ = is_out ? carried_out_ + moment.way : 0;

  for (size_t i = 0; i < items_.size(); ++i) {
    Item& item = items_[i];
    if (item.state.result != ProcedureResult::kOpen) continue;
    const int before = item.spec.before_step;
    if (IsKeptAllTheTime(item.spec.kind)) {
      if (IsBroken(item.spec, moment)) Fail(i, ProcedureResult::kBroken, moment, events);
    } else if (IsDone(item.spec, moment)) {
      item.state = {.result = ProcedureResult::kDone, .time_s = now.mission_s};
      BlameEarlierOnesBelow(i, moment, events);
    } else if (before > 0 && now.mission_step >= before) {
      Fail(i, ProcedureResult::kMissing, moment, events);
    }
  }
}

/// What stands below item `i`, and was done before it all the same.
void ProcedureWatch::BlameEarlierOnesBelow(size_t i, const ScoreMoment& moment, EventList& events) {
  for (size_t below = i + 1; below < items_.size(); ++below) {
    const ProcedureState& state = items_[below].state;
    const bool came_first =
        state.result == ProcedureResult::kDone && state.time_s < moment.now->mission_s;
    if (came_first) Fail(below, ProcedureResult::kOutOfOrder, moment, events);
  }
}

void ProcedureWatch::Fail(size_t item, ProcedureResult result, const ScoreMoment& moment,
                          EventList& events) {
  ++failed_;
  ProcedureState& state = items_[item].state;
  state.result = result;
  if (state.time_s < 0 && result == ProcedureResult::kBroken) state.time_s = moment.now->mission_s;
  events.Add(moment, ScoreMark::kProcedure, -rules_.procedure_points, static_cast<int>(item), -1,
             static_cast<double>(result));
}

void ProcedureWatch::NoteCameras(const ScoreMoment& moment) {
  const int camera = moment.now->camera_select;
  cameras_ |= camera == kQuad ? kFourCameras : 1u << camera;
}

bool ProcedureWatch::IsDone(const ProcedureSpec& spec, const ScoreMoment& moment) const {
  const ScoreSample& now = *moment.now;
  switch (spec.kind) {
    case Kind::kEstopTest:
      return (now.checks & kEstopTested) != 0;
    case Kind::kLampTest:
      return (now.checks & kLampsTested) != 0;
    case Kind::kCameraTour:
      return (now.checks & kAllCamerasSeen) == kAllCamerasSeen;
    case Kind::kTwoCameraRecon:
      return grasps_ && std::popcount(cameras_) >= 2;
    case Kind::kHornBeforeFire:
      return fires_ && has_honked_;
    case Kind::kRetreatBeforeFire:
      return fires_ && (moment.charge_M - moment.p_M).head<2>().norm() >= spec.distance;
    default:
      return false;
  }
}

bool ProcedureWatch::IsBroken(const ProcedureSpec& spec, const ScoreMoment& moment) const {
  const ScoreSample& now = *moment.now;
  switch (spec.kind) {
    case Kind::kLowSpeedWhileCarrying:
      return !now.held_object.empty() && Drives(now) && now.speed_range == kHighSpeed;
    case Kind::kTravelPoseBeforeDriving:
      return carried_out_ > rules_.travel_slack;
    case Kind::kArmKeySafeUntilStill:
      return now.arm_key == kArmed && Drives(now);
    default:
      return false;
  }
}

void ProcedureWatch::Finish(const ScoreMoment& moment, EventList& events) {
  for (size_t i = 0; i < items_.size(); ++i) {
    Item& item = items_[i];
    if (item.state.result != ProcedureResult::kOpen) continue;
    if (IsKeptAllTheTime(item.spec.kind)) {
      item.state.result = ProcedureResult::kKept;
    } else {
      Fail(i, ProcedureResult::kMissing, moment, events);
    }
  }
}

}  // namespace eod::sim
