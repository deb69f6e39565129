#include "sim/simulator.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

#include "sim/faults/faulty_motion.h"
#include "sim/sight.h"
#include "sim/stance/standing.h"

namespace eod::sim {
namespace {

double SignedRate(const RobotModel& robot, const MotionDemand& demand, int positive, int negative) {
  return demand.rate[positive] * RatedSpeed(robot, positive, demand.speed_range) -
         demand.rate[negative] * RatedSpeed(robot, negative, demand.speed_range);
}

}  // namespace

Simulator::Simulator(const RobotModel& robot, const WorldModel& world, const Scenario& scenario,
                     const SimulatorConfig& config)
    : robot_(robot),
      probe_(AppendHeldProbe(robot_)),
      config_(config),
      dt_s_(ToSeconds(config.period)),
      drives_(robot_),
      preset_run_(robot_),
      zoom_(robot_, dt_s_),
      payload_(robot_),
      link_(scenario.link, config.exercise.link, dt_s_),
      faults_(scenario, robot_),
      battery_(robot_),
      alarm_rules_(config.exercise.tilt),
      explosion_(config.exercise.explosion),
      menu_(scenario, config.catalogue),
      start_asked_(config.start_mission),
      hand_(robot_) {
  using std::chrono::milliseconds;
  if (config.period < milliseconds(1) || config.period > milliseconds(20)) {
    throw std::runtime_error(
        fmt::format("step period {} ms, allowed 1 .. 20 ms", 1000 * ToSeconds(config.period)));
  }
  if (config.exercise.file.empty()) throw std::runtime_error("simulator: no rules were loaded");
  CheckFits(scenario, world);
  for (const ModuleModel& module : world.modules) {
    places_.push_back(std::make_unique<Place>(robot_, probe_, world, module, config));
  }
  for (const Scenario& one : config.catalogue) {
    if (PlaceOf(one.module) != nullptr) CheckFits(one, world);
  }
  result_.alarm_changes.reserve(16);
  size_t movables = 0;
  for (const ModuleModel& module : world.modules)
    movables = std::max(movables, module.movables.size());
  moved_.reserve(movables);
  // Every list grows to its full length now, so that no step has to allocate.
  for (const auto& place : places_) {
    place_ = place.get();
    StandAtStart();
    Cast(kAllMotions);
    const Sight ahead{.p_M = {0, 10, 0.5}, .distance = 100, .object = {}};
    for (const CameraSpec& camera : robot_.cameras) {
      Sees(camera, link_poses_, place_->world, ahead, sight_);
    }
  }
  size_t lines = 0;
  for (const IsectorSpec& isector : robot_.isectors) lines += isector.segments.size();
  response_.contacts.reserve(lines);
  response_.held.reserve(lines);
  Enter(menu_.loaded());
}

const StepResult& Simulator::Step(TimePoint now, const OperatorCommand& command) {
  ++result_.step;
  result_.time = now;
  ObeyInstructor();
  ObeyMenu(command);
  AdvanceFaults();
  const ActiveFaults& faults = faults_.active();
  const Wish wish = Hear(command, now);
  const MotionDemand wanted = Want(wish);
  const Inhibition inhibition = Inhibit(wanted);
  const uint32_t contacts_before = result_.contact_parts;

  Cast(wanted.commanded);
  Respond(robot_, result_.state, link_poses_, place_->isectors.segments(), wanted,
          {.dt_s = dt_s_, .with_factor = config_.rules.distance_factor}, response_);
  const MotionVerdict& verdict = JudgeHands(wanted);
  PressFlippers(wish.demand.commanded);
  const RobotState before = result_.state;
  // A robot that stands still stands where it stood, to the last bit.
  if (Move(wanted, inhibition, verdict) || !before.at_rest) StandOnGround(before);
  Dispose(command);
  Zoom(command, now);
  link_.Advance(place_->world, result_.state, faults.silent, faults.snagged);
  battery_.Advance(wanted, faults.battery_sag, dt_s_);
  Report(command, wish, inhibition);
  UpdateAlarms(wish.demand.commanded, inhibition);
  UpdateTask(contacts_before, command);
  Judge(command, wish.demand.commanded);
  return result_;
}

void Simulator::StandAtStart() {
  result_.module = place_->module().id;
  result_.state = HomeState(robot_);
  const StartPose start = place_->Start();
  result_.state.position = start.p_M;
  result_.state.attitude = start.attitude;
  result_.contact_parts = 0;
  response_.held.clear();
  drives_.HaltAll();
  bearing_.Reset();
  tilt_guard_.Reset();
  zoom_.Reset();
  result_.zoom = zoom_.magnification();
  LinkPoses(robot_, result_.state, link_poses_);
  if (config_.coverage == Coverage::kExtended) {
    result_.state = place_->stance.PutDown(place_->world, result_.state, link_poses_);
    LinkPoses(robot_, result_.state, link_poses_);
  } else {
    StandOnGround(result_.state);
  }
}

/// Things break while the mission runs.
void Simulator::AdvanceFaults() {
  const TaskStatus& task = place_->task.status();
  faults_.Advance({.dt_s = dt_s_,
                   .running = task.state == MissionState::kRun,
                   .elapsed_s = task.elapsed_s,
                   .steps_done = task.step,
                   .holds_charge = place_->disposal.status().held_body >= 0});
}

/// What the motors do about a wish, its preset included.
MotionDemand Simulator::Want(const Wish& wish) {
  MotionDemand wanted = wish.demand;
  const MotionDemand preset = preset_run_.Demand(wish.preset, result_.state, dt_s_);
  for (int motion = 0; motion < kMotionCount; ++motion) wanted.rate[motion] += preset.rate[motion];
  wanted.commanded |= preset.commanded;
  // Doubt is no moment to run out gently; and a wreck obeys no one.
  if (!wish.trusted || result_.disposal.robot_destroyed) drives_.HaltAll();
  if (result_.disposal.robot_destroyed) return {};
  return FaultyMotion(robot_, faults_.active(), drives_.Follow(wanted, dt_s_, wish.brakes));
}

Simulator::Inhibition Simulator::Inhibit(const MotionDemand& wanted) {
  return {.limit = LimitedMotions(robot_, result_.state) & wanted.commanded,
          .tilt = TiltingMotions() & wanted.commanded,
          .payload = payload_.Forbidden(result_.state, wanted, place_->disposal.held_mass(), dt_s_),
          .cable = link_.ForbiddenMotions(result_.state) & wanted.commanded};
}

void Simulator::Cast(MotionSet wanted) {
  place_->isectors.Silence(bearing_.motions());
  place_->isectors.Cast(place_->world, link_poses_, wanted | response_.Watched(), result_.step);
}

/// Drive motions that would tilt the robot too far; all of them once it rolls over.
MotionSet Simulator::TiltingMotions() const {
  return result_.state.rolls_over ? kChassisMotions : tilt_guard_.refused();
}

/// What the lines found says to hands and charges.
const MotionVerdict& Simulator::JudgeHands(const MotionDemand& wanted) {
  return place_->disposal.Judge({.dt_s = dt_s_,
                                 .state = &result_.state,
                                 .X_ML = link_poses_,
                                 .segments = place_->isectors.segments(),
                                 .demand = &wanted,
                                 .bodies = place_->bodies.states(),
                                 .movable_of_object = place_->movable_of_object(),
                                 .payload = payload_.Limit(link_poses_),
                                 .pads_slip = faults_.active().gripper_slips},
                                response_);
}

/// A flipper that is pressed on against the ground begins to bear.
void Simulator::PressFlippers(MotionSet wanted) {
  if (config_.coverage != Coverage::kExtended) return;
  MotionSet pressed = 0;
  const std::span<const CastSegment> segments = place_->isectors.segments();
  for (size_t i = 0; i < segments.size(); ++i) {
    const MotionSet blocks = response_.contacts[i].blocks;
    if (FlipperBearing::StopsOnGround(robot_, segments[i], blocks)) pressed |= blocks;
  }
  bearing_.Press(robot_.stance, pressed & wanted, dt_s_);
}

/// Returns whether the robot moved.
bool Simulator::Move(const MotionDemand& wanted, const Inhibition& inhibition,
                     const MotionVerdict& verdict) {
  MotionDemand allowed = wanted;
  const MotionSet stopped = (response_.blocked & ~verdict.let_through) | inhibition.all();
  if ((preset_run_.moving() & stopped) != 0) preset_run_.Stop();
  drives_.Halt(stopped);
  allowed.commanded &= ~stopped;
  for (int motion = 0; motion < kMotionCount; ++motion) {
    double& rate = allowed.rate[motion];
    if (!Contains(allowed.commanded, motion)) rate = 0;
    if (Contains(verdict.let_through, motion)) rate = std::min(rate, verdict.most[motion]);
  }
  const bool closes = Contains(allowed.commanded, kGripperClose);
  allowed.left_hand_stopped = (allowed.commanded & response_.left_hand_blocked) != 0 ||
                              (closes && verdict.left_hand_stopped);
  allowed.right_hand_stopped = (allowed.commanded & response_.right_hand_blocked) != 0 ||
                               (closes && verdict.right_hand_stopped);
  driven_ = allowed.commanded & kChassisMotions;
  const RobotState before = result_.state;
  result_.state = Advance(robot_, before, allowed, dt_s_);
  result_.speed = SignedRate(robot_, allowed, kDriveForward, kDriveReverse);
  result_.turn_rate = SignedRate(robot_, allowed, kTurnLeft, kTurnRight);
  if (result_.state == before) return false;
  LinkPoses(robot_, result_.state, link_poses_);
  return true;
}

void Simulator::StandOnGround(const RobotState& before) {
  const RobotState moved = result_.state;
  if (config_.coverage == Coverage::kExtended) {
    Stance& stance = place_->stance;
    result_.state =
        stance.Stand(place_->world, link_poses_, before, result_.state, dt_s_, HeldLoad());
    bearing_.Lift(robot_.stance, {stance.FlipperGap(0), stance.FlipperGap(1)});
    tilt_guard_.Update(robot_.stance, before.attitude, result_.state.attitude, driven_);
  } else {
    place_->support.Cast(place_->world, link_poses_, 0, result_.step);
    result_.state = StandOn(place_->support.ground(), result_.state, dt_s_);
    result_.state.at_rest = result_.state.fall_speed == 0;
  }
  const bool lies_where_it_was =
      result_.state.position == moved.position && result_.state.attitude == moved.attitude;
  if (!lies_where_it_was) LinkPoses(robot_, result_.state, link_poses_);
}

/// Charges, gripper and disrupter, and then everything that moves by itself.
void Simulator::Dispose(const OperatorCommand& command) {
  const DetonationCause before = result_.disposal.detonation;
  result_.disposal =
      place_->disposal.Advance({.dt_s = dt_s_,
                                .step = result_.step,
                                .state = &result_.state,
                                .X_ML = link_poses_,
                                .bodies = place_->bodies.states(),
                                .movable_of_object = place_->movable_of_object(),
                                .world = &place_->world,
                                .panel = command.fire,
                                .robot_is_still = result_.speed == 0 && result_.turn_rate == 0,
                                .rolled_over = alarms_.IsActive(AlarmCode::kRollover)});
  place_->MoveBodies(dt_s_, link_poses_);
  const DisposalStatus& disposal = result_.disposal;
  if (before == DetonationCause::kNone && disposal.detonation != before) {
    explosion_.Ignite(disposal.detonation_ground, static_cast<uint32_t>(scenario_->seed),
                      disposal.robot_destroyed);
  }
  explosion_.Step(dt_s_);
  const int charge = disposal.bomb_body;
  result_.charge = charge < 0 ? Eigen::Vector3d::Zero().eval()
                              : bodies()[static_cast<size_t>(charge)].X_MO.translation().eval();
}

/// The lens needs no enabling switch; but a command that is old must not zoom on for ever.
void Simulator::Zoom(const OperatorCommand& command, TimePoint now) {
  const bool is_fresh = now - command.stamp < config_.command_timeout;
  if (!is_fresh || paused_ || result_.disposal.robot_destroyed) return;
  zoom_.Step(static_cast<ZoomWish>(command.camera_zoom));
  result_.zoom = zoom_.magnification();
}

/// What the arm carries, for balance.
Load Simulator::HeldLoad() const {
  const int held = result_.disposal.held_body;
  if (held < 0) return {};
  return {.mass = place_->disposal.held_mass(),
          .p_M = bodies()[static_cast<size_t>(held)].X_MO.translation()};
}

}  // namespace eod::sim
