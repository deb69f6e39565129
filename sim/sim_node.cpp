#include "sim/sim_node.h"

#include <algorithm>
#include <array>
#include <cstdio>

#include <fmt/core.h>

#include "lcmtypes/channels.h"
#include "sim/message_node.h"

namespace eod::sim {
namespace {

constexpr std::array<std::pair<uint8_t, CameraFault::Kind>, 4> kCameraFaults{
    {{kCameraDeadBit, CameraFault::Kind::kDead},
     {kCameraFrozenBit, CameraFault::Kind::kFrozen},
     {kCameraNoisyBit, CameraFault::Kind::kNoisy},
     {kCameraWrongLightBit, CameraFault::Kind::kWrongLight}}};
constexpr size_t kMostPictures = 64;  // under way: a second of them at their highest rate

/// Whether the operator's side may hear less, later or other than the truth.
bool NeedsLink(const Scenario& scenario) {
  const auto falsifies = [](const FaultSpec& fault) {
    return fault.kind == FaultSpec::Kind::kRadioLoss ||
           fault.kind == FaultSpec::Kind::kSensorOffset;
  };
  return !IsPlain(scenario.link) || std::ranges::any_of(scenario.faults, falsifies);
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
      fault_channel_(ChannelName(config.channel_prefix, kFaultEventChannel)),
      alarm_channel_(ChannelName(config.channel_prefix, kAlarmChannel)),
      mission_channel_(ChannelName(config.channel_prefix, kMissionStatusChannel)),
      isectors_channel_(ChannelName(config.channel_prefix, kIsectorHitsChannel)),
      scene_channel_(ChannelName(config.channel_prefix, kSceneChannel)) {
  alarm_message_.source = alarm_t::SOURCE_SIM;
  Connect();
  subscription_ = lcm_.subscribe(ChannelName(config.channel_prefix, kBoxCommandChannel),
                                 &SimNode::OnCommand, this);
  instructor_ = lcm_.subscribe(ChannelName(config.channel_prefix, kInstructorChannel),
                               &SimNode::OnInstructor, this);
}

SimNode::~SimNode() {
  lcm_.unsubscribe(subscription_);
  lcm_.unsubscribe(instructor_);
}

/// As the exercise wants it; what was under way is lost.
void SimNode::Connect() {
  const Scenario& scenario = simulator_.scenario();
  const ControlLinkSpec& link = scenario.link;
  connected_ = simulator_.exercises();
  link_.reset();
  if (NeedsLink(scenario)) {
    link_.reset(
        new Link{.commands = CommandLink(link.commands, scenario.seed),
                 .telemetry = TelemetryNode(link.telemetry, scenario.seed, config_.simulator.period,
                                            config_.channel_prefix, lcm_),
                 .pictures = {link.pictures, scenario.seed, LinkStream::kPictures, kMostPictures}});
  }
  state_message_.relayed = alarm_message_.relayed = mission_message_.relayed = link_ ? 1 : 0;
}

void SimNode::OnCommand(const lcm::ReceiveBuffer* /*buffer*/, const std::string& /*channel*/,
                        const box_command_t* message) {
  const TimePoint now = clock_.Now();
  if (link_) {
    link_->commands.Send(now, ToCommand(*message, now), simulator_.link().drop_chance());
  } else {
    command_ = ToCommand(*message, now);
  }
}

void SimNode::OnInstructor(const lcm::ReceiveBuffer* /*buffer*/, const std::string& /*channel*/,
                           const instructor_command_t* message) {
  InstructorCommand command;
  if (instructed_ != message->sequence) command = ToCommand(*message);
  command.estop = message->estop != 0;
  instructed_ = message->sequence;
  if (!simulator_.Instruct(command)) {
    fmt::print(stderr, "no exercise '{}'\n", message->scenario);
  }
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
  if (link_) link_->commands.Receive(scheduled, command_);
  const StepResult& result = simulator_.Step(scheduled, command_);
  if (simulator_.exercises() != connected_) Connect();
  PublishState();
  PublishFaults(result);
  PublishAlarms(result);
  PublishMission(result);
  PublishScene(result);
  if (config_.publish_isectors) {
    Fill(robot_, simulator_, isectors_message_);
    lcm_.publish(isectors_channel_, &isectors_message_);
    ++published_;
  }
  if (link_) published_ += link_->telemetry.Deliver(scheduled);
  if (scene_output_.show) ShowScene(result);
}

/// The truth, and a copy of it that sets out for the operator's side.
template <typename Message>
void SimNode::Publish(const std::string& channel, const Message& message) {
  lcm_.publish(channel, &message);
  ++published_;
  Relay(message);
}

template <typename Message>
void SimNode::Relay(const Message& message) {
  if (!link_) return;
  link_->telemetry.Send(simulator_.last().time, message, simulator_.link().drop_chance());
}

void SimNode::PublishState() {
  Fill(simulator_, state_message_);
  lcm_.publish(state_channel_, &state_message_);
  ++published_;
  if (!link_) return;
  shown_message_ = state_message_;
  ShowOffsets(simulator_.faults().active(), shown_message_);
  Relay(shown_message_);
}

void SimNode::PublishFaults(const StepResult& result) {
  for (const FaultChange& change : simulator_.faults().changes()) {
    Fill(simulator_.faults(), change, fault_message_);
    fault_message_.utime = ToUtime(result.time);
    fault_message_.step = result.step;
    lcm_.publish(fault_channel_, &fault_message_);
    ++published_;
  }
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
  Publish(alarm_channel_, alarm_message_);
  alarms_due_ = time + config_.alarm_repeat;
}

void SimNode::PublishMission(const StepResult& result) {
  if (!result.task_changed && result.time < mission_due_) return;
  Fill(simulator_, mission_message_);
  Publish(mission_channel_, mission_message_);
  mission_due_ = result.time + config_.mission_repeat;
}

void SimNode::PublishScene(const StepResult& result) {
  const bool is_other_module = scene_message_.module != result.module;
  if (!is_other_module && !result.task_changed && result.time < scene_message_due_) return;
  Fill(simulator_, scene_message_);
  lcm_.publish(scene_channel_, &scene_message_);
  ++published_;
  scene_message_due_ = result.time + config_.scene_repeat;
}

/// Hands a copy of the step to the cameras, at their rate: they must never make a step wait.
void SimNode::ShowScene(const StepResult& result) {
  if (result.time >= scene_due_) TakeScene(result);
  if (!link_) return;
  while (const SceneSnapshot* arrived = link_->pictures.Receive(result.time)) {
    scene_output_.show(*arrived);
  }
}

void SimNode::TakeScene(const StepResult& result) {
  // The rate holds on average although pictures can only start at a step; after a gap it starts
  // anew.
  scene_due_ += scene_output_.period;
  if (scene_due_ <= result.time) scene_due_ = result.time + scene_output_.period;
  SceneSnapshot* snapshot =
      link_ ? link_->pictures.Send(result.time, simulator_.link().drop_chance()) : &snapshot_;
  if (snapshot == nullptr) return;
  FillScene(result, *snapshot);
  if (!link_) scene_output_.show(*snapshot);
}

void SimNode::FillScene(const StepResult& result, SceneSnapshot& snapshot) const {
  snapshot.time = result.time;
  snapshot.link_quality = static_cast<float>(result.link_quality);
  snapshot.module = result.module;
  snapshot.camera_select = command_.camera_select;
  snapshot.weather = simulator_.scenario().weather;
  snapshot.lights = command_.lights;
  snapshot.zoom = result.zoom;
  snapshot.state = result.state;
  snapshot.movables.clear();
  for (const BodyState& body : simulator_.bodies()) {
    snapshot.movables.push_back({.X_MO = body.X_MO, .is_visible = !body.is_gone});
  }
  snapshot.seed = static_cast<uint32_t>(simulator_.scenario().seed);
  snapshot.faults.clear();
  for (size_t i = 0; i < robot_.cameras.size(); ++i) {
    for (const auto& [bit, kind] : kCameraFaults) {
      if ((simulator_.faults().active().camera.at(i) & bit) == 0) continue;
      snapshot.faults.push_back({.camera = robot_.cameras[i].name, .kind = kind});
    }
  }
  const Explosion& explosion = simulator_.explosion();
  snapshot.quads.assign(explosion.quads().begin(), explosion.quads().end());
  snapshot.effects = explosion.effects();
  snapshot.segments.clear();
  if (scene_output_.draw_isectors) {
    const auto segments = simulator_.isectors().segments();
    for (size_t i = 0; i < segments.size(); ++i) {
      const SegmentQuery& query = segments[i].query;
      snapshot.segments.push_back({.start = query.start,
                                   .end = query.start + query.direction * query.length,
                                   .hit = segments[i].hit.hit,
                                   .contact = simulator_.response().contacts[i].contact,
                                   .point = segments[i].hit.point});
    }
  }
}

}  // namespace eod::sim
