#include "canbridge/feedback.h"

#include <cmath>

namespace eod::bridge {
namespace {

using dbc::Lamp;
using dbc::LampPattern;

LampPattern OnIf(bool is_on) { return is_on ? LampPattern::kOn : LampPattern::kOff; }

// ROB_JOINT_C.GraspState.
LampPattern GraspLamp(int grasp_state) {
  switch (grasp_state) {
    case 2:  // contact left
    case 3:  // contact right
    case 4:  // contact both
      return LampPattern::kSlowBlink;
    case 5:  // grasped
      return LampPattern::kOn;
    case 6:  // slipping
      return LampPattern::kFastBlink;
    default:
      return LampPattern::kOff;
  }
}

// ROB_STATUS.MissionState.
LampPattern MissionLamp(int mission_state) {
  switch (mission_state) {
    case 1:  // brief
      return LampPattern::kSlowBlink;
    case 2:  // run
    case 3:  // success
      return LampPattern::kOn;
    case 4:  // fail
    case 5:  // abort
      return LampPattern::kFastBlink;
    default:
      return LampPattern::kOff;
  }
}

// ROB_FIRE.FireState.
constexpr int kFireReady = 2;
constexpr int kFireFired = 3;
constexpr int kFireFault = 4;

LampPattern ArmedLamp(int fire_state, bool is_key_armed) {
  if (fire_state == kFireFault) return LampPattern::kFastBlink;
  if (fire_state == kFireReady) return LampPattern::kSlowBlink;
  return OnIf(is_key_armed);
}

std::array<LampPattern, dbc::kLampCount> ComposeLamps(const FeedbackSources& sources) {
  std::array<LampPattern, dbc::kLampCount> lamps{};
  const auto set = [&lamps](Lamp lamp, LampPattern pattern) {
    lamps[static_cast<std::size_t>(lamp)] = pattern;
  };
  const dbc::SystemState state = sources.supervision.state;
  set(Lamp::kPower, LampPattern::kOn);
  set(Lamp::kLink, OnIf(sources.is_link_alive));
  set(Lamp::kEstop, OnIf(state == dbc::SystemState::kEstopLatched));
  set(Lamp::kDeadman,
      OnIf(sources.is_link_alive && sources.panel.deadman == dbc::Deadman::kEnabled));
  set(Lamp::kGrasp, GraspLamp(sources.robot.grasp_state));
  set(Lamp::kMission, MissionLamp(sources.mission.state));
  const int fire_state = sources.is_simulator_alive ? sources.robot.fire_state : 0;
  const bool is_key_armed =
      sources.is_fire_key_seen && sources.panel.arm_key == dbc::FireContact::kOn;
  set(Lamp::kArmed, ArmedLamp(fire_state, is_key_armed));
  set(Lamp::kFired, OnIf(fire_state == kFireFired));
  if (state == dbc::SystemState::kFault) set(Lamp::kFault, LampPattern::kFastBlink);
  set(Lamp::kCamera,
      OnIf(sources.is_panel_seen && sources.panel.camera != dbc::CameraSelect::kNotAvailable));
  for (std::size_t i = 0; i < lamps.size(); ++i) {
    if (sources.alarms.lamp[i] != LampPattern::kOff) lamps[i] = sources.alarms.lamp[i];
    if ((sources.robot.dark_lamps >> i & 1U) != 0) lamps[i] = LampPattern::kOff;
  }
  return lamps;
}

double WrapHeading(double heading_deg) {
  double wrapped = std::fmod(heading_deg, 360.0);
  if (wrapped < 0) wrapped += 360.0;
  // From 359.995 on it would round up to 360.00, which the signal does not have.
  return wrapped < 359.995 ? wrapped : 0.0;
}

}  // namespace

dbc::RobotFeedback ComposeFeedback(const FeedbackSources& sources) {
  const RobotReport& robot = sources.robot;
  const MissionReport& mission = sources.mission;
  dbc::RobotFeedback feedback;
  feedback.state = sources.supervision.state;
  feedback.module = robot.module >= 0 && robot.module <= static_cast<int>(dbc::Module::kIndoor)
                        ? static_cast<dbc::Module>(robot.module)
                        : dbc::Module::kNone;
  feedback.mission_state = mission.state;
  feedback.is_simulator = true;
  feedback.inhibit_mask = sources.supervision.inhibit_mask | robot.inhibit_mask;
  feedback.inhibit_reason = Gravest(sources.supervision.reason, robot.inhibit_reason);
  feedback.buzzer = sources.alarms.buzzer != dbc::BuzzerPattern::kOff ? sources.alarms.buzzer
                                                                      : sources.mission_sound;
  feedback.lamp = ComposeLamps(sources);
  feedback.hit_parts = sources.alarms.hit_parts;
  feedback.alarm_code = sources.alarms.code;
  feedback.joint = robot.joint;
  feedback.limit_flags = robot.limit_flags;
  feedback.grasp_state = robot.grasp_state;
  feedback.heading_deg = WrapHeading(robot.heading_deg);
  feedback.pitch_deg = robot.pitch_deg;
  feedback.roll_deg = robot.roll_deg;
  feedback.battery_v = robot.battery_v;
  feedback.battery_soc = robot.battery_soc;
  feedback.elapsed_s = mission.elapsed_s;
  feedback.score = mission.score;
  feedback.step = mission.step;
  feedback.steps = mission.steps;
  feedback.bomb_state = mission.bomb_state;
  feedback.fail_reason = mission.fail_reason;
  feedback.collisions = mission.collisions;
  if (sources.is_simulator_alive) {
    feedback.speed_mps = robot.speed_mps;
    feedback.fire_state = robot.fire_state;
    feedback.nonce = robot.fire_nonce;
    feedback.circuit_continuity = robot.circuit_continuity;
  }
  return feedback;
}

bool DiffersInStatus(const dbc::RobotFeedback& a, const dbc::RobotFeedback& b) {
  return a.state != b.state || a.module != b.module || a.mission_state != b.mission_state ||
         a.inhibit_mask != b.inhibit_mask || a.inhibit_reason != b.inhibit_reason;
}

bool DiffersInAlarm(const dbc::RobotFeedback& a, const dbc::RobotFeedback& b) {
  return a.buzzer != b.buzzer || a.lamp != b.lamp || a.hit_parts != b.hit_parts ||
         a.alarm_code != b.alarm_code;
}

bool DiffersInFire(const dbc::RobotFeedback& a, const dbc::RobotFeedback& b) {
  return a.fire_state != b.fire_state || a.nonce != b.nonce ||
         a.circuit_continuity != b.circuit_continuity;
}

}  // namespace eod::bridge
