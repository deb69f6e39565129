#include "sim/stance/stance.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "sim/geometry/gravity.h"
#include "sim/segments/hit_choice.h"

namespace eod::sim {
namespace {

using Eigen::AlignedBox3d;
using Eigen::Isometry3d;
using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double kLooksDown = 0.1;   // a point whose normal points up by more carries nothing
constexpr double kStill = 1e-9;      // [m] less is rounding: a robot at rest keeps its bits
constexpr double kTrembles = 5e-3;   // [m] whoever stays within that, unmoved, ...
constexpr double kTrembles_s = 0.5;  // ... for so long, is at rest: an edge must not shake it
constexpr double kCarries = 1e-9;    // share of the weight
constexpr int kPuttingDown = 40;     // rounds; each halves what is left, and more

int FlipperOf(const RobotModel& robot, const SupportPoint& point) {
  const int joint = robot.links[point.link].joint;
  return joint == kFrontFlipper ? 0 : joint == kRearFlipper ? 1 : -1;
}

/// Lays the robot on the plane that its own has to move by.
void MoveBy(const RestingPlane& plane, RobotState& state) {
  const Vector3d up = ToRotation(state.attitude).col(2);
  const Vector2d slope = plane.slope - up.head<2>() / up.z();
  const Vector3d n_M = Vector3d(-slope.x(), -slope.y(), 1).normalized();
  const Attitude laid = AttitudeOnPlane(n_M, state.attitude.heading);
  state.attitude.pitch = laid.pitch;
  state.attitude.roll = laid.roll;
  state.position.z() += plane.offset;
}

}  // namespace

Stance::Stance(const RobotModel& robot, uint32_t module_mask)
    : robot_(robot), class_mask_(module_mask | kClampProxy) {
  memory_.surroundings.Reserve();
  const size_t most = robot.stance.points.size();
  for (const SupportPoint& point : robot.stance.points) {
    flipper_of_.push_back(FlipperOf(robot, point));
    if (point.link == 0) turning_radius_ = std::max(turning_radius_, point.p_L.head<2>().norm());
  }
  points_.reserve(most);
  starts_.reserve(most);
  queries_.reserve(most);
  hits_.reserve(most);
  depths_.reserve(most);
  props_.reserve(most + 1);
}

void Stance::Reset() {
  stood_on_ = {-1, -1, -1};
  centre_sink_ = 0;
  turn_.setZero();
}

RobotState Stance::Stand(const World& world, std::span<const Isometry3d> X_ML,
                         const RobotState& before, const RobotState& state, double dt_s,
                         const Load& load) {
  const double turn = std::remainder(state.attitude.heading - before.attitude.heading, 2 * M_PI);
  const double travel =
      (state.position - before.position).head<2>().norm() + turning_radius_ * std::abs(turn);
  const Limits limits{
      .sink = (state.fall_speed + kGravity * dt_s) * dt_s,
      .rise = robot_.stance.rise_speed * dt_s + robot_.stance.rise_per_metre * travel};
  RobotState next = StandWithin(world, X_ML, state, limits, dt_s, load);
  if (!(state == before)) {
    calm_s_ = 0;
  } else if (Trembles(next, dt_s)) {
    next = state;
    next.fall_speed = 0;
    next.slip.setZero();
    next.at_rest = true;
  }
  return next;
}

/// Whether an unmoved robot has stayed where it is for a while.
bool Stance::Trembles(const RobotState& state, double dt_s) {
  const Vector3d tilt(state.attitude.pitch, state.attitude.roll, 0);
  const double away =
      (state.position - calm_at_.position).norm() + turning_radius_ * (tilt - calm_at_.tilt).norm();
  calm_s_ = calm_s_ > 0 && away < kTrembles ? calm_s_ + dt_s : 0;
  if (calm_s_ > 0) return calm_s_ > kTrembles_s;
  calm_at_ = {state.position, tilt};
  calm_s_ = dt_s;
  return false;
}

RobotState Stance::PutDown(const World& world, RobotState state, std::vector<Isometry3d>& X_ML,
                           const Load& load) {
  Reset();
  const Limits limits{.sink = robot_.stance.reach_down, .rise = robot_.stance.reach_up};
  for (int round = 0; round < kPuttingDown; ++round) {
    LinkPoses(robot_, state, X_ML);
    state = StandWithin(world, X_ML, state, limits, 0, load);
    const bool ground =
        std::any_of(hits_.begin(), hits_.end(), [](const SegmentHit& hit) { return hit.hit; });
    if (state.at_rest || !ground) break;
  }
  state.fall_speed = 0;
  return state;
}

RobotState Stance::StandWithin(const World& world, std::span<const Isometry3d> X_ML,
                               const RobotState& state, const Limits& limits, double dt_s,
                               const Load& load) {
  LookForGround(world, X_ML);
  SetProps(state, limits);
  const Vector2d centre = (CentreOfGravity(robot_, X_ML, load) - state.position).head<2>();
  RobotState next = state;
  const bool overturned = TiltOf(state.attitude) >= robot_.stance.overturned;
  if (overturned) {
    Lie();
  } else {
    next.rolls_over = !Rest(centre, limits.sink);
    if (dt_s > 0) FallByTheCentre(centre, limits.sink, dt_s);
  }
  const bool held_up = IsHeldUp(limits.sink);
  const double moved = std::abs(plane_.offset) + turning_radius_ * plane_.slope.lpNorm<1>();
  const bool still = moved <= kStill;
  next.fall_speed = still ? 0 : SinkSpeed(dt_s);
  if (!still) MoveBy(plane_, next);
  const bool holds = held_up && Slip(next, dt_s);
  if (overturned) next.rolls_over = true;
  next.at_rest = still && (overturned || (holds && !next.rolls_over));
  return next;
}

/// One vertical through every point that looks down.
void Stance::LookForGround(const World& world, std::span<const Isometry3d> X_ML) {
  const StanceSpec& stance = robot_.stance;
  points_.clear();
  starts_.clear();
  AlignedBox3d around;
  for (size_t i = 0; i < stance.points.size(); ++i) {
    const SupportPoint& point = stance.points[i];
    const Isometry3d& X_MP = X_ML[point.link];
    if (X_MP.linear().row(2).dot(point.n_L) > kLooksDown) continue;
    points_.push_back(static_cast<int>(i));
    starts_.push_back(X_MP * point.p_L + stance.reach_up * Vector3d::UnitZ());
    around.extend(starts_.back());
  }
  hits_.resize(starts_.size());
  memory_.counters = {};
  if (starts_.empty()) return;
  around.min().z() -= stance.reach_up + stance.reach_down;
  if (const std::optional<double> z = world.LevelGroundIn(around, class_mask_, memory_)) {
    MeetLevelGround(*z);
  } else {
    CastLines(world);
  }
}

void Stance::CastLines(const World& world) {
  const StanceSpec& stance = robot_.stance;
  queries_.clear();
  for (size_t i = 0; i < starts_.size(); ++i) {
    queries_.push_back({.start = starts_[i],
                        .direction = -Vector3d::UnitZ(),
                        .length = stance.reach_up + stance.reach_down,
                        .class_mask = class_mask_,
                        .hit_rule = HitRule::kHighest,
                        .group = stance.points[static_cast<size_t>(points_[i])].group});
  }
  world.Cast(queries_, hits_, memory_);
}

/// What casting the lines would find.
void Stance::MeetLevelGround(double z) {
  const double length = robot_.stance.reach_up + robot_.stance.reach_down;
  for (size_t i = 0; i < starts_.size(); ++i) {
    const std::optional<double> range = OnSegment(starts_[i].z() - z, length);
    hits_[i].hit = range.has_value();
    hits_[i].range = range.value_or(0);
    hits_[i].normal = Vector3d::UnitZ();
  }
}

/// How far each point has to rise, or may sink.
void Stance::SetProps(const RobotState& state, const Limits& limits) {
  const StanceSpec& stance = robot_.stance;
  depths_.clear();
  props_.clear();
  flipper_gap_ = {stance.reach_down, stance.reach_down};
  for (size_t i = 0; i < points_.size(); ++i) {
    const double depth = hits_[i].hit ? stance.reach_up - hits_[i].range : -stance.reach_down;
    const Vector3d p = starts_[i] - state.position;
    depths_.push_back(depth);
    props_.push_back({p.x(), p.y(), std::clamp(depth, -limits.sink, limits.rise)});
    const int flipper = flipper_of_[points_[i]];
    if (flipper >= 0) flipper_gap_[flipper] = std::min(flipper_gap_[flipper], -depth);
  }
}

/// Lays plane_ on the props. False if the centre of gravity is beyond them all: then it tips over
/// the nearest ones, on a prop of its own that gives way as fast as things fall.
bool Stance::Rest(const Vector2d& centre, double sink) {
  std::array<int, 3> triangle;
  const bool stands = WarmStart(centre, triangle) || FindTriangle(props_, centre, triangle);
  if (!stands) {
    Vector2d middle = Vector2d::Zero();
    for (const Prop& prop : props_) middle += Vector2d(prop.x, prop.y) / double(props_.size());
    const Vector2d beyond = centre + (centre - middle);
    props_.push_back({beyond.x(), beyond.y(), -sink});
    if (!FindTriangle(props_, centre, triangle)) {
      plane_ = {.offset = -sink, .props = {-1, -1, -1}};
      stood_on_ = {-1, -1, -1};
      return false;
    }
  }
  plane_ = RestOn(props_, centre, triangle);
  for (size_t i = 0; i < 3; ++i) {
    const auto prop = static_cast<size_t>(plane_.props[i]);
    stood_on_[i] = prop < points_.size() ? points_[prop] : -1;
  }
  return stands;
}

/// What loses its last hold falls as fast as its centre of gravity did, not as fast as the farther
/// point that it tipped by: a fall from a height may not gain more than that height's energy. And
/// it turns on as it did, until it would turn into the ground.
void Stance::FallByTheCentre(const Vector2d& centre, double sink, double dt_s) {
  bool holds = false;
  for (size_t i = 0; i < 3; ++i) {
    holds |= plane_.load[i] > kCarries && IsOnGround(plane_.props[i], sink);
  }
  if (!holds) {
    const double falls = std::min(sink, centre_sink_ + kGravity * dt_s * dt_s);
    plane_ = {.offset = -falls - turn_.dot(centre), .slope = turn_, .props = {-1, -1, -1}};
    for (size_t i = 0; i < depths_.size(); ++i) {
      if (plane_.At(props_[i].x, props_[i].y) >= depths_[i]) continue;
      plane_ = {.offset = -falls, .props = {-1, -1, -1}};
      break;
    }
  }
  turn_ = plane_.slope;
  centre_sink_ = std::max(0.0, -plane_.At(centre.x(), centre.y()));
}

/// What has turned over lies as it fell, and only falls on, down to the first point that touches.
void Stance::Lie() {
  double touches = -robot_.stance.reach_down;
  for (const Prop& prop : props_) touches = std::max(touches, prop.height);
  plane_ = {.offset = touches, .props = {-1, -1, -1}};
  centre_sink_ = std::max(0.0, -touches);
  stood_on_ = {-1, -1, -1};
}

/// The triangle of the last step, if it is still there and round the centre.
bool Stance::WarmStart(const Vector2d& centre, std::array<int, 3>& triangle) const {
  for (size_t i = 0; i < 3; ++i) {
    const auto found = std::lower_bound(points_.begin(), points_.end(), stood_on_[i]);
    if (found == points_.end() || *found != stood_on_[i]) return false;
    triangle[i] = static_cast<int>(found - points_.begin());
  }
  const std::array<double, 3> load = LoadOn(props_, triangle, centre);
  return *std::min_element(load.begin(), load.end()) >= 0;
}

/// Whether a prop stands on ground, and not on what gives way as fast as things fall.
bool Stance::IsOnGround(int prop, double sink) const {
  const auto point = static_cast<size_t>(prop);
  return point < depths_.size() && depths_[point] >= -sink;
}

/// Whether ground carries all of the weight.
bool Stance::IsHeldUp(double sink) const {
  if (plane_.props[0] < 0) return false;
  for (size_t i = 0; i < 3; ++i) {
    if (plane_.load[i] > kCarries && !IsOnGround(plane_.props[i], sink)) return false;
  }
  return true;
}

/// Of the prop that gives way fastest, among those that carry.
double Stance::SinkSpeed(double dt_s) const {
  if (dt_s <= 0) return 0;
  if (plane_.props[0] < 0) return centre_sink_ / dt_s;
  double lowest = 0;
  for (size_t i = 0; i < 3; ++i) {
    if (plane_.load[i] > kCarries) lowest = std::min(lowest, props_[plane_.props[i]].height);
  }
  return lowest < 0 ? -lowest / dt_s : 0;
}

/// Coulomb: it slides downhill beyond the friction's angle. Whether it holds.
bool Stance::Slip(RobotState& state, double dt_s) const {
  const Vector3d up = ToRotation(state.attitude).col(2);
  Vector3d n_M = Vector3d::Zero();
  for (size_t i = 0; i < 3; ++i) {
    const auto prop = static_cast<size_t>(plane_.props[i]);
    if (plane_.load[i] <= kCarries || !hits_[prop].hit) continue;
    // On an edge or a bar it is the robot's underside that lies on it.
    Vector3d ground = hits_[prop].normal;
    if (ground.z() < 0) ground = -ground;
    n_M += plane_.load[i] * (ground.z() > up.z() ? ground : up);
  }
  const double steep = n_M.head<2>().norm();
  const double grip = robot_.stance.friction * n_M.z();
  if (steep <= grip && state.slip.isZero(0)) return true;
  const double norm = n_M.norm();
  const double brake = kGravity * grip / norm * dt_s;
  Vector2d slip = state.slip + kGravity * dt_s / norm * n_M.head<2>();
  const double speed = slip.norm();
  state.slip = speed > brake ? Vector2d(slip * (1 - brake / speed)) : Vector2d::Zero();
  // Along the slope, so the way in plan view is shorter.
  const Vector2d way = state.slip * (n_M.z() / norm * dt_s);
  state.position.head<2>() += way;
  state.position.z() -= n_M.head<2>().dot(way) / n_M.z();
  return false;
}

}  // namespace eod::sim
