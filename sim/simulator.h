#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "platform/time.h"
#include "sim/alarms/alarm_table.h"
#include "sim/isectors/isector_set.h"
#include "sim/motion/motion.h"
#include "sim/response/response.h"
#include "sim/robot/robot_model.h"
#include "sim/task/task.h"
#include "sim/world/world_model.h"

namespace eod::sim {

/// What the operator asks for, as the bridge passed it on.
struct OperatorCommand {
  int32_t sequence = 0;
  TimePoint stamp{};  ///< when it was received; older than `command_timeout` means zero motion
  bool motion_permitted = false;
  std::array<double, kMotionCount> motion_rate{};  ///< 0..1
  MotionSet inhibited = 0;                         ///< refused by the bridge already
  int inhibit_reason = 0;                          ///< box_command_t REASON_*
  int speed_range = 1;                             ///< 0 creep, 1 low, 2 high
  int menu_module = 0;
  int menu_command = 0;
  bool alarm_reset = false;
};

struct SimulatorConfig {
  Duration period = std::chrono::milliseconds(4);             ///< 1..20 ms
  Duration command_timeout = std::chrono::milliseconds(100);  ///< zero motion beyond
};

/// What one step found; copyable, and equal in two runs of the same inputs.
struct StepResult {
  int64_t step = 0;
  TimePoint time{};
  int module = 0;
  RobotState state;
  double speed = 0;      ///< [m/s] along the chassis' forward axis
  double turn_rate = 0;  ///< [rad/s]
  uint32_t limit_flags = 0;
  MotionSet inhibited = 0;
  int inhibit_reason = 0;
  uint32_t contact_parts = 0;
  int32_t command_sequence = 0;
  std::vector<AlarmChange> alarm_changes;  ///< of this step
  TaskStatus task;
  bool task_changed = false;
};

/// The simulator of one robot in one module. Pure: no socket, clock or thread inside.
class Simulator {
 public:
  /// Throws std::runtime_error for a scenario that does not fit the world.
  Simulator(const RobotModel& robot, const WorldModel& world, const Scenario& scenario,
            const SimulatorConfig& config);
  ~Simulator();

  /// Advances by one period. `now` is the scheduled moment of this step. Never throws.
  const StepResult& Step(TimePoint now, const OperatorCommand& command);

  const StepResult& last() const { return result_; }
  const AlarmTable& alarms() const { return alarms_; }
  const IsectorSet& isectors() const { return *isectors_; }
  /// Contacts of the last step: one entry a cast segment, in the same order.
  const Response& response() const { return response_; }
  const ModuleModel& module() const { return *module_; }

 private:
  const RobotModel& robot_;
  const WorldModel& world_model_;
  Scenario scenario_;
  SimulatorConfig config_;
  const ModuleModel* module_ = nullptr;
  std::unique_ptr<World> world_;
  std::unique_ptr<IsectorSet> isectors_;
  AlarmTable alarms_;
  Task task_;
  Response response_;
  StepResult result_;
  std::vector<Eigen::Isometry3d> link_poses_;
};

}  // namespace eod::sim
