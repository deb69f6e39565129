// What a step tells the judge of the mission.
#include <cmath>
#include <numbers>

#include "sim/disposal/charge.h"
#include "sim/simulator.h"

namespace eod::sim {
namespace {

constexpr int kEstopLatched = 5;  // box_command_t STATE_ESTOP_LATCHED
constexpr int kRear = 4;          // box_command_t.camera_select

double ToDegrees(double radians) { return radians * (180 / std::numbers::pi); }

bool Runs(int mission_state) { return mission_state == static_cast<int>(MissionState::kRun); }

}  // namespace

/// What the operator has looked after, since the last mission ended: checks are often made before
/// one starts.
void Simulator::NoteChecks(const OperatorCommand& command) {
  const bool latched = command.system_state == kEstopLatched;
  if (estop_latched_ && !latched) checks_ |= kEstopTested;
  estop_latched_ = latched;
  if (command.lamp_test) checks_ |= kLampsTested;
  const int camera = command.camera_select;
  if (camera >= 1 && camera <= kRear) checks_ |= kDriveCameraSeen << (camera - 1);
}

void Simulator::TellOfRobot() {
  const RobotState& state = result_.state;
  sample_.step = result_.step;
  sample_.module = result_.module;
  sample_.position = place_->module().p_WM + state.position;
  sample_.heading_deg = ToDegrees(state.attitude.heading);
  sample_.pitch_deg = ToDegrees(state.attitude.pitch);
  sample_.roll_deg = ToDegrees(state.attitude.roll);
  sample_.speed_mps = result_.speed;
  sample_.turn_rate_dps = ToDegrees(result_.turn_rate);
  for (int j = 0; j < kJointCount; ++j) {
    sample_.joint[j] = j == kGripperOpening ? state.joint[j] : ToDegrees(state.joint[j]);
  }
  sample_.limit_flags = result_.limit_flags;
  sample_.inhibit_mask = result_.inhibited;
  sample_.contact_parts = result_.contact_parts;
  sample_.blocked_mask = response_.blocked & kAllMotions;
  moved_.clear();
  const std::span<const Eigen::Isometry3d> poses = place_->poses(), starts = place_->starts();
  for (size_t i = 0; i < poses.size(); ++i) {
    moved_.push_back((poses[i].translation() - starts[i].translation()).norm());
  }
  sample_.moved_m = moved_;
}

void Simulator::TellOfCharge() {
  const DisposalStatus& disposal = result_.disposal;
  const ModuleModel& module = place_->module();
  const auto name_of = [&module](int body) -> std::string_view {
    return body < 0 ? "" : std::string_view(module.movables[static_cast<size_t>(body)].name);
  };
  sample_.held_object = name_of(disposal.held_body);
  sample_.fire_state = static_cast<int>(disposal.fire);
  sample_.charge = name_of(disposal.bomb_body);
  sample_.charge_touched = disposal.touched;
  sample_.bomb_state = static_cast<int>(disposal.bomb);
  sample_.charge_position = Eigen::Vector3d::Zero();
  sample_.charge_low_m = 0;
  sample_.charge_in_hand = Eigen::Vector3d::Zero();
  if (disposal.bomb_body < 0) return;
  const auto charge = static_cast<size_t>(disposal.bomb_body);
  const Eigen::Isometry3d& X_MO = place_->poses()[charge];
  sample_.charge_position = module.p_WM + X_MO.translation();
  const double low = LowestPoint(*module.movables[charge].explosive, X_MO);
  sample_.charge_low_m = module.p_WM.z() + low;
  if (!hand_.has_hands()) return;
  const Eigen::Vector3d middle(0, hand_.finger() / 2, 0);
  const Eigen::Vector3d jaws_M =
      (link_poses_[hand_.left()] * middle + link_poses_[hand_.right()] * middle) / 2;
  const Eigen::Matrix3d R_GM = link_poses_[hand_.gripper()].linear().transpose();
  sample_.charge_in_hand = R_GM * (X_MO.translation() - jaws_M);
}

void Simulator::Judge(const OperatorCommand& command, MotionSet wished) {
  const bool ran = Runs(sample_.mission_state);
  NoteChecks(command);
  TellOfRobot();
  TellOfCharge();
  sample_.wanted_mask = wished;
  sample_.system_state = command.system_state;
  sample_.speed_range = command.speed_range;
  sample_.camera_select = command.camera_select;
  sample_.horn = command.horn;
  sample_.arm_key = command.fire.arm_key;
  sample_.fire_left = command.fire.fire_left;
  sample_.fire_right = command.fire.fire_right;
  sample_.checks = checks_;
  sample_.mission_state = static_cast<int>(result_.task.state);
  sample_.mission_step = result_.task.step;
  sample_.fail_reason = static_cast<int>(result_.task.fail_reason);
  sample_.mission_s = result_.task.elapsed_s;
  place_->score.Advance(sample_);
  const double before = result_.task.score;
  const bool idle = result_.task.state == MissionState::kIdle;
  result_.task.score = idle ? 0 : place_->score.total();
  // Fractions of a point can wait for the next message: pushing on costs a little every step.
  if (std::floor(before) != std::floor(result_.task.score)) result_.task_changed = true;
  if (ran && !Runs(sample_.mission_state)) checks_ = 0;
}

}  // namespace eod::sim
