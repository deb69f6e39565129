#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "sim/robot/robot_state.h"
#include "sim/world/world_model.h"

namespace eod::sim {

/// One thing the trainee has to do; complete when its condition holds.
struct TaskStep {
  enum class Kind : uint8_t {
    kContact,    ///< touch `object` with an isector, so that the motion is inhibited
    kClear,      ///< no contact, and at least `distance` from where the contact was
    kPassGate,   ///< drive the robot's origin through the opening of `object` (between its posts)
    kStopAt,     ///< stand still for 1 s with the foremost point `distance` +- `tolerance` from `object`
    kReach,      ///< origin within `tolerance` of (x, y)
  };
  Kind kind = Kind::kContact;
  std::string object;
  double distance = 0;   ///< [m]
  double tolerance = 0;  ///< [m]
  double x = 0, y = 0;   ///< [m] local
  std::string text;      ///< for the trainee
  double weight = 1;
};

/// An exercise: a TOML file.
struct Scenario {
  std::filesystem::path file;
  std::string name;
  std::string title;
  int module = 1;
  double par_time_s = 0;
  double time_limit_s = 0;  ///< 0: none
  std::vector<TaskStep> steps;
  int64_t seed = 0;
};

/// Throws std::runtime_error with one line "FILE:LINE: …"; an unknown key names the nearest known one.
Scenario LoadScenario(const std::filesystem::path& file);

enum class MissionState : int8_t { kIdle, kBrief, kRun, kSuccess, kFail, kAbort };

struct TaskStatus {
  MissionState state = MissionState::kIdle;
  double elapsed_s = 0;
  int step = 0;
  int steps = 0;
  double score = 0;  ///< 0..100
  int collisions = 0;
  int fail_reason = 0;  ///< ROB_MISSION.FailReason
  bool operator==(const TaskStatus&) const = default;
};

/// What a task looks at in a step.
struct TaskInputs {
  double dt_s = 0;
  const RobotState* state = nullptr;
  double speed = 0;
  double turn_rate = 0;
  bool started = false;  ///< mission start asked for in this step
  bool ended = false;
  bool new_contact = false;       ///< an alarm of collision was raised in this step
  bool in_contact = false;
  std::string_view contact_object;  ///< object of the first contact, "" if none
  double forward_clearance = 0;     ///< [m] from the foremost point of the robot to what is ahead; infinity if nothing
  std::string_view forward_object;
};

/// Progress through a scenario's steps. Pure; no allocation in Advance.
class Task {
 public:
  Task(const Scenario& scenario, const ModuleModel& module);
  const TaskStatus& Advance(const TaskInputs& inputs);
  const TaskStatus& status() const { return status_; }
  const std::string& step_text() const;

 private:
  std::vector<TaskStep> steps_;
  const ModuleModel* module_;
  TaskStatus status_;
  double still_s_ = 0;
  Eigen::Vector3d mark_ = Eigen::Vector3d::Zero();
  double last_side_ = 0;
};

}  // namespace eod::sim
