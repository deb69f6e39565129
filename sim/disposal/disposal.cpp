#include "sim/disposal/disposal.h"

#include <algorithm>
#include <cmath>

#include "sim/disposal/charge.h"
#include "sim/geometry/gravity.h"
#include "sim/segments/isector_method.h"

namespace eod::sim {
namespace {

using Eigen::Vector3d;

Vector3d DownIn(const Eigen::Isometry3d& X_MG) {
  return -X_MG.linear().transpose() * Vector3d::UnitZ();
}

}  // namespace

Disposal::Disposal(RobotModel& robot, int probe, const ModuleModel& module, const Rules& rules,
                   GraspMode mode, uint64_t seed)
    : robot_(robot),
      probe_(probe),
      module_(module),
      rules_(rules),
      hand_(robot),
      wrist_(FindLink(robot, "wrist")),
      grasp_(rules.grasp, mode),
      pressing_(hand_, module, rules.grasp),
      push_(robot, rules.charge),
      watch_(module, rules.charge, rules.vessel),
      circuit_(rules.disrupter, seed),
      touched_(module.movables.size()) {
  memory_.surroundings.Reserve();
  Reset();
}

void Disposal::Reset(uint64_t seed) {
  grasp_.Reset();
  pressing_.Reset();
  push_.Reset();
  watch_.Reset();
  circuit_.Reset(seed);
  FoldHeldProbe(robot_.isectors[probe_]);
  X_MG_before_.reset();
  closing_age_ = rules_.grasp.close_memory + 1;
  was_released_ = opening_ = too_heavy_ = false;
  fall_speed_ = 0;
  std::fill(touched_.begin(), touched_.end(), 0);
  newly_held_ = -1;
  judged_.reset();
  verdict_ = {};
  orders_ = {};
  status_ = {};
  FillStatus();
}

bool Disposal::Ignores(int body) const {
  if (grasp_.is_held() && body == grasp_.charge()) return true;
  const ChargeState* charge = watch_.Find(body);
  return charge != nullptr && charge->state == BombState::kExploded;
}

double Disposal::held_mass() const {
  return grasp_.is_held() ? module_.movables[grasp_.charge()].mass : 0;
}

const MotionVerdict& Disposal::Judge(const BeforeMotion& step, Response& response) {
  const MotionSet commanded = step.demand->commanded;
  const bool closing = Contains(commanded, kGripperClose);
  opening_ = Contains(commanded, kGripperOpen);
  closing_age_ = closing ? 0 : closing_age_ + step.dt_s;
  was_released_ = was_released_ && !closing;
  newly_held_ = -1;
  judged_.reset();
  verdict_ = {};

  NoteTouches(step, response);
  const HandLines lines =
      hand_.Read(step.segments, response.contacts, module_, step.movable_of_object);
  pressing_.Update(closing && !grasp_.is_held(), lines, step.X_ML, step.bodies, response, touched_);
  if (hand_.has_hands() && !grasp_.is_held()) TryGrasp(step, lines);
  if (grasp_.is_held()) {
    too_heavy_ = step.pads_slip || held_mass() > step.payload;
    verdict_.left_hand_stopped = step.state->left_opening <= grasp_.left_opening();
    verdict_.right_hand_stopped = step.state->right_opening <= grasp_.right_opening();
    CheckRim(step, response);
  }
  if (closing && !grasp_.is_held()) pressing_.Pinch(response);
  if (grasp_.Squeeze(pressing_.pinched() >= 0, step.dt_s)) {
    judged_ = Detonation{pressing_.pinched(), DetonationCause::kSqueezed};
  }
  verdict_.let_through =
      push_.Update(*step.demand, step.segments, response, step.movable_of_object, step.dt_s);
  for (int motion = 0; motion < kMotionCount; ++motion) {
    if (!Contains(verdict_.let_through, motion)) continue;
    verdict_.most[motion] = push_.RateOf(motion, step.demand->speed_range);
  }
  status_.grasp = GraspOf(lines, closing);
  if (hand_.has_hands()) X_MG_before_ = step.X_ML[hand_.gripper()];
  return verdict_;
}

void Disposal::NoteTouches(const BeforeMotion& step, const Response& response) {
  std::fill(touched_.begin(), touched_.end(), 0);
  for (size_t i = 0; i < step.segments.size(); ++i) {
    const CastSegment& cast = step.segments[i];
    if (!response.contacts[i].contact) continue;
    if (TellsNearness(robot_.isectors[cast.isector].segments[cast.segment])) continue;
    const int movable = MovableOf(step.movable_of_object, cast.hit.object);
    if (movable >= 0) touched_[movable] = 1;
  }
}

void Disposal::TryGrasp(const BeforeMotion& step, const HandLines& lines) {
  // Hands that open take hold of nothing.
  const int candidate = opening_ ? -1 : GraspCandidate(lines);
  if (candidate < 0) {
    grasp_.Close(-1, nullptr);
    return;
  }
  const BodyState& body = step.bodies[candidate];
  const Eigen::Isometry3d& X_MG = step.X_ML[hand_.gripper()];
  const Vector3d across_M =
      step.X_ML[hand_.right()].translation() - step.X_ML[hand_.left()].translation();
  const Grip grip{.lines = lines,
                  .charge = Explosive(candidate),
                  .X_MO = body.X_MO,
                  .closing_M = X_MG.linear().col(0),
                  .gap = across_M.dot(X_MG.linear().col(0)),
                  .relative_speed = RelativeSpeed(step, body),
                  .tilt = watch_.Find(candidate)->tilt,
                  .mass = module_.movables[candidate].mass,
                  .payload = step.payload,
                  .closing_age = closing_age_};
  if (!grasp_.Close(candidate, &grip)) return;
  grasp_.Hold(candidate, X_MG.inverse() * body.X_MO, step.state->left_opening,
              step.state->right_opening, IsHeldWell(grip, rules_.grasp));
  newly_held_ = candidate;
  pressing_.LetGo();
  ShapeProbe(DownIn(X_MG));
}

/// Of a point of the gripper, as it came to where it is.
Vector3d Disposal::GripperVelocity(const BeforeMotion& step, const Vector3d& p_M) const {
  if (!X_MG_before_) return Vector3d::Zero();
  const Eigen::Isometry3d& X_MG = step.X_ML[hand_.gripper()];
  return (p_M - *X_MG_before_ * (X_MG.inverse() * p_M)) / step.dt_s;
}

double Disposal::RelativeSpeed(const BeforeMotion& step, const BodyState& body) const {
  return (body.v_M - GripperVelocity(step, body.X_MO.translation())).norm();
}

/// The held charge against a vessel: what counts is how fast it came up against it.
void Disposal::CheckRim(const BeforeMotion& step, const Response& response) {
  for (size_t i = 0; i < step.segments.size(); ++i) {
    const CastSegment& cast = step.segments[i];
    if (cast.isector != probe_ || !response.contacts[i].contact ||
        (cast.hit.object_class & kContainmentVessel) == 0) {
      continue;
    }
    const double approach = GripperVelocity(step, cast.query.start).dot(cast.query.direction);
    if (approach > rules_.vessel.rim_strike) {
      judged_ = Detonation{grasp_.charge(), DetonationCause::kRimStrike};
    }
  }
}

GraspState Disposal::GraspOf(const HandLines& lines, bool closing) const {
  if (grasp_.is_held()) return GraspState::kGrasped;
  return was_released_ ? GraspState::kReleased : pressing_.State(lines, closing);
}

const DisposalStatus& Disposal::Advance(const AfterMotion& step) {
  orders_ = {};
  orders_.hold = newly_held_;
  if (newly_held_ >= 0) orders_.reload_isector = probe_;
  if (grasp_.is_held()) Carry(step);
  Watch(step);
  if (judged_) Detonate(judged_->body, judged_->cause, step);
  if (circuit_.Advance(step.panel, step.robot_is_still, step.step, step.dt_s)) Shoot(step);
  FillStatus();
  return status_;
}

void Disposal::Carry(const AfterMotion& step) {
  const Eigen::Isometry3d& X_MG = step.X_ML[hand_.gripper()];
  const bool slipped_out = grasp_.Slip(too_heavy_, DownIn(X_MG), step.dt_s);
  if (slipped_out ||
      grasp_.IsLetGo(opening_, step.state->left_opening, step.state->right_opening)) {
    LetGo();
    return;
  }
  if (grasp_.is_slipping()) {
    ShapeProbe(DownIn(X_MG));
    orders_.reload_isector = probe_;
    status_.grasp = GraspState::kSlipping;
  }
  orders_.move_held = grasp_.charge();
  orders_.X_MO = X_MG * grasp_.X_GO();
}

void Disposal::LetGo() {
  orders_.release = grasp_.charge();
  orders_.move_held = -1;
  orders_.reload_isector = probe_;
  FoldHeldProbe(robot_.isectors[probe_]);
  grasp_.Release();
  was_released_ = true;
  status_.grasp = GraspState::kReleased;
}

void Disposal::ShapeProbe(const Vector3d& down_G) {
  ShapeHeldProbe(Explosive(grasp_.charge()), grasp_.X_GO(), down_G, rules_.charge,
                 robot_.isectors[probe_]);
}

void Disposal::Watch(const AfterMotion& step) {
  const auto found = watch_.Update(step.bodies, touched_, grasp_.charge());
  if (found) Detonate(found->body, found->cause, step);
  // A robot that comes down hard drops what it holds as deep.
  const double hard = std::sqrt(2 * kGravity * rules_.charge.drop);
  const bool came_down = fall_speed_ > hard && step.state->fall_speed == 0;
  fall_speed_ = step.state->fall_speed;
  if (grasp_.is_held() && (step.rolled_over || came_down)) {
    Detonate(grasp_.charge(), DetonationCause::kCrushed, step);
  }
}

void Disposal::Shoot(const AfterMotion& step) {
  if (wrist_ < 0 || step.world == nullptr) return;
  const auto shot = ShotFrom(BarrelPose(step.X_ML[wrist_], rules_.disrupter), *step.world, module_,
                             step.bodies, step.movable_of_object, rules_.disrupter, memory_);
  if (!shot) return;
  if (!shot->disrupted) {
    Detonate(shot->body, DetonationCause::kShot, step);
    return;
  }
  watch_.Disrupt(shot->body);
  orders_.push = shot->body;
  orders_.impulse_M = shot->impulse_M;
  orders_.p_M = shot->p_M;
}

/// The first blast is the last: what it does to other charges is of no interest.
void Disposal::Detonate(int body, DetonationCause cause, const AfterMotion& step) {
  if (status_.detonation != DetonationCause::kNone) return;
  const ChargeState& charge = *watch_.Find(body);
  if (charge.state == BombState::kDisrupted) return;
  if (grasp_.is_held() && grasp_.charge() == body) LetGo();
  status_.detonation = cause;
  status_.detonation_point = step.bodies[body].X_MO.translation();
  status_.detonation_ground = GroundBelow(body, step);
  const double distance = (status_.detonation_point - step.state->position).norm();
  status_.robot_destroyed = !charge.in_vessel && distance < rules_.charge.lethal;
  orders_.remove = body;
  watch_.Explode(body);
}

/// What is below the charge's middle; its own lowest height where nothing is.
Vector3d Disposal::GroundBelow(int body, const AfterMotion& step) {
  const Eigen::Isometry3d& X_MO = step.bodies[body].X_MO;
  constexpr double kDeepest = 5;  // [m] more than the arm reaches up
  const SegmentQuery query{.start = X_MO.translation(),
                           .direction = -Vector3d::UnitZ(),
                           .length = kDeepest,
                           .class_mask = module_.class_bit | UsualClasses(IsectorMethod::kHat)};
  SegmentHit hit;
  if (step.world != nullptr) step.world->Cast({&query, 1}, {&hit, 1}, memory_);
  Vector3d ground = X_MO.translation();
  ground.z() = hit.hit ? hit.point.z() : LowestPoint(Explosive(body), X_MO);
  return ground;
}

void Disposal::FillStatus() {
  status_.held_body = grasp_.charge();
  const ChargeState* main = watch_.main();
  status_.bomb = main == nullptr ? BombState::kNone : main->state;
  status_.bomb_body = main == nullptr ? -1 : main->body;
  status_.bomb_tilt = main == nullptr ? 0 : main->tilt;
  status_.touched = status_.disturbed = status_.unstable = false;
  for (const ChargeState& charge : watch_.charges()) {
    status_.touched = status_.touched || charge.touched;
    status_.disturbed = status_.disturbed || charge.disturbed;
    status_.unstable = status_.unstable || charge.unstable;
  }
  status_.fire = circuit_.state();
  status_.fire_nonce = circuit_.nonce();
  status_.circuit_continuity = circuit_.continuity();
}

}  // namespace eod::sim
