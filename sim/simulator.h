#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "platform/time.h"
#include "sim/alarms/alarm_rules.h"
#include "sim/alarms/alarm_table.h"
#include "sim/bodies/rigid_bodies.h"
#include "sim/disposal/disposal_status.h"
#include "sim/isectors/isector_set.h"
#include "sim/motion/motion.h"
#include "sim/operator_command.h"
#include "sim/response/response.h"
#include "sim/robot/robot_model.h"
#include "sim/task/task.h"
#include "sim/world/built_world.h"
#include "sim/world/world_model.h"

namespace eod::sim {

struct SimulatorConfig {
  Duration period = std::chrono::milliseconds(4);             ///< 1..20 ms
  Duration command_timeout = std::chrono::milliseconds(100);  ///< zero motion from this age on
  Coverage coverage = Coverage::kExtended;
  IsectorRules rules = {};
  Rules exercise = {};         ///< as LoadRules gives them; they must be loaded
  bool start_mission = false;  ///< the mission runs from the first step, without the menu
};

/// What one step found; copyable, and equal in two runs of the same inputs.
struct StepResult {
  int64_t step = 0;  ///< 1 for the first
  TimePoint time{};
  int module = 0;
  RobotState state;
  double speed = 0;          ///< [m/s] along the chassis' forward axis
  double turn_rate = 0;      ///< [rad/s] left positive
  uint32_t limit_flags = 0;  ///< joints that stand on a limit, bit j is joint j
  MotionSet inhibited = 0;  ///< by a contact that stands, a limit that is pressed on, or the bridge
  int inhibit_reason = kReasonNone;  ///< of several: collision, joint limit, then the others
  uint32_t contact_parts = 0;
  int32_t command_sequence = 0;
  std::vector<AlarmChange> alarm_changes;  ///< of this step
  DisposalStatus disposal;
  TaskStatus task;
  bool task_changed = false;  ///< apart from its clock
  bool operator==(const StepResult&) const = default;
};

/// The simulator of one robot in one world. Pure: no socket, clock or thread inside.
class Simulator {
 public:
  /// `robot` and `world` must outlive the simulator. Throws std::runtime_error for a scenario that
  /// does not fit the world, a period that is out of range, or rules that nobody loaded.
  Simulator(const RobotModel& robot, const WorldModel& world, const Scenario& scenario,
            const SimulatorConfig& config);

  /// Advances by one period. `now` is the scheduled moment of this step. Never throws, and
  /// allocates nothing.
  const StepResult& Step(TimePoint now, const OperatorCommand& command);

  const StepResult& last() const { return result_; }
  const AlarmTable& alarms() const { return alarms_; }
  const Task& task() const { return place_->task; }
  const Scenario& scenario() const { return scenario_; }
  const ModuleModel& module() const { return *place_->module; }
  const World& world() const { return *place_->world; }
  /// Segments of the last step, cast at the pose before it.
  const IsectorSet& isectors() const { return place_->isectors; }
  /// Contacts of the last step: one entry a cast segment, in the same order.
  const Response& response() const { return response_; }

 private:
  /// A module that the menu can choose, built before the first step.
  struct Place {
    Place(const RobotModel& robot, const WorldModel& all, const ModuleModel& model,
          const Scenario& scenario, const SimulatorConfig& config);
    const ModuleModel* module;
    std::unique_ptr<BuiltWorld> world;
    IsectorSet isectors;  ///< all that the commanded motions load
    IsectorSet support;   ///< TRIPOD alone, at the pose after the motion
    Task task;
  };

  void ObeyMenu(const OperatorCommand& command);
  void EnterModule(int id);
  void StandAtStart();
  void Cast(MotionSet wanted);
  bool Move(const MotionDemand& wanted, MotionSet limited);
  void StandOnGround();
  void UpdateAlarms(MotionSet wanted, MotionSet limited);
  void UpdateTask(uint32_t contacts_before);
  void Report(const OperatorCommand& command, const Wish& wish, MotionSet limited);

  const RobotModel& robot_;
  Scenario scenario_;
  SimulatorConfig config_;
  double dt_s_;
  std::vector<std::unique_ptr<Place>> places_;
  Place* place_ = nullptr;
  AlarmTable alarms_;
  AlarmRules alarm_rules_;
  Response response_;
  StepResult result_;
  std::vector<Eigen::Isometry3d> link_poses_;  ///< of result_.state
  int last_menu_command_ = kMenuNone;
  bool start_asked_ = false;  ///< of the mission, in this step
  bool end_asked_ = false;
  bool paused_ = false;
};

}  // namespace eod::sim
