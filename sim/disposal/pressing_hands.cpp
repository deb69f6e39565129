#include "sim/disposal/pressing_hands.h"

#include <utility>

#include "sim/disposal/charge.h"

namespace eod::sim {
namespace {

constexpr MotionSet kClose = SetOf(kGripperClose);

int FirstOf(int a, int b) { return a >= 0 ? a : b; }

}  // namespace

PressingHands::PressingHands(const HandLayout& hand, const ModuleModel& module,
                             const GraspRules& rules)
    : hand_(hand), module_(module), rules_(rules), charges_(ChargesOf(module)) {}

void PressingHands::Reset() {
  LetGo();
  left_pad_ = right_pad_ = -1;
}

bool PressingHands::IsStopped(double press, bool was_stopped) const {
  return press >= (was_stopped ? rules_.pad / 2 : rules_.pad);
}

void PressingHands::Update(bool close, const HandLines& lines,
                           std::span<const Eigen::Isometry3d> X_ML,
                           std::span<const BodyState> bodies, Response& response,
                           std::span<char> touched) {
  left_ = right_ = -1;
  const int left_pad = std::exchange(left_pad_, -1), right_pad = std::exchange(right_pad_, -1);
  if (!close) {
    pinched_ = -1;
    return;
  }
  if ((response.left_hand_blocked & kClose) != 0) {
    left_ = FirstOf(lines[kL1].charge, lines[kL2].charge);
  }
  if ((response.right_hand_blocked & kClose) != 0) {
    right_ = FirstOf(lines[kL4].charge, lines[kL5].charge);
  }
  for (const int charge : charges_) {
    const BodyState& body = bodies[charge];
    if (body.is_gone) continue;
    const PadPress press = PressOn(hand_, X_ML, *module_.movables[charge].explosive, body.X_MO,
                                   rules_.pad_half_height);
    if (press.left > 0 || press.right > 0) touched[charge] = 1;
    if (IsStopped(press.left, left_pad == charge)) {
      left_ = left_pad_ = charge;
      response.left_hand_blocked |= kClose;
      response.contact_parts |= 1u << static_cast<int>(Part::kLeftHand);
    }
    if (IsStopped(press.right, right_pad == charge)) {
      right_ = right_pad_ = charge;
      response.right_hand_blocked |= kClose;
      response.contact_parts |= 1u << static_cast<int>(Part::kRightHand);
    }
  }
  response.blocked |= response.left_hand_blocked & response.right_hand_blocked;
}

void PressingHands::Pinch(const Response& response) {
  const int pressed = FirstOf(left_, right_);
  if (pressed >= 0 && Contains(response.blocked, kGripperClose)) pinched_ = pressed;
}

GraspState PressingHands::State(const HandLines& lines, bool closing) const {
  const bool left = left_ >= 0 || lines[kL1].charge >= 0 || lines[kL2].charge >= 0;
  const bool right = right_ >= 0 || lines[kL4].charge >= 0 || lines[kL5].charge >= 0;
  if (left && right) return GraspState::kContactBoth;
  if (left) return GraspState::kContactLeft;
  if (right) return GraspState::kContactRight;
  return closing ? GraspState::kClosing : GraspState::kOpen;
}

}  // namespace eod::sim
