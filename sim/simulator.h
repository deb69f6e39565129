#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "platform/time.h"
#include "sim/alarms/alarm_rules.h"
#include "sim/alarms/alarm_table.h"
#include "sim/battery/battery.h"
#include "sim/disposal/hand.h"
#include "sim/faults/fault_injector.h"
#include "sim/instructor_command.h"
#include "sim/isectors/isector_set.h"
#include "sim/motion/drives.h"
#include "sim/motion/payload.h"
#include "sim/motion/preset_run.h"
#include "sim/motion/zoom_drive.h"
#include "sim/operator_command.h"
#include "sim/place.h"
#include "sim/plume/explosion.h"
#include "sim/radio/control_link.h"
#include "sim/response/response.h"
#include "sim/robot/robot_model.h"
#include "sim/scenario/exercise_menu.h"
#include "sim/stance/flipper_bearing.h"
#include "sim/stance/tilt_guard.h"
#include "sim/world/world_model.h"

namespace eod::sim {

struct SimulatorConfig {
  Duration period = std::chrono::milliseconds(4);             ///< 1..20 ms
  Duration command_timeout = std::chrono::milliseconds(100);  ///< zero motion from this age on
  Coverage coverage = Coverage::kExtended;
  IsectorRules rules = {};
  GraspMode grasp = GraspMode::kGuarded;
  Rules exercise = {};         ///< as LoadRules gives them; they must be loaded
  bool start_mission = false;  ///< the mission runs from the first step, without the menu
  /// What menu and instructor can choose, as LoadCatalogue sorts it. Of modules that the world
  /// lacks there may be some.
  std::vector<Scenario> catalogue = {};
};

/// What one step found; copyable, and equal in two runs of the same inputs.
struct StepResult {
  int64_t step = 0;  ///< 1 for the first
  TimePoint time{};
  int module = 0;
  RobotState state;
  double speed = 0;          ///< [m/s] along the chassis' forward axis
  double turn_rate = 0;      ///< [rad/s] left positive
  double zoom = 1;           ///< magnification of the camera that zooms
  uint32_t limit_flags = 0;  ///< joints that stand on a limit, bit j is joint j
  MotionSet inhibited = 0;  ///< by a contact that stands, a limit that is pressed on, or the bridge
  int inhibit_reason = kReasonNone;  ///< of several: collision, joint limit, tilt, others
  uint32_t contact_parts = 0;
  int32_t command_sequence = 0;
  double command_age_s = -1;               ///< [s] since a command got through, negative: never
  double link_lost_s = 0;                  ///< the same once that is too long, else 0
  bool link_latched = false;               ///< the robot waits for a Reset
  double link_quality = 1;                 ///< 0..1
  double battery_v = 0;                    ///< [V]
  double battery_soc = 1;                  ///< 0..1
  bool field_estop = false;                ///< the emergency stop on the robot is pressed
  double cable_out = 0;                    ///< [m] paid out; 0 without a cable
  std::vector<AlarmChange> alarm_changes;  ///< of this step
  DisposalStatus disposal;
  Eigen::Vector3d charge = Eigen::Vector3d::Zero();  ///< where disposal.bomb_body is; 0 if none
  TaskStatus task;
  bool task_changed = false;  ///< apart from its clock
  bool operator==(const StepResult&) const = default;
};

/// The simulator of one robot in one world. Pure: no socket, clock or thread inside.
class Simulator {
 public:
  /// `world` must outlive the simulator; the robot is copied. The scenario is one that Vary has
  /// made; spreads are not looked at. Throws std::runtime_error for a scenario that does not fit
  /// the world, one of the catalogue too, a period that is out of range, or rules that nobody
  /// loaded.
  Simulator(const RobotModel& robot, const WorldModel& world, const Scenario& scenario,
            const SimulatorConfig& config);
  Simulator(const Simulator&) = delete;
  Simulator& operator=(const Simulator&) = delete;

  /// Advances by one period. `now` is the scheduled moment of this step. Never throws, and
  /// allocates nothing, unless menu or instructor enter a module or another exercise: bodies and
  /// task are made anew.
  const StepResult& Step(TimePoint now, const OperatorCommand& command);

  /// Is obeyed in the next step. False if there is no exercise of that name: then nothing of it is,
  /// but the emergency stop.
  bool Instruct(const InstructorCommand& command);

  const StepResult& last() const { return result_; }
  const AlarmTable& alarms() const { return alarms_; }
  const Task& task() const { return place_->task; }
  /// Of the mission in this module that runs or ran last.
  const Scorer& scorer() const { return place_->score; }
  /// What the last step told the scorer; valid until the next one.
  const ScoreSample& score_sample() const { return sample_; }
  /// The exercise that is loaded; without a name it is free driving.
  const Scenario& scenario() const { return *scenario_; }
  /// How many have been loaded so far; changes when another one is.
  int exercises() const { return exercises_; }
  const ModuleModel& module() const { return place_->module(); }
  const World& world() const { return place_->world; }
  const ControlLink& link() const { return link_; }
  /// What is broken now; who asks must not tell the trainee.
  const FaultInjector& faults() const { return faults_; }
  /// The movables of the module, in its order.
  std::span<const BodyState> bodies() const { return place_->bodies.states(); }
  /// Flash, fire and smoke.
  const Explosion& explosion() const { return explosion_; }
  /// Segments of the last step, cast at the pose before it.
  const IsectorSet& isectors() const { return place_->isectors; }
  /// Contacts of the last step: one entry a cast segment, in the same order.
  const Response& response() const { return response_; }

 private:
  void ObeyInstructor();
  void ObeyMenu(const OperatorCommand& command);
  void Obey(int menu_command);
  void Enter(const Scenario& scenario);  ///< one of menu_
  Place* PlaceOf(int module) const;
  Wish Hear(const OperatorCommand& command, TimePoint now) const;
  void StandAtStart();
  /// Why motions of this step may not be, apart from contacts.
  struct Inhibition {
    MotionSet limit = 0;    ///< the joint stands on its limit
    MotionSet tilt = 0;     ///< it would tilt the robot too far
    MotionSet payload = 0;  ///< what the hand holds is too heavy farther out
    MotionSet cable = 0;    ///< it holds the robot back
    MotionSet all() const { return limit | tilt | payload | cable; }
  };

  void AdvanceFaults();
  MotionDemand Want(const Wish& wish);
  Inhibition Inhibit(const MotionDemand& wanted);
  void Cast(MotionSet wanted);
  const MotionVerdict& JudgeHands(const MotionDemand& wanted);
  bool Move(const MotionDemand& wanted, const Inhibition& inhibition, const MotionVerdict& verdict);
  MotionSet TiltingMotions() const;
  void PressFlippers(MotionSet wanted);
  void StandOnGround(const RobotState& before);
  Load HeldLoad() const;
  void Zoom(const OperatorCommand& command, TimePoint now);
  void Dispose(const OperatorCommand& command);
  void UpdateAlarms(MotionSet wished, const Inhibition& inhibition);
  void UpdateTask(uint32_t contacts_before, const OperatorCommand& command);
  bool SeesObject(int camera_select);
  double LinkLost(const OperatorCommand& command);
  void NoteChecks(const OperatorCommand& command);
  void TellOfRobot();
  void TellOfCharge();
  void Judge(const OperatorCommand& command, MotionSet wished);
  void Report(const OperatorCommand& command, const Wish& wish, const Inhibition& inhibition);

  RobotModel robot_;  ///< with the lines of what the hand holds
  int probe_;         ///< index of those in robot_.isectors
  SimulatorConfig config_;
  double dt_s_;
  std::vector<std::unique_ptr<Place>> places_;
  Place* place_ = nullptr;
  Drives drives_;
  PresetRun preset_run_;
  ZoomDrive zoom_;
  Payload payload_;
  ControlLink link_;
  FaultInjector faults_;
  Battery battery_;
  AlarmTable alarms_;
  AlarmRules alarm_rules_;
  Response response_;
  Explosion explosion_;
  FlipperBearing bearing_;
  TiltGuard tilt_guard_;
  MotionSet driven_ = 0;  ///< drive motions that acted in the last Move
  StepResult result_;
  std::vector<Eigen::Isometry3d> link_poses_;  ///< of result_.state
  ExerciseMenu menu_;
  const Scenario* scenario_ = nullptr;         ///< of menu_
  std::vector<InstructorCommand> instructed_;  ///< and not obeyed yet
  CastMemory sight_;
  int exercises_ = 0;
  int last_menu_command_ = kMenuNone;
  int64_t box_lost_steps_ = 0;  ///< for which the bridge has missed the box
  bool start_asked_ = false;    ///< of the mission, in this step
  bool end_asked_ = false;
  bool instructor_ends_ = false;
  bool estopped_ = false;  ///< by the instructor
  bool paused_ = false;
  HandLayout hand_;
  uint32_t checks_ = 0;  ///< BoxCheck, since the last mission ended
  bool estop_latched_ = false;
  ScoreSample sample_;
  std::vector<double> moved_;  ///< [m] one a movable
};

}  // namespace eod::sim
