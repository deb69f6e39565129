#pragma once

#include <array>

#include "dbc/panel_state.h"
#include "firmware_emu/debounce.h"
#include "firmware_emu/panel_inputs.h"
#include "platform/time.h"

namespace eod::box {

struct ScannerConfig {
  /// A switch position counts once it rested this long. Safety switches take their safe position at
  /// once.
  Duration settle_time = std::chrono::milliseconds(10);
  /// Contacts bounce this long after each change; 0: ideal contacts.
  Duration bounce_time = Duration::zero();
  /// E-stop channels that agree (both on, both off) for longer are a fault (domain rule 4).
  Duration channel_tolerance = std::chrono::milliseconds(60);
  /// Share of full deflection around a stick's centre that reads as 0.
  double axis_dead_zone = 0.02;
};

/// Reads the controls as the firmware does, once a tick: debounces switches, samples the sticks
/// with 12 bits, watches the antivalent e-stop contacts and ignores what was held at power-up.
class PanelScanner {
 public:
  explicit PanelScanner(const ScannerConfig& config);

  /// Forgets everything; controls start in their safe positions.
  void PowerUp();

  /// The state to report. `inputs` are the controls at `now`.
  const dbc::PanelState& Scan(TimePoint now, const PanelInputs& inputs);

  /// Neutral check at the end of the self-test: what is held now is ignored until it is let go
  /// (domain rule 5, and a tied-down enabling switch).
  void CheckNeutral();

  bool has_stuck_control() const;
  bool has_channel_fault() const { return has_channel_fault_; }
  bool has_axis_fault() const;

  const dbc::PanelState& state() const { return state_; }

 private:
  struct Switch {
    BouncingContact<bool> contact{false};
    Debounced<bool> debounced{false};
    bool is_ignored = false;
  };
  bool Read(Switch& button, TimePoint now, bool pressed) const;
  void ReadEstop(TimePoint now, const PanelInputs& inputs);
  dbc::Deadman ReadDeadman(TimePoint now, dbc::Deadman raw);
  dbc::Axis ReadAxis(int index, const dbc::Axis& stick);

  ScannerConfig config_;
  dbc::PanelState state_;
  std::array<Switch, dbc::kMotionCount> motion_;
  Switch reset_;
  Switch start_;
  std::array<bool, dbc::kAxisCount> is_axis_ignored_{};
  Debounced<dbc::KeySwitch> key_{dbc::KeySwitch::kOff};
  BouncingContact<bool> mushroom_{false};
  Debounced<bool> estop_a_{true};
  Debounced<bool> estop_b_{false};
  TimePoint channels_differed_{};
  bool has_channel_fault_ = false;
  BouncingContact<dbc::Deadman> deadman_contact_{dbc::Deadman::kReleased};
  Debounced<dbc::Deadman> deadman_{dbc::Deadman::kReleased};
  bool deadman_needs_release_ = false;
  bool is_deadman_stuck_ = false;
  bool is_first_scan_ = true;
};

}  // namespace eod::box
