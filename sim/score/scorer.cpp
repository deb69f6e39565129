#include "sim/score/scorer.h"

#include <algorithm>
#include <numeric>

#include "sim/task/task.h"

namespace eod::sim {
namespace {

enum PartIndex : size_t { kStepsPart, kSafetyPart, kPrecisionPart, kTimePart, kEconomyPart };

/// All names that a contact can have, sorted.
std::vector<std::string> NamesIn(const ModuleModel& module) {
  std::vector<std::string> names;
  for (const WorldObject& object : module.objects) names.push_back(object.name);
  for (const MovableObject& movable : module.movables) names.push_back(movable.name);
  std::sort(names.begin(), names.end());
  return names;
}

/// Where the things that the steps name are, each once.
std::vector<SheetPlace> PlacesOf(const Scenario& scenario, const ModuleModel& module) {
  std::vector<SheetPlace> places;
  const auto add = [&](const auto& list) {
    for (const auto& one : list) {
      const bool is_named =
          std::any_of(scenario.steps.begin(), scenario.steps.end(),
                      [&](const TaskStep& step) { return step.object == one.name; });
      if (is_named)
        places.push_back({.name = one.name, .position = one.X_MO.translation().template head<2>()});
    }
  };
  add(module.objects);
  add(module.movables);
  return places;
}

}  // namespace

Scorer::Scorer(const Scenario& scenario, const ModuleModel& module, const Rules& rules)
    : scenario_(scenario),
      rules_(rules.score),
      module_(module.id),
      module_name_(module.name),
      p_WM_(module.p_WM),
      names_(NamesIn(module)),
      places_(PlacesOf(scenario, module)),
      safety_(scenario, rules),
      economy_(rules.score),
      precision_(scenario, module, names_),
      procedure_(scenario, rules.score) {
  for (const TaskStep& step : scenario.steps) step_objects_.push_back(ObjectOf(step.object));
}

void Scorer::Reset() {
  safety_.Reset();
  economy_.Reset();
  precision_.Reset();
  procedure_.Reset();
  events_.Clear();
  track_.Clear();
  has_started_ = false;
  is_over_ = false;
  last_s_ = 0;
  lost_s_ = 0;
  steps_done_ = 0;
  state_ = 0;
  fail_reason_ = 0;
  points_ = {};
  total_ = 0;
}

void Scorer::Start(const ScoreSample& sample) {
  Reset();
  has_started_ = true;
  last_sample_ = sample.step - 1;
  last_s_ = sample.mission_s;
  last_position_ = sample.position;
  lost_s_ = sample.mission_s;
}

void Scorer::Advance(const ScoreSample& sample) {
  const auto state = static_cast<MissionState>(sample.mission_state);
  const bool runs = state == MissionState::kRun && sample.module == module_;
  if (runs && (!has_started_ || is_over_ || sample.mission_s == 0)) Start(sample);
  if (!has_started_ || is_over_) return;
  const bool ends = state == MissionState::kSuccess || state == MissionState::kFail ||
                    state == MissionState::kAbort;
  if (!runs && !ends) {
    is_over_ = true;  // the module was entered anew
    return;
  }
  Judge(sample);
}

int Scorer::ObjectOf(std::string_view name) const {
  const auto found = std::lower_bound(names_.begin(), names_.end(), name);
  return found == names_.end() || *found != name ? -1 : static_cast<int>(found - names_.begin());
}

ScoreMoment Scorer::MomentOf(const ScoreSample& sample) const {
  return {.now = &sample,
          .dt_s = sample.mission_s - last_s_,
          .p_M = sample.position - p_WM_,
          .charge_M = sample.charge_position - p_WM_,
          .way = (sample.position - last_position_).head<2>().norm(),
          .step_before = steps_done_,
          .contact = ObjectOf(sample.contact_object)};
}

void Scorer::Judge(const ScoreSample& sample) {
  const ScoreMoment moment = MomentOf(sample);
  if (sample.step != last_sample_ + 1) lost_s_ += moment.dt_s;
  last_sample_ = sample.step;
  last_s_ = sample.mission_s;
  last_position_ = sample.position;
  state_ = sample.mission_state;
  track_.Add(moment.p_M.head<2>());
  safety_.Advance(moment, step_objects_, events_);
  economy_.Advance(moment, events_);
  precision_.Advance(moment, events_);
  procedure_.Advance(moment, events_);
  NoteSteps(moment);
  is_over_ = static_cast<MissionState>(state_) != MissionState::kRun;
  if (is_over_) {
    procedure_.Finish(moment, events_);
    fail_reason_ = sample.fail_reason;
    if (fail_reason_ != 0) events_.Add(moment, ScoreMark::kFailed, 0, fail_reason_);
  }
  CountPoints();
}

void Scorer::NoteSteps(const ScoreMoment& moment) {
  const int steps = static_cast<int>(scenario_.steps.size());
  while (steps_done_ < std::min(moment.now->mission_step, steps)) {
    events_.Add(moment, ScoreMark::kStep, StepPoints(steps_done_), steps_done_);
    ++steps_done_;
  }
}

double Scorer::StepPoints(int step) const {
  double all = 0;
  for (const TaskStep& one : scenario_.steps) all += one.weight;
  const double weight = scenario_.steps[static_cast<size_t>(step)].weight;
  return all > 0 ? scenario_.rubric.steps * weight / all : 0;
}

double Scorer::StepShare() const {
  double all = 0, done = 0;
  for (size_t i = 0; i < scenario_.steps.size(); ++i) {
    all += scenario_.steps[i].weight;
    if (static_cast<int>(i) < steps_done_) done += scenario_.steps[i].weight;
  }
  return all > 0 ? done / all : 0;
}

void Scorer::CountPoints() {
  const Rubric& rubric = scenario_.rubric;
  const SafetyCount& safety = safety_.count();
  const EconomyCount& economy = economy_.count();
  const double unsafe =
      rules_.collision_points * safety.collisions + rules_.push_points * safety.pushing_s +
      rules_.tilt_points * safety.tilts + rules_.touch_points * safety.touches +
      rules_.fire_points * safety.fire_rules + rules_.unseen_points * safety.unseen +
      rules_.procedure_points * procedure_.failed();
  const double wasted = rules_.reversal_points * economy.reversals +
                        rules_.undone_points * economy.undone +
                        rules_.limit_points * economy.limits;
  points_[kStepsPart] = rubric.steps * StepShare();
  points_[kSafetyPart] = std::max(0.0, rubric.safety - unsafe);
  points_[kPrecisionPart] = rubric.precision * precision_.share().value_or(StepShare());
  const double zero = rules_.time_zero * scenario_.par_time_s;
  const bool complete = static_cast<MissionState>(state_) == MissionState::kSuccess;
  const double left = zero > 0 ? (zero - last_s_) / (zero - scenario_.par_time_s) : 1;
  points_[kTimePart] = complete ? rubric.time * std::clamp(left, 0.0, 1.0) : 0;
  points_[kEconomyPart] = std::max(0.0, rubric.economy - wasted);
  total_ = std::accumulate(points_.begin(), points_.end(), 0.0);
}

}  // namespace eod::sim
