#include "firmware_emu/panel_scanner.h"

#include <algorithm>
#include <cmath>

namespace eod::box {

using dbc::Button;
using dbc::Deadman;

namespace {

constexpr double kAdcFullScale = 2047;  // 12-bit converter, signed

}  // namespace

PanelScanner::PanelScanner(const ScannerConfig& config) : config_(config) {}

void PanelScanner::PowerUp() { *this = PanelScanner(config_); }

bool PanelScanner::Read(Switch& button, TimePoint now, bool pressed) const {
  const bool contact = button.contact.Update(now, pressed, config_.bounce_time);
  const bool is_down = button.debounced.Update(now, contact, config_.settle_time);
  if (!is_down) button.is_ignored = false;
  return is_down && !button.is_ignored;
}

// Pressing is believed at once, releasing only after it has settled.
void PanelScanner::ReadEstop(TimePoint now, const PanelInputs& inputs) {
  const bool pressed = mushroom_.Update(now, inputs.estop_pressed, config_.bounce_time);
  const bool raw_a = !pressed && !inputs.estop_a_fault;
  if (!raw_a) estop_a_.Force(false);
  if (pressed) estop_b_.Force(true);
  state_.estop_a = estop_a_.Update(now, raw_a, config_.settle_time);
  state_.estop_b = estop_b_.Update(now, pressed, config_.settle_time);
  if (state_.estop_a != state_.estop_b || is_first_scan_) channels_differed_ = now;
  has_channel_fault_ = now - channels_differed_ > config_.channel_tolerance;
}

// Leaving the middle position is believed at once. After panic the middle position enables nothing
// until the switch was let go fully (IEC 60204-1, three-position enabling devices).
Deadman PanelScanner::ReadDeadman(TimePoint now, Deadman raw) {
  const Deadman contact = deadman_contact_.Update(now, raw, config_.bounce_time);
  if (contact != Deadman::kEnabled) deadman_.Force(contact);
  const Deadman position = deadman_.Update(now, contact, config_.settle_time);
  if (position == Deadman::kPanic) deadman_needs_release_ = true;
  if (position == Deadman::kReleased && raw == Deadman::kReleased) {
    deadman_needs_release_ = false;
    is_deadman_stuck_ = false;
  }
  const bool refused = position == Deadman::kEnabled && deadman_needs_release_;
  return refused ? Deadman::kReleased : position;
}

dbc::Axis PanelScanner::ReadAxis(int index, const dbc::Axis& stick) {
  if (!stick.valid || !std::isfinite(stick.value)) return {.value = 0, .valid = false};
  const double counts = std::round(std::clamp(stick.value, -1.0, 1.0) * kAdcFullScale);
  const double deflection = counts / kAdcFullScale;
  const bool is_centred = std::abs(deflection) < config_.axis_dead_zone;
  if (is_centred) is_axis_ignored_[index] = false;
  return {.value = is_centred || is_axis_ignored_[index] ? 0.0 : deflection, .valid = true};
}

const dbc::PanelState& PanelScanner::Scan(TimePoint now, const PanelInputs& inputs) {
  const auto to_button = [](bool down) { return down ? Button::kPressed : Button::kReleased; };
  // Selectors and menu keys are taken as they stand; what moves the robot is scanned.
  const dbc::PanelState previous = state_;
  state_ = inputs.controls;
  state_.box_fault = previous.box_fault;
  state_.nmt = previous.nmt;
  state_.nonce_echo = previous.nonce_echo;
  state_.key = key_.Update(now, inputs.controls.key, config_.settle_time);
  ReadEstop(now, inputs);
  state_.deadman = ReadDeadman(now, inputs.controls.deadman);
  state_.reset = to_button(Read(reset_, now, inputs.controls.reset == Button::kPressed));
  state_.start = to_button(Read(start_, now, inputs.controls.start == Button::kPressed));
  for (int m = 0; m < dbc::kMotionCount; ++m) {
    state_.motion[m] = Read(motion_[m], now, inputs.controls.motion[m]);
  }
  state_.button_channel_fault =
      std::any_of(motion_.begin(), motion_.end(), [](const Switch& s) { return s.is_ignored; });
  for (int a = 0; a < dbc::kAxisCount; ++a) {
    state_.axis[a] = ReadAxis(a, inputs.controls.axis[a]);
  }
  is_first_scan_ = false;
  return state_;
}

void PanelScanner::CheckNeutral() {
  for (Switch& button : motion_) button.is_ignored = button.debounced.value();
  reset_.is_ignored = reset_.debounced.value();
  start_.is_ignored = start_.debounced.value();
  for (int a = 0; a < dbc::kAxisCount; ++a) is_axis_ignored_[a] = state_.axis[a].value != 0;
  is_deadman_stuck_ = deadman_.value() != Deadman::kReleased;
  deadman_needs_release_ = is_deadman_stuck_;
}

bool PanelScanner::has_stuck_control() const {
  const auto is_true = [](bool ignored) { return ignored; };
  return state_.button_channel_fault || reset_.is_ignored || start_.is_ignored ||
         is_deadman_stuck_ ||
         std::any_of(is_axis_ignored_.begin(), is_axis_ignored_.end(), is_true);
}

bool PanelScanner::has_axis_fault() const {
  return std::any_of(state_.axis.begin(), state_.axis.end(),
                     [](const dbc::Axis& axis) { return !axis.valid; });
}

}  // namespace eod::box
