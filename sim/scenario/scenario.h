#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "sim/scenario/control_link_spec.h"
#include "sim/scenario/fail_reason.h"
#include "sim/scenario/fault_spec.h"
#include "sim/scenario/placement.h"
#include "sim/scenario/precision_spec.h"
#include "sim/scenario/procedure_spec.h"
#include "sim/scenario/rubric.h"
#include "sim/scenario/task_step.h"
#include "sim/world/weather.h"

namespace eod::sim {

/// An exercise: a TOML file.
struct Scenario {
  std::filesystem::path file;
  std::string name;
  std::string title;
  int module = 1;
  int difficulty = 1;  ///< 1 easy .. 5 hard
  double par_time_s = 0;
  double time_limit_s = 0;  ///< 0: none
  Placement start;          ///< of the robot
  std::vector<Placement> places;
  /// Corners of the polygon that robot and charges must not leave: local x, y [m]; none: the
  /// module's area.
  std::vector<Eigen::Vector2d> area;
  FailReasons critical = kEveryReason;  ///< which failures end the exercise
  Weather weather;
  std::vector<Weather::Light> lights;  ///< a repetition has one of them; none: weather.light
  ControlLinkSpec link;
  Rubric rubric;
  std::vector<TaskStep> steps;
  std::vector<FaultSpec> faults;
  std::vector<PrecisionSpec> precision;
  std::vector<ProcedureSpec> procedure;
  int64_t seed = 0;
  uint64_t repetition = 0;  ///< Not from the file, see Vary.
};

/// Reads a scenario. Throws std::runtime_error with one line "FILE:LINE: …": a key that is unknown
/// (names the nearest known one) or missing, a value of the wrong type or out of range.
Scenario LoadScenario(const std::filesystem::path& file);

}  // namespace eod::sim
