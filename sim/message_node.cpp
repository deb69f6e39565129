#include "sim/message_node.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <numbers>

namespace eod::sim {
namespace {

double ToDegrees(double radians) { return radians * (180 / std::numbers::pi); }

/// Writes a point of the module's frame as a point of the world's.
void PutPoint(const ModuleModel& module, const Eigen::Vector3d& p_M, double* metres) {
  Eigen::Map<Eigen::Vector3d>{metres} = module.p_WM + p_M;
}

void Resize(size_t count, isector_hits_t& message) {
  message.num_segments = static_cast<int32_t>(count);
  for (auto* points : {&message.start_m, &message.end_m, &message.point_m, &message.normal}) {
    points->resize(count, std::vector<double>(3));
  }
  for (auto* texts : {&message.isector, &message.method, &message.object}) texts->resize(count);
  for (auto* numbers : {&message.range_m, &message.threshold_m}) numbers->resize(count);
  for (auto* numbers : {&message.object_class, &message.triangle}) numbers->resize(count);
  for (auto* flags : {&message.segment, &message.hit, &message.contact}) flags->resize(count);
}

/// What segment i met. Without a hit, what has no value is NaN.
void FillHit(const Simulator& simulator, const SegmentHit& hit, size_t i, isector_hits_t& message) {
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  const Eigen::Vector3d none = Eigen::Vector3d::Constant(kNone);
  message.hit[i] = hit.hit ? 1 : 0;
  message.range_m[i] = hit.hit ? hit.range : kNone;
  PutPoint(simulator.module(), hit.hit ? hit.point : none, message.point_m[i].data());
  // The module's axes are the world's.
  Eigen::Map<Eigen::Vector3d>{message.normal[i].data()} = hit.hit ? hit.normal : none;
  message.object[i] = simulator.world().ObjectName(hit.hit ? hit.object : -1);
  message.object_class[i] = hit.hit ? static_cast<int32_t>(hit.object_class) : 0;
  message.triangle[i] = hit.hit ? hit.triangle : -1;
}

void Resize(size_t count, scene_t& message) {
  message.num_objects = static_cast<int16_t>(count);
  message.name.resize(count);
  message.position_m.resize(count, std::vector<double>(3));
  for (auto* numbers : {&message.heading_deg, &message.tilt_deg}) numbers->resize(count);
  for (auto* flags : {&message.is_movable, &message.is_held, &message.is_gone}) {
    flags->assign(count, 0);
  }
}

/// Object i of the scene: its pose, and the point of it [m] that is told as its position.
void FillObject(const std::string& name, const Eigen::Isometry3d& X_MO, const Eigen::Vector3d& p_O,
                size_t i, scene_t& message) {
  const Eigen::Matrix3d& R_MO = X_MO.linear();
  message.name[i] = name;
  Eigen::Map<Eigen::Vector3d>{message.position_m[i].data()} = X_MO * p_O;
  message.heading_deg[i] = ToDegrees(WrapHeading(std::atan2(-R_MO(0, 1), R_MO(1, 1))));
  message.tilt_deg[i] = ToDegrees(std::acos(std::clamp(R_MO(2, 2), -1.0, 1.0)));
}

}  // namespace

OperatorCommand ToCommand(const box_command_t& message, TimePoint received) {
  OperatorCommand command;
  command.sequence = message.sequence;
  command.stamp = command.heard = received;
  command.resets = message.resets;
  command.motion_permitted = message.motion_permitted != 0;
  command.safe_stop = message.system_state == box_command_t::STATE_SAFE_STOP;
  std::copy_n(message.motion_rate, kMotionCount, command.motion_rate.begin());
  command.inhibited = static_cast<MotionSet>(message.inhibit_mask);
  command.inhibit_reason = message.inhibit_reason;
  command.speed_range = message.speed_range;
  command.preset = message.preset;
  command.fire = {.arm_key = message.arm_key,
                  .fire_left = message.fire_left,
                  .fire_right = message.fire_right,
                  .circuit = message.circuit,
                  .nonce_echo = message.nonce_echo};
  command.system_state = message.system_state;
  command.lamp_test = message.lamp_test != 0;
  command.horn = message.horn != 0;
  command.camera_select = message.camera_select;
  command.camera_zoom = message.camera_zoom;
  // 0 off, 1 drive, 2 gripper, 3 both.
  command.lights = {.drive = (message.light & 1) != 0,
                    .gripper = (message.light & 2) != 0,
                    .infrared = message.infrared != 0};
  command.menu_module = message.menu_module;
  command.menu_exercise = message.menu_exercise;
  command.menu_command = message.menu_command;
  return command;
}

InstructorCommand ToCommand(const instructor_command_t& message) {
  return {.scenario = message.scenario,
          .repetition = static_cast<uint64_t>(std::max(message.repetition, 0)),
          .menu_command = message.menu_command,
          .estop = message.estop != 0};
}

namespace {

/// What the judge hears, in the message's words: ToSample reads the same again.
void FillJudged(const ScoreSample& sample, robot_state_t& message) {
  message.step = sample.step;
  message.module = static_cast<int8_t>(sample.module);
  Eigen::Map<Eigen::Vector3d>{message.position_m} = sample.position;
  message.heading_deg = sample.heading_deg;
  message.pitch_deg = sample.pitch_deg;
  message.roll_deg = sample.roll_deg;
  message.speed_mps = sample.speed_mps;
  message.turn_rate_dps = sample.turn_rate_dps;
  std::copy(sample.joint.begin(), sample.joint.end(), message.joint);
  message.limit_flags = static_cast<int16_t>(sample.limit_flags);
  message.inhibit_mask = static_cast<int32_t>(sample.inhibit_mask);
  message.contact_parts = static_cast<int32_t>(sample.contact_parts);
  message.held_object = sample.held_object;
  message.fire_state = static_cast<int8_t>(sample.fire_state);
  message.system_state = static_cast<int8_t>(sample.system_state);
  message.speed_range = static_cast<int8_t>(sample.speed_range);
  message.camera_select = static_cast<int8_t>(sample.camera_select);
  message.horn = sample.horn ? 1 : 0;
  message.arm_key = static_cast<int8_t>(sample.arm_key);
  message.fire_left = static_cast<int8_t>(sample.fire_left);
  message.fire_right = static_cast<int8_t>(sample.fire_right);
  message.checks = static_cast<int32_t>(sample.checks);
  message.wanted_mask = static_cast<int32_t>(sample.wanted_mask);
  message.blocked_mask = static_cast<int32_t>(sample.blocked_mask);
  message.contact_object = sample.contact_object;
  message.contact_by_held = sample.contact_by_held ? 1 : 0;
  message.ahead_m = sample.ahead_m;
  message.ahead_object = sample.ahead_object;
  message.charge = sample.charge;
  Eigen::Map<Eigen::Vector3d>{message.charge_m} = sample.charge_position;
  message.charge_low_m = sample.charge_low_m;
  Eigen::Map<Eigen::Vector3d>{message.charge_in_hand_m} = sample.charge_in_hand;
  message.charge_touched = sample.charge_touched ? 1 : 0;
  message.bomb_state = static_cast<int8_t>(sample.bomb_state);
  message.num_movables = static_cast<int16_t>(sample.moved_m.size());
  message.moved_m.assign(sample.moved_m.begin(), sample.moved_m.end());
  message.mission_state = static_cast<int8_t>(sample.mission_state);
  message.mission_step = static_cast<int8_t>(sample.mission_step);
  message.fail_reason = static_cast<int8_t>(sample.fail_reason);
  message.mission_s = sample.mission_s;
}

}  // namespace

ScoreSample ToSample(const robot_state_t& message) {
  ScoreSample sample;
  sample.step = message.step;
  sample.module = message.module;
  sample.position = Eigen::Map<const Eigen::Vector3d>{message.position_m};
  sample.heading_deg = message.heading_deg;
  sample.pitch_deg = message.pitch_deg;
  sample.roll_deg = message.roll_deg;
  sample.speed_mps = message.speed_mps;
  sample.turn_rate_dps = message.turn_rate_dps;
  std::copy(std::begin(message.joint), std::end(message.joint), sample.joint.begin());
  sample.limit_flags = static_cast<uint16_t>(message.limit_flags);
  sample.inhibit_mask = static_cast<uint32_t>(message.inhibit_mask);
  sample.contact_parts = static_cast<uint32_t>(message.contact_parts);
  sample.held_object = message.held_object;
  sample.fire_state = message.fire_state;
  sample.system_state = message.system_state;
  sample.speed_range = message.speed_range;
  sample.camera_select = message.camera_select;
  sample.horn = message.horn != 0;
  sample.arm_key = message.arm_key;
  sample.fire_left = message.fire_left;
  sample.fire_right = message.fire_right;
  sample.checks = static_cast<uint32_t>(message.checks);
  sample.wanted_mask = static_cast<uint32_t>(message.wanted_mask);
  sample.blocked_mask = static_cast<uint32_t>(message.blocked_mask);
  sample.contact_object = message.contact_object;
  sample.contact_by_held = message.contact_by_held != 0;
  sample.ahead_m = message.ahead_m;
  sample.ahead_object = message.ahead_object;
  sample.charge = message.charge;
  sample.charge_position = Eigen::Map<const Eigen::Vector3d>{message.charge_m};
  sample.charge_low_m = message.charge_low_m;
  sample.charge_in_hand = Eigen::Map<const Eigen::Vector3d>{message.charge_in_hand_m};
  sample.charge_touched = message.charge_touched != 0;
  sample.bomb_state = message.bomb_state;
  sample.moved_m = message.moved_m;
  sample.mission_state = message.mission_state;
  sample.mission_step = message.mission_step;
  sample.fail_reason = message.fail_reason;
  sample.mission_s = message.mission_s;
  return sample;
}

void Fill(const Simulator& simulator, robot_state_t& message) {
  const StepResult& result = simulator.last();
  message.utime = ToUtime(result.time);
  FillJudged(simulator.score_sample(), message);
  message.inhibit_reason = static_cast<int8_t>(result.inhibit_reason);
  const DisposalStatus& disposal = result.disposal;
  message.grasp_state = static_cast<int8_t>(disposal.grasp);
  message.fire_nonce = static_cast<int16_t>(disposal.fire_nonce);
  message.circuit_continuity = static_cast<int8_t>(disposal.circuit_continuity);
  message.battery_v = result.battery_v;
  message.battery_soc = result.battery_soc;
  message.field_estop = result.field_estop ? 1 : 0;
  message.dark_lamps = static_cast<int16_t>(simulator.faults().active().dark_lamps);
  message.command_sequence = result.command_sequence;
  message.command_age_ms =
      result.command_age_s < 0 ? -1 : static_cast<int32_t>(1000 * result.command_age_s);
  message.link_quality = result.link_quality;
  message.link_latched = result.link_latched ? 1 : 0;
  message.cable_m = result.cable_out;
}

void ShowOffsets(const ActiveFaults& faults, robot_state_t& message) {
  for (int j = 0; j < kJointCount; ++j) {
    const double offset = faults.joint_offset[j];
    message.joint[j] += j == kGripperOpening ? offset : ToDegrees(offset);
  }
}

void Fill(const FaultInjector& faults, const FaultChange& change, fault_event_t& message) {
  const auto& spec = faults.specs()[static_cast<size_t>(change.index)];
  message.code = fault_event_t::CODE_FAULT;
  message.index = static_cast<int16_t>(change.index);
  message.begins = change.begins ? 1 : 0;
  message.kind = NameOf(spec.kind);
  message.target = spec.target;
  message.amount = spec.amount;
}

void Fill(const Simulator& simulator, mission_status_t& message) {
  const StepResult& result = simulator.last();
  const TaskStatus& task = result.task;
  message.utime = ToUtime(result.time);
  message.scenario = simulator.scenario().name;
  message.title = simulator.scenario().title;
  message.difficulty = static_cast<int8_t>(simulator.scenario().difficulty);
  message.repetition = static_cast<int64_t>(simulator.scenario().repetition);
  message.module = static_cast<int8_t>(result.module);
  message.state = static_cast<int8_t>(task.state);
  message.elapsed_s = task.elapsed_s;
  message.step = static_cast<int8_t>(task.step);
  message.steps = static_cast<int8_t>(task.steps);
  message.step_text = simulator.task().step_text();
  message.score = task.score;
  message.collisions = task.collisions;
  message.bomb_state = static_cast<int8_t>(result.disposal.bomb);
  message.fail_reason = static_cast<int8_t>(task.fail_reason);
}

void Fill(const RobotModel& robot, const Simulator& simulator, isector_hits_t& message) {
  const std::span<const CastSegment> segments = simulator.isectors().segments();
  message.utime = ToUtime(simulator.last().time);
  message.step = simulator.last().step;
  Resize(segments.size(), message);
  for (size_t i = 0; i < segments.size(); ++i) {
    const CastSegment& cast = segments[i];
    const IsectorSpec& isector = robot.isectors[cast.isector];
    const SegmentContact& contact = simulator.response().contacts[i];
    const Eigen::Vector3d p_M = cast.query.start + cast.query.direction * cast.query.length;
    message.isector[i] = isector.name;
    message.method[i] = NameOf(isector.method);
    message.segment[i] = static_cast<int8_t>(cast.segment);
    PutPoint(simulator.module(), cast.query.start, message.start_m[i].data());
    PutPoint(simulator.module(), p_M, message.end_m[i].data());
    FillHit(simulator, cast.hit, i, message);
    message.threshold_m[i] = contact.threshold;
    message.contact[i] = contact.contact ? 1 : 0;
  }
}

void Fill(const Simulator& simulator, scene_t& message) {
  const ModuleModel& module = simulator.module();
  const std::span<const BodyState> bodies = simulator.bodies();
  message.utime = ToUtime(simulator.last().time);
  message.module = static_cast<int8_t>(simulator.last().module);
  PutPoint(module, Eigen::Vector3d::Zero(), message.origin_m);
  Resize(bodies.size() + module.objects.size(), message);
  for (size_t i = 0; i < bodies.size(); ++i) {
    const MovableObject& movable = module.movables[i];
    FillObject(movable.name, bodies[i].X_MO, movable.p_OC, i, message);
    message.is_movable[i] = 1;
    message.is_held[i] = bodies[i].is_held ? 1 : 0;
    message.is_gone[i] = bodies[i].is_gone ? 1 : 0;
  }
  for (size_t i = 0; i < module.objects.size(); ++i) {
    const WorldObject& fixed = module.objects[i];
    FillObject(fixed.name, fixed.X_MO, Eigen::Vector3d::Zero(), bodies.size() + i, message);
  }
}

}  // namespace eod::sim
