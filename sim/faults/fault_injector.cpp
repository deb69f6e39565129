#include "sim/faults/fault_injector.h"

#include <algorithm>
#include <numbers>

#include "sim/faults/fault_targets.h"

namespace eod::sim {
namespace {

using Kind = FaultSpec::Kind;

/// Amounts come in degrees, of J7 in millimetres.
double JointAmount(const FaultSpec& spec, int joint) {
  return joint == kGripperOpening ? spec.amount / 1000 : spec.amount * std::numbers::pi / 180;
}

void Apply(const FaultSpec& spec, int target, ActiveFaults& active) {
  const auto at = static_cast<size_t>(std::max(target, 0));
  switch (spec.kind) {
    case Kind::kCameraDead:
      active.camera[at] |= kCameraDeadBit;
      break;
    case Kind::kCameraFrozen:
      active.camera[at] |= kCameraFrozenBit;
      break;
    case Kind::kCameraNoisy:
      active.camera[at] |= kCameraNoisyBit;
      break;
    case Kind::kCameraWrongLight:
      active.camera[at] |= kCameraWrongLightBit;
      break;
    case Kind::kJointStuck:
      active.stuck_joints |= 1U << at;
      break;
    case Kind::kJointSlow:
      active.joint_share[at] *= spec.amount;
      break;
    case Kind::kJointDrift:
      active.joint_drift[at] += JointAmount(spec, target);
      break;
    case Kind::kTrackWeak:
      (target == 0 ? active.left_track : active.right_track) *= spec.amount;
      break;
    case Kind::kGripperSlip:
      active.gripper_slips = true;
      break;
    case Kind::kBatterySag:
      active.battery_sag += spec.amount;
      break;
    case Kind::kRadioLoss:
      active.silent = true;
      break;
    case Kind::kCableSnag:
      active.snagged = true;
      break;
    case Kind::kFieldEstop:
      active.field_estop = true;
      break;
    case Kind::kStuckButton:
      active.stuck_buttons |= SetOf(target);
      break;
    case Kind::kSensorOffset:
      active.joint_offset[at] += JointAmount(spec, target);
      break;
    case Kind::kLampBroken:
      active.dark_lamps |= 1U << at;
      break;
  }
}

}  // namespace

FaultInjector::FaultInjector(const Scenario& scenario, const RobotModel& robot)
    : specs_(scenario.faults), progress_(specs_.size()) {
  for (const FaultSpec& spec : specs_) targets_.push_back(FindFaultTarget(spec, scenario, robot));
  changes_.reserve(2 * specs_.size());
}

void FaultInjector::Reset() {
  std::fill(progress_.begin(), progress_.end(), Progress{});
  changes_.clear();
  active_ = {};
}

void FaultInjector::Advance(const FaultMoment& moment) {
  changes_.clear();
  for (size_t i = 0; i < specs_.size(); ++i) {
    Progress& progress = progress_[i];
    const int index = static_cast<int>(i);
    if (progress.stage == Stage::kActive) {
      progress.age_s += moment.dt_s;
      // Half a step short counts: the sum of steps is not exact.
      const double duration = specs_[i].duration;
      if (duration > 0 && progress.age_s > duration - moment.dt_s / 2) {
        progress.stage = Stage::kOver;
        changes_.push_back({.index = index, .begins = false});
      }
    } else if (progress.stage == Stage::kWaiting && IsDue(specs_[i], moment)) {
      progress.stage = Stage::kActive;
      changes_.push_back({.index = index, .begins = true});
    }
  }
  if (!changes_.empty()) Collect();
}

bool FaultInjector::IsDue(const FaultSpec& spec, const FaultMoment& moment) const {
  if (!moment.running) return false;
  if (spec.at) return moment.elapsed_s >= *spec.at;
  if (spec.on_grasp) return moment.holds_charge;
  return moment.steps_done >= spec.after_step;
}

void FaultInjector::Collect() {
  active_ = {};
  for (size_t i = 0; i < specs_.size(); ++i) {
    if (progress_[i].stage == Stage::kActive) Apply(specs_[i], targets_[i], active_);
  }
}

}  // namespace eod::sim
