// The score sheet in words.
#include <algorithm>
#include <array>
#include <numbers>

#include <fmt/format.h>

#include "sim/score/scorer.h"
#include "sim/score/sheet_words.h"
#include "sim/task/task.h"

namespace eod::sim {
namespace {

std::string ResultText(int state, bool has_started) {
  switch (static_cast<MissionState>(state)) {
    case MissionState::kSuccess:
      return "success";
    case MissionState::kFail:
      return "fail";
    case MissionState::kAbort:
      return "abort";
    default:
      return has_started ? "incomplete" : "idle";
  }
}

ScoreItem Lost(std::string name, std::string text, double amount, std::string unit,
               double points_each) {
  return {.name = std::move(name),
          .text = std::move(text),
          .amount = amount,
          .unit = std::move(unit),
          .points = amount == 0 ? 0 : -points_each * amount};
}

}  // namespace

ScorePart Scorer::StepsPart() const {
  ScorePart part{.name = "steps",
                 .text = "Task steps",
                 .points = points_[0],
                 .of = scenario_.rubric.steps,
                 .items = {}};
  for (size_t i = 0; i < scenario_.steps.size(); ++i) {
    const bool done = static_cast<int>(i) < steps_done_;
    const double worth = StepPoints(static_cast<int>(i));
    part.items.push_back({.name = "step",
                          .text = fmt::format("{}. {}", i + 1, scenario_.steps[i].text),
                          .is_taken = done,
                          .amount = done ? 1.0 : 0.0,
                          .unit = "",
                          .points = done ? worth : 0,
                          .of = worth});
  }
  return part;
}

ScorePart Scorer::SafetyPart() const {
  const SafetyCount& count = safety_.count();
  const double limit = safety_.tilt_limit() * (180 / std::numbers::pi);
  return {
      .name = "safety",
      .text = "Safety",
      .points = points_[1],
      .of = scenario_.rubric.safety,
      .items = {
          Lost("collision", "Collisions that no step asked for", count.collisions, "",
               rules_.collision_points),
          Lost("pushing", "Pushing on after an alarm", count.pushing_s, "s", rules_.push_points),
          Lost("tilt", fmt::format("Tilted beyond {:.0f} degrees", limit), count.tilts, "",
               rules_.tilt_points),
          Lost("bomb_touch", "Charge touched, not grasped", count.touches, "", rules_.touch_points),
          Lost("fire_rule", "Rule of the arm key or of two hands broken", count.fire_rules, "",
               rules_.fire_points),
          Lost("unseen_driving", "Driving without a camera on the way", count.unseen, "",
               rules_.unseen_points),
          Lost("procedure", "Items of the check list missing, out of order or broken",
               procedure_.failed(), "", rules_.procedure_points)}};
}

ScorePart Scorer::PrecisionPart() const {
  ScorePart part{.name = "precision",
                 .text = "Precision",
                 .points = points_[2],
                 .of = scenario_.rubric.precision,
                 .items = {}};
  double all = 0;
  for (size_t i = 0; i < precision_.size(); ++i) all += precision_.spec(i).weight;
  for (size_t i = 0; i < precision_.size() && all > 0; ++i) {
    const PrecisionSpec& spec = precision_.spec(i);
    const PrecisionState& state = precision_.state(i);
    const double worth = part.of * spec.weight / all;
    part.items.push_back({.name = std::string(NameOf(spec.kind)),
                          .text = TextOf(spec),
                          .is_taken = state.is_taken,
                          .amount = InUnit(spec, state.value),
                          .unit = std::string(UnitOf(spec.kind)),
                          .points = worth * state.share,
                          .of = worth});
  }
  if (part.items.empty()) {
    part.items.push_back({.name = "steps_share",
                          .text = "No measures in this exercise: as the steps",
                          .is_taken = true,
                          .amount = StepShare(),
                          .unit = "",
                          .points = part.points,
                          .of = part.of});
  }
  return part;
}

ScorePart Scorer::TimePart() const {
  const double par = scenario_.par_time_s;
  const bool complete = static_cast<MissionState>(state_) == MissionState::kSuccess;
  return {.name = "time",
          .text = "Time",
          .points = points_[3],
          .of = scenario_.rubric.time,
          .items = {{.name = "elapsed",
                     .text = par > 0 ? fmt::format("Time to complete all steps; par is {:g} s", par)
                                     : "Time to complete all steps; any will do",
                     .is_taken = complete,
                     .amount = last_s_,
                     .unit = "s",
                     .points = points_[3],
                     .of = scenario_.rubric.time}}};
}

ScorePart Scorer::EconomyPart() const {
  const EconomyCount& count = economy_.count();
  return {.name = "economy",
          .text = "Economy",
          .points = points_[4],
          .of = scenario_.rubric.economy,
          .items = {Lost("reversal", "Driving or turning back at once", count.reversals, "",
                         rules_.reversal_points),
                    Lost("undone", "Motions of flippers or arm taken back at once", count.undone,
                         "", rules_.undone_points),
                    Lost("joint_limit", "Joints driven against their limits", count.limits, "",
                         rules_.limit_points)}};
}

std::vector<SheetProcedure> Scorer::ProcedureLines() const {
  std::vector<SheetProcedure> lines;
  for (size_t i = 0; i < procedure_.size(); ++i) {
    const ProcedureSpec& spec = procedure_.spec(i);
    const ProcedureState& state = procedure_.state(i);
    const bool failed = state.result == ProcedureResult::kMissing ||
                        state.result == ProcedureResult::kOutOfOrder ||
                        state.result == ProcedureResult::kBroken;
    lines.push_back({.name = std::string(NameOf(spec.kind)),
                     .text = TextOf(spec),
                     .result = std::string(NameOf(state.result)),
                     .time_s = state.time_s,
                     .points = failed ? -rules_.procedure_points : 0});
  }
  return lines;
}

ScoreSheet Scorer::Sheet() const {
  ScoreSheet sheet;
  sheet.scenario = scenario_.name;
  sheet.title = scenario_.title;
  sheet.module = module_;
  sheet.module_name = module_name_;
  sheet.difficulty = scenario_.difficulty;
  sheet.seed = scenario_.seed;
  sheet.result = ResultText(state_, has_started_);
  if (fail_reason_ != 0) sheet.critical_failure = Named(kFailures, fail_reason_, "unknown");
  sheet.elapsed_s = last_s_;
  sheet.par_time_s = scenario_.par_time_s;
  sheet.steps_done = steps_done_;
  sheet.steps = static_cast<int>(scenario_.steps.size());
  sheet.total = total_;
  sheet.pass = scenario_.rubric.pass;
  sheet.passed = sheet.result == "success" && total_ >= sheet.pass && fail_reason_ == 0;
  sheet.lost_s = lost_s_;
  sheet.parts = {StepsPart(), SafetyPart(), PrecisionPart(), TimePart(), EconomyPart()};
  sheet.procedure = ProcedureLines();
  for (const ScoreEvent& event : events_.events()) sheet.events.push_back(Describe(event));
  std::stable_sort(sheet.events.begin(), sheet.events.end(),
                   [](const SheetEvent& a, const SheetEvent& b) { return a.time_s < b.time_s; });
  sheet.events_left_out = events_.left_out();
  sheet.track = track_.points();
  sheet.places = places_;
  return sheet;
}

}  // namespace eod::sim
