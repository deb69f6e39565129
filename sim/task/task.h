#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <Eigen/Geometry>

#include "sim/disposal/disposal_status.h"
#include "sim/robot/robot_state.h"
#include "sim/rules/critical_rules.h"
#include "sim/scenario/scenario.h"
#include "sim/task/critical_watch.h"
#include "sim/world/world_model.h"

namespace eod::sim {

/// Numbers of ROB_STATUS.MissionState.
enum class MissionState : int8_t { kIdle, kBrief, kRun, kSuccess, kFail, kAbort };

struct TaskStatus {
  MissionState state = MissionState::kIdle;
  double elapsed_s = 0;  ///< simulated time since the start
  int step = 0;          ///< 0-based; equals `steps` when done
  int steps = 0;
  double score = 0;  ///< 0..100, as the Scorer has it: a Task leaves it at 0
  int collisions = 0;
  FailReason fail_reason = FailReason::kNone;
  bool operator==(const TaskStatus&) const = default;
};

/// Whether a robot of that speed [m/s] and turn rate [rad/s] counts as standing.
bool StandsStill(double speed, double turn_rate);

/// What a task looks at in a step.
struct TaskInputs {
  double dt_s = 0;
  const RobotState* state = nullptr;
  double speed = 0;          ///< [m/s]
  double turn_rate = 0;      ///< [rad/s]
  bool started = false;      ///< mission start asked for in this step
  bool ended = false;        ///< mission end asked for in this step
  bool new_contact = false;  ///< an alarm of collision was raised in this step
  bool in_contact = false;
  bool rolled_over = false;
  bool estopped = false;             ///< by the instructor
  bool ended_by_instructor = false;  ///< in this step
  double link_lost_s = 0;  ///< [s] since anything came from the operator, 0 while it comes in time
  bool sees_object = false;         ///< the object of Task::inspected()
  std::string_view contact_object;  ///< object of the first contact, "" if none
  /// [m] from the foremost point of a robot that stands to what is ahead; infinity if nothing is,
  /// or it moves
  double forward_clearance = 0;
  std::string_view forward_object;
  const DisposalStatus* disposal = nullptr;     ///< null: as if no charge was there
  std::span<const Eigen::Isometry3d> movables;  ///< X_MO, in the order of ModuleModel::movables
};

/// What the trainee is to look at now.
struct InspectedObject {
  const TaskStep* step = nullptr;
  int movable = -1;  ///< its index among the movables, -1 if it stands still
  Eigen::Isometry3d X_MO = Eigen::Isometry3d::Identity();  ///< where it was at the start
};

/// Progress through a scenario's steps. Pure; no allocation in Advance.
///
/// The time limit fails the mission, and so does what CriticalWatch finds, and a strict step that
/// is done before its turn.
class Task {
 public:
  /// Throws std::runtime_error that names the scenario's file, if a step's object is not in
  /// `module`, or is not what the step needs: a movable to grasp, a vessel to place in.
  Task(const Scenario& scenario, const ModuleModel& module, const CriticalRules& critical = {});

  const TaskStatus& Advance(const TaskInputs& inputs);
  const TaskStatus& status() const { return status_; }

  /// What the trainee is to do now; empty when nothing is.
  const std::string& step_text() const;

  /// The object that TaskInputs::sees_object is about; nothing unless an inspect step is current.
  std::optional<InspectedObject> inspected() const;

  /// Forgets all progress: idle again.
  void Reset();

 private:
  struct Step {
    TaskStep spec;
    Eigen::Isometry3d X_MO = Eigen::Isometry3d::Identity();  ///< of the object, at the start
    int movable = -1;  ///< index of the object among the movables
    VesselSpec vessel;
  };
  static Step MakeStep(const TaskStep& spec, const Scenario& scenario, const ModuleModel& module);
  void Start(const TaskInputs& inputs);
  void WatchGrasp(const TaskInputs& inputs);
  bool IsComplete(const Step& step, const TaskInputs& inputs);
  bool HasPassed(const Step& gate, const Eigen::Vector3d& p_M) const;
  bool HasStopped(const TaskStep& step, const TaskInputs& inputs);
  bool HasHeldStill(const TaskStep& step, const TaskInputs& inputs);
  bool HasInspected(const TaskStep& step, const TaskInputs& inputs);
  bool IsLifted(const Step& step, const TaskInputs& inputs) const;
  FailReason Failure(const TaskInputs& inputs);
  bool IsOutOfTurn(const TaskInputs& inputs);
  void CompleteStep(const RobotState& state);

  CriticalWatch critical_;
  FailReasons critical_reasons_;
  std::vector<Step> steps_;
  double time_limit_s_;
  TaskStatus status_;
  int64_t elapsed_steps_ = 0;
  int still_steps_ = 0;
  int held_ = -1;                                   ///< movable in the gripper
  double grasp_height_ = 0;                         ///< [m] z of its frame when it was grasped
  Eigen::Vector3d mark_ = Eigen::Vector3d::Zero();  ///< where the last step was completed
  Eigen::Vector3d last_position_ = Eigen::Vector3d::Zero();
};

}  // namespace eod::sim
