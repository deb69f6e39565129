#include "sim/disposal/fire_circuit.h"

#include <cmath>

namespace eod::sim {
namespace {

enum Contact : int { kSafeOrReleased = 1, kArmedOrPressed = 2 };

bool IsValid(int contact) { return contact == kSafeOrReleased || contact == kArmedOrPressed; }

bool IsValid(const FirePanel& panel) {
  return IsValid(panel.arm_key) && IsValid(panel.fire_left) && IsValid(panel.fire_right);
}

bool IsAtRest(const FirePanel& panel) {
  return panel.arm_key == kSafeOrReleased && panel.fire_left == kSafeOrReleased &&
         panel.fire_right == kSafeOrReleased;
}

// Durations are sums of steps: a millionth of a second must not cost one more.
constexpr double kRounding = 1e-6;

/// SplitMix64, a well-mixed number of any number (Steele, Lea, Flood 2014).
uint64_t Mix(uint64_t z) {
  z += 0x9E3779B97F4A7C15;
  z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9;
  z = (z ^ (z >> 27)) * 0x94D049BB133111EB;
  return z ^ (z >> 31);
}

}  // namespace

void FireCircuit::Button::Update(bool pressed, bool ready, double dt_s) {
  if (!pressed) {
    *this = {.was_released = true};
  } else if (counts) {
    held_s += dt_s;
  } else if (ready && was_released && held_s == 0) {
    counts = true;
  } else {
    held_s += dt_s;  // pressed too early: it has to be released first
  }
}

void FireCircuit::Arm(int64_t step) {
  state_ = FireState::kArmedWait;
  armed_s_ = 0;
  held_s_ = 0;
  left_ = right_ = {};
  nonce_ = static_cast<int>(1 + Mix(seed_ ^ Mix(static_cast<uint64_t>(step))) % 255);
  if (nonce_ == last_nonce_) nonce_ = 1 + nonce_ % 255;
  last_nonce_ = nonce_;
}

bool FireCircuit::IsReady(const FirePanel& panel, bool robot_is_still) const {
  const bool is_circuit = panel.circuit >= 1 && panel.circuit <= 3;
  return armed_s_ >= rules_.arm - kRounding && robot_is_still && is_circuit &&
         (continuity_ >> (panel.circuit - 1) & 1) != 0;
}

/// Both buttons have been held long enough, everything else being right.
bool FireCircuit::HoldsBoth(const FirePanel& panel, double dt_s) {
  const bool together = left_.counts && right_.counts &&
                        std::abs(left_.held_s - right_.held_s) <= rules_.both_within + kRounding;
  if (!together || state_ != FireState::kReady || panel.nonce_echo != nonce_) {
    held_s_ = 0;
    return false;
  }
  const bool long_enough = held_s_ >= rules_.hold - kRounding;
  held_s_ += dt_s;
  return long_enough;
}

bool FireCircuit::Advance(const FirePanel& panel, bool robot_is_still, int64_t step, double dt_s) {
  has_spoken_ = has_spoken_ || panel != FirePanel{};
  if (!has_spoken_) return false;
  if (!IsValid(panel)) {
    state_ = FireState::kFault;
    nonce_ = 0;
    return false;
  }
  const bool armed = panel.arm_key == kArmedOrPressed;
  const bool is_over =
      state_ == FireState::kFault || state_ == FireState::kFired || state_ == FireState::kTimeOut;
  key_was_safe_ = key_was_safe_ || !armed;
  if (!key_was_safe_) return false;
  if (is_over ? IsAtRest(panel) : !armed) {
    state_ = FireState::kSafe;
    nonce_ = 0;
    return false;
  }
  if (is_over) return false;
  if (state_ == FireState::kSafe) {
    Arm(step);
  } else {
    armed_s_ += dt_s;
  }
  if (armed_s_ > rules_.time_out + kRounding) {
    state_ = FireState::kTimeOut;
    nonce_ = 0;
    return false;
  }
  const bool ready = IsReady(panel, robot_is_still);
  state_ = ready ? FireState::kReady : FireState::kArmedWait;
  left_.Update(panel.fire_left == kArmedOrPressed, ready, dt_s);
  right_.Update(panel.fire_right == kArmedOrPressed, ready, dt_s);
  if (!HoldsBoth(panel, dt_s)) return false;
  state_ = FireState::kFired;
  nonce_ = 0;
  continuity_ &= ~(1 << (panel.circuit - 1));
  return true;
}

}  // namespace eod::sim
