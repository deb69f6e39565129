#include "sim/radio/control_link.h"

#include <algorithm>
#include <cmath>

namespace eod::sim {

using Kind = ControlLinkSpec::Kind;

double RadioQuality(const ControlLinkSpec& spec, double distance, int walls) {
  return std::max(0.0, 1 - distance / spec.range) * std::pow(1 - spec.wall_loss, walls);
}

double DropChance(const LinkRules& rules, double quality) {
  return std::clamp(1 - quality / rules.drop_below, 0.0, 1.0);
}

ControlLink::ControlLink(const ControlLinkSpec& spec, const LinkRules& rules, double dt_s)
    : spec_(spec),
      rules_(rules),
      steps_between_looks_(std::max(1, static_cast<int>(std::lround(rules.check_period / dt_s)))),
      cable_(spec.cable_length) {
  if (spec.kind != Kind::kIdeal) sight_.Reserve();
}

void ControlLink::Reset(const World& world, uint32_t class_bit, const RobotState& state,
                        bool has_base) {
  if (spec_.kind == Kind::kIdeal) return;
  sight_.SetModule(class_bit);
  Eigen::Vector3d foot = state.position;
  if (has_base && spec_.base) {
    foot.head<2>() = *spec_.base;
    foot.z() = sight_.GroundAt(world, foot);
  }
  base_ = foot + Eigen::Vector3d(0, 0, rules_.base_antenna);
  cable_.Reset(foot + Eigen::Vector3d(0, 0, rules_.cable_height), Reel(state));
  steps_ = 0;
  Look(world, state);
}

void ControlLink::Advance(const World& world, const RobotState& state, bool silent, bool snagged) {
  if (spec_.kind == Kind::kCable) {
    cable_.Follow(Reel(state));
    cable_.SetSnagged(snagged);
  }
  if (spec_.kind != Kind::kIdeal && ++steps_ >= steps_between_looks_) {
    steps_ = 0;
    Look(world, state);
  }
  if (spec_.kind == Kind::kRadio) distance_ = (Antenna(state) - base_).norm();
  quality_ = silent ? 0 : spec_.kind == Kind::kRadio ? RadioQuality(spec_, distance_, walls_) : 1;
  drop_ = DropChance(rules_, quality_);
}

void ControlLink::Look(const World& world, const RobotState& state) {
  if (spec_.kind == Kind::kRadio) walls_ = sight_.Walls(world, base_, Antenna(state));
  if (spec_.kind == Kind::kCable) cable_.FindCorners(world, sight_);
}

MotionSet ControlLink::ForbiddenMotions(const RobotState& state) const {
  if (spec_.kind != Kind::kCable || !cable_.is_taut()) return 0;
  const double heading = state.attitude.heading;
  const Eigen::Vector2d forward(-std::sin(heading), std::cos(heading));
  const double outwards = cable_.Outwards().dot(forward);
  return outwards > 0 ? SetOf(kDriveForward) : outwards < 0 ? SetOf(kDriveReverse) : 0;
}

Eigen::Vector3d ControlLink::Antenna(const RobotState& state) const {
  return state.position + Eigen::Vector3d(0, 0, rules_.robot_antenna);
}

Eigen::Vector3d ControlLink::Reel(const RobotState& state) const {
  return state.position + Eigen::Vector3d(0, 0, rules_.cable_height);
}

}  // namespace eod::sim
