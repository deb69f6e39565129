#include "sim/message_node.h"

#include <algorithm>
#include <cmath>
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
  command.camera_select = message.camera_select;
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

void Fill(const Simulator& simulator, robot_state_t& message) {
  const StepResult& result = simulator.last();
  const RobotState& state = result.state;
  message.utime = ToUtime(result.time);
  message.step = result.step;
  message.module = static_cast<int8_t>(result.module);
  PutPoint(simulator.module(), state.position, message.position_m);
  message.heading_deg = ToDegrees(state.attitude.heading);
  message.pitch_deg = ToDegrees(state.attitude.pitch);
  message.roll_deg = ToDegrees(state.attitude.roll);
  message.speed_mps = result.speed;
  message.turn_rate_dps = ToDegrees(result.turn_rate);
  for (int j = 0; j < kJointCount; ++j) {
    message.joint[j] = j == kGripperOpening ? state.joint[j] : ToDegrees(state.joint[j]);
  }
  message.limit_flags = static_cast<int16_t>(result.limit_flags);
  message.inhibit_mask = static_cast<int32_t>(result.inhibited);
  message.inhibit_reason = static_cast<int8_t>(result.inhibit_reason);
  message.contact_parts = static_cast<int32_t>(result.contact_parts);
  const DisposalStatus& disposal = result.disposal;
  message.grasp_state = static_cast<int8_t>(disposal.grasp);
  message.held_object =
      disposal.held_body < 0
          ? ""
          : simulator.module().movables[static_cast<size_t>(disposal.held_body)].name;
  message.fire_state = static_cast<int8_t>(disposal.fire);
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
