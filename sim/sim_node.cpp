#include "sim/sim_node.h"

#include <algorithm>
#include <limits>
#include <numbers>

#include "lcmtypes/channels.h"

namespace eod::sim {
namespace {

// The battery is not simulated: a full one, as a 24 V pack rests.
constexpr double kBatteryVoltage = 25.6;  // [V]

double ToDegrees(double radians) { return radians * (180 / std::numbers::pi); }

/// Writes a point of the module's frame as a point of the world's.
void PutPoint(const ModuleModel& module, const Eigen::Vector3d& p_M, double* metres) {
  Eigen::Map<Eigen::Vector3d>{metres} = module.p_WM + p_M;
}

/// The command in a message that was received at `received`.
OperatorCommand FromMessage(const box_command_t& message, TimePoint received) {
  OperatorCommand command;
  command.sequence = message.sequence;
  command.stamp = received;
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
  command.menu_command = message.menu_command;
  return command;
}

// These fill a message with what the last step found. Poses leave the module's local frame for the
// world's, radians become degrees.

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
  message.battery_v = kBatteryVoltage;
  message.battery_soc = 1;
  message.command_sequence = result.command_sequence;
}

void Fill(const Simulator& simulator, mission_status_t& message) {
  const StepResult& result = simulator.last();
  const TaskStatus& task = result.task;
  message.utime = ToUtime(result.time);
  message.scenario = simulator.scenario().name;
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

}  // namespace

SimNode::SimNode(const SimNodeConfig& config, const RobotModel& robot, const WorldModel& world,
                 const Scenario& scenario, lcm::LCM& lcm, const Clock& clock)
    : config_(config),
      robot_(robot),
      simulator_(robot, world, scenario, config.simulator),
      lcm_(lcm),
      clock_(clock),
      state_channel_(ChannelName(config.channel_prefix, kRobotStateChannel)),
      alarm_channel_(ChannelName(config.channel_prefix, kAlarmChannel)),
      mission_channel_(ChannelName(config.channel_prefix, kMissionStatusChannel)),
      isectors_channel_(ChannelName(config.channel_prefix, kIsectorHitsChannel)) {
  alarm_message_.source = alarm_t::SOURCE_SIM;
  subscription_ = lcm_.subscribe(ChannelName(config.channel_prefix, kBoxCommandChannel),
                                 &SimNode::OnCommand, this);
}

SimNode::~SimNode() { lcm_.unsubscribe(subscription_); }

void SimNode::OnCommand(const lcm::ReceiveBuffer* /*buffer*/, const std::string& /*channel*/,
                        const box_command_t* message) {
  command_ = FromMessage(*message, clock_.Now());
}

void SimNode::OnTick(TimePoint scheduled) {
  const Duration period = tick_period();
  const bool is_first = stepped_ == TimePoint{};
  if (!is_first) state_message_.overruns += (scheduled - last_tick_) / period - 1;
  last_tick_ = scheduled;
  if (is_first || scheduled - stepped_ > kLongestDebt) stepped_ = scheduled - period;
  for (int steps = 0; steps < 2 && stepped_ < scheduled; ++steps) {
    stepped_ += period;
    Step(stepped_);
  }
}

void SimNode::Step(TimePoint scheduled) {
  const StepResult& result = simulator_.Step(scheduled, command_);
  Fill(simulator_, state_message_);
  lcm_.publish(state_channel_, &state_message_);
  ++published_;
  PublishAlarms(result);
  PublishMission(result);
  if (config_.publish_isectors) {
    Fill(robot_, simulator_, isectors_message_);
    lcm_.publish(isectors_channel_, &isectors_message_);
    ++published_;
  }
  if (scene_output_.show && scheduled >= scene_due_) ShowScene(result);
}

/// A message a change, and the whole set again now and then for whoever came late.
void SimNode::PublishAlarms(const StepResult& result) {
  for (const AlarmChange& change : result.alarm_changes) {
    ++alarm_message_.sequence;
    alarm_message_.is_repeat = 0;
    alarm_message_.code = static_cast<int16_t>(change.code);
    alarm_message_.raised = change.raised ? 1 : 0;
    alarm_message_.parts = static_cast<int32_t>(change.parts);
    PublishAlarm(result.time);
  }
  if (result.time < alarms_due_) return;
  alarm_message_.is_repeat = 1;
  alarm_message_.code = 0;
  alarm_message_.raised = 0;
  alarm_message_.parts = 0;
  PublishAlarm(result.time);
}

void SimNode::PublishAlarm(TimePoint time) {
  alarm_message_.utime = ToUtime(time);
  alarm_message_.active_code.clear();
  alarm_message_.active_parts.clear();
  for (const ActiveAlarm& alarm : simulator_.alarms().active()) {
    alarm_message_.active_code.push_back(static_cast<int16_t>(alarm.code));
    alarm_message_.active_parts.push_back(static_cast<int32_t>(alarm.parts));
  }
  alarm_message_.num_active = static_cast<int16_t>(alarm_message_.active_code.size());
  lcm_.publish(alarm_channel_, &alarm_message_);
  ++published_;
  alarms_due_ = time + config_.alarm_repeat;
}

void SimNode::PublishMission(const StepResult& result) {
  if (!result.task_changed && result.time < mission_due_) return;
  Fill(simulator_, mission_message_);
  lcm_.publish(mission_channel_, &mission_message_);
  ++published_;
  mission_due_ = result.time + config_.mission_repeat;
}

/// Hands a copy of the step to the cameras, at their rate: they must never make a step wait.
void SimNode::ShowScene(const StepResult& result) {
  // The rate holds on average although pictures can only start at a step; after a gap it starts
  // anew.
  scene_due_ += scene_output_.period;
  if (scene_due_ <= result.time) scene_due_ = result.time + scene_output_.period;
  snapshot_.time = result.time;
  snapshot_.module = result.module;
  snapshot_.camera_select = command_.camera_select;
  snapshot_.state = result.state;
  snapshot_.movables.clear();
  for (const BodyState& body : simulator_.bodies()) {
    snapshot_.movables.push_back({.X_MO = body.X_MO, .is_visible = !body.is_gone});
  }
  const Explosion& explosion = simulator_.explosion();
  snapshot_.quads.assign(explosion.quads().begin(), explosion.quads().end());
  snapshot_.effects = explosion.effects();
  snapshot_.segments.clear();
  if (scene_output_.draw_isectors) {
    const auto segments = simulator_.isectors().segments();
    for (size_t i = 0; i < segments.size(); ++i) {
      const SegmentQuery& query = segments[i].query;
      snapshot_.segments.push_back({.start = query.start,
                                    .end = query.start + query.direction * query.length,
                                    .hit = segments[i].hit.hit,
                                    .contact = simulator_.response().contacts[i].contact,
                                    .point = segments[i].hit.point});
    }
  }
  scene_output_.show(snapshot_);
}

}  // namespace eod::sim
