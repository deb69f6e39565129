#pragma once

#include <array>
#include <string>
#include <vector>

#include "sim/rules/rules.h"
#include "sim/scenario/scenario.h"
#include "sim/score/economy_watch.h"
#include "sim/score/precision_watch.h"
#include "sim/score/procedure_watch.h"
#include "sim/score/safety_watch.h"
#include "sim/score/score_sample.h"
#include "sim/score/score_sheet.h"
#include "sim/score/track.h"
#include "sim/world/world_model.h"

namespace eod::sim {

/// Points of the five parts: steps, safety, precision, time, economy.
using PartPoints = std::array<double, 5>;

/// Judges a mission by the rubric of 4.2 of the design, from what every step tells. Pure, and the
/// same samples give the same bits, whether they come from the simulator or from a log.
///
/// Begins anew when a mission starts, and holds its result from its end until the next one starts.
/// Points for time are given when all steps are complete, those for precision as measures are
/// taken; an exercise without measures gives them in proportion to its steps.
class Scorer {
 public:
  /// Throws std::runtime_error that names the scenario's file, if a [[precision]] or [[procedure]]
  /// does not fit `module`.
  Scorer(const Scenario& scenario, const ModuleModel& module, const Rules& rules);

  /// One step. No allocation.
  void Advance(const ScoreSample& sample);
  /// Forgets the mission.
  void Reset();

  /// A mission has started since the last Reset.
  bool has_started() const { return has_started_; }
  /// It is over: nothing changes any more.
  bool is_over() const { return is_over_; }
  /// 0..100
  double total() const { return total_; }
  PartPoints points() const { return points_; }
  const std::vector<ScoreEvent>& events() const { return events_.events(); }

  /// Everything about the mission so far, or the last one. Allocates.
  ScoreSheet Sheet() const;

 private:
  void Start(const ScoreSample& sample);
  ScoreMoment MomentOf(const ScoreSample& sample) const;
  int ObjectOf(std::string_view name) const;
  void NoteSteps(const ScoreMoment& moment);
  void Judge(const ScoreSample& sample);
  void CountPoints();
  double StepShare() const;
  double StepPoints(int step) const;

  ScorePart StepsPart() const;
  ScorePart SafetyPart() const;
  ScorePart PrecisionPart() const;
  ScorePart TimePart() const;
  ScorePart EconomyPart() const;
  std::vector<SheetProcedure> ProcedureLines() const;
  std::string TextOfEvent(const ScoreEvent& event) const;
  SheetEvent Describe(const ScoreEvent& event) const;

  Scenario scenario_;
  ScoreRules rules_;
  int module_;
  std::string module_name_;
  Eigen::Vector3d p_WM_;
  std::vector<std::string> names_;  ///< of the module's objects and movables, sorted
  std::vector<int> step_objects_;   ///< in names_, one a step
  std::vector<SheetPlace> places_;  ///< that the steps name
  SafetyWatch safety_;
  EconomyWatch economy_;
  PrecisionWatch precision_;
  ProcedureWatch procedure_;
  EventList events_;
  Track track_;

  bool has_started_ = false;
  bool is_over_ = false;
  int64_t last_sample_ = 0;  ///< number of the last step
  double last_s_ = 0;        ///< of the mission
  Eigen::Vector3d last_position_ = Eigen::Vector3d::Zero();
  double lost_s_ = 0;  ///< of it, that no sample told of
  int steps_done_ = 0;
  int state_ = 0;
  int fail_reason_ = 0;
  PartPoints points_{};
  double total_ = 0;
};

}  // namespace eod::sim
