#include <algorithm>
#include <array>
#include <utility>

#include "sim/look_ahead.h"
#include "sim/sight.h"
#include "sim/simulator.h"

namespace eod::sim {
namespace {

bool IsSame(TaskStatus a, const TaskStatus& b) {
  a.elapsed_s = b.elapsed_s;
  return a == b;
}

}  // namespace

void Simulator::Report(const OperatorCommand& command, const Wish& wish,
                       const Inhibition& inhibition) {
  result_.limit_flags = LimitFlags(robot_, result_.state);
  result_.contact_parts = response_.contact_parts;
  result_.command_sequence = command.sequence;
  result_.inhibited =
      (response_.blocked | inhibition.all() | wish.refused | command.inhibited) & kAllMotions;
  const bool heard = command.heard != TimePoint{};
  result_.command_age_s = heard ? ToSeconds(result_.time - command.heard) : -1;
  result_.link_lost_s =
      result_.command_age_s >= ToSeconds(config_.command_timeout) ? result_.command_age_s : 0;
  result_.link_latched = command.link_latched;
  result_.link_quality = link_.quality();
  result_.cable_out =
      scenario_->link.kind == ControlLinkSpec::Kind::kCable ? link_.cable().paid_out() : 0;
  result_.battery_v = battery_.voltage();
  result_.battery_soc = battery_.charge();
  result_.field_estop = faults_.active().field_estop;
  const bool wrecked = result_.disposal.robot_destroyed;
  if (wrecked) result_.inhibited = kAllMotions;
  result_.inhibit_reason = wrecked                      ? kReasonNotReady
                           : response_.blocked != 0     ? kReasonCollision
                           : inhibition.tilt != 0       ? kReasonTilt
                           : inhibition.payload != 0    ? kReasonPayload
                           : inhibition.cable != 0      ? kReasonCable
                           : inhibition.limit != 0      ? kReasonJointLimit
                           : wish.reason != kReasonNone ? wish.reason
                                                        : command.inhibit_reason;
}

void Simulator::UpdateAlarms(MotionSet wished, const Inhibition& inhibition) {
  AlarmInputs inputs;
  inputs.dt_s = dt_s_;
  inputs.contact_parts = response_.contact_parts;
  inputs.pushing = (wished & response_.blocked) != 0;
  inputs.limit_flags = result_.limit_flags;
  for (int motion = 0; motion < kMotionCount; ++motion) {
    if (Contains(inhibition.limit, motion))
      inputs.driven_joints |= 1u << JointOf(robot_, motion).joint;
  }
  inputs.tilt = TiltOf(result_.state.attitude);
  const DisposalStatus& disposal = result_.disposal;
  inputs.charge_touched = disposal.touched;
  inputs.charge_disturbed = disposal.disturbed;
  inputs.charge_unstable = disposal.unstable;
  inputs.detonated = disposal.detonation != DetonationCause::kNone;
  inputs.battery_low = battery_.is_low();
  inputs.rolls_over = result_.state.rolls_over;
  result_.alarm_changes.clear();
  alarm_rules_.Update(inputs, alarms_, result_.alarm_changes);
}

/// Whether the object of an inspect step is in a picture that the operator has before him.
bool Simulator::SeesObject(int camera_select) {
  const std::optional<InspectedObject> inspected = place_->task.inspected();
  if (!inspected) return false;
  const TaskStep& step = *inspected->step;
  const Eigen::Isometry3d& X_MO = inspected->movable < 0
                                      ? inspected->X_MO
                                      : place_->poses()[static_cast<size_t>(inspected->movable)];
  const Sight sight{.p_M = X_MO * step.point.value_or(Eigen::Vector3d::Zero()),
                    .distance = step.distance,
                    .object = step.point ? std::string_view() : std::string_view(step.object)};
  constexpr std::array<std::string_view, 5> kNames = {"quad", "drive", "gripper", "mast", "rear"};
  for (int camera = 1; camera < static_cast<int>(kNames.size()); ++camera) {
    const bool is_shown = camera_select == 0 || camera_select == camera;
    const bool is_meant = step.camera == 0 || step.camera == camera;
    if (!is_shown || !is_meant) continue;
    for (const CameraSpec& spec : robot_.cameras) {
      if (spec.name == kNames[static_cast<size_t>(camera)] &&
          Sees(spec, link_poses_, place_->world, sight, sight_)) {
        return true;
      }
    }
  }
  return false;
}

/// [s] since the operator's commands came, and the box was heard.
double Simulator::LinkLost(const OperatorCommand& command) {
  box_lost_steps_ = command.inhibit_reason == kReasonLinkLoss ? box_lost_steps_ + 1 : 0;
  const double box_lost_s = static_cast<double>(box_lost_steps_) * dt_s_;
  return std::max(box_lost_s, result_.link_lost_s);
}

void Simulator::UpdateTask(uint32_t contacts_before, const OperatorCommand& command) {
  // How far ahead things are is asked of a robot that stands.
  const bool stands = StandsStill(result_.speed, result_.turn_rate);
  const Ahead ahead =
      stands ? LookAhead(robot_, link_poses_, place_->isectors.segments()) : Ahead{};
  const int first = response_.first_contact;
  TaskInputs inputs;
  inputs.dt_s = dt_s_;
  inputs.state = &result_.state;
  inputs.speed = result_.speed;
  inputs.turn_rate = result_.turn_rate;
  inputs.started = std::exchange(start_asked_, false);
  inputs.ended = std::exchange(end_asked_, false);
  sample_.contact_by_held = false;
  inputs.new_contact = (response_.contact_parts & ~contacts_before) != 0;
  inputs.in_contact = response_.contact_parts != 0;
  inputs.link_lost_s = LinkLost(command);
  inputs.rolled_over = alarms_.IsActive(AlarmCode::kRollover);
  if (first >= 0) {
    const CastSegment& cast = place_->isectors.segments()[first];
    inputs.contact_object = place_->world.ObjectName(cast.hit.object);
    sample_.contact_by_held = cast.isector == probe_;
  } else if (inputs.in_contact && result_.disposal.bomb_body >= 0) {
    // No line of the robot, so a pad on the charge.
    const auto charge = static_cast<size_t>(result_.disposal.bomb_body);
    inputs.contact_object = place_->module().movables[charge].name;
  }
  inputs.forward_clearance = ahead.clearance;
  inputs.forward_object = place_->world.ObjectName(ahead.object);
  inputs.estopped = estopped_;
  inputs.ended_by_instructor = std::exchange(instructor_ends_, false);
  inputs.sees_object = SeesObject(command.camera_select);
  inputs.disposal = &result_.disposal;
  inputs.movables = place_->poses();
  sample_.contact_object = inputs.contact_object;
  sample_.ahead_m = inputs.forward_clearance;
  sample_.ahead_object = inputs.forward_object;
  const TaskStatus before = result_.task;
  // A pause stops the exercise's clock too.
  result_.task = paused_ ? place_->task.status() : place_->task.Advance(inputs);
  result_.task.score = before.score;
  result_.task_changed = !IsSame(before, result_.task);
}

}  // namespace eod::sim
