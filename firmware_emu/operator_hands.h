#pragma once

#include <array>
#include <optional>

#include "firmware_emu/panel_action.h"
#include "firmware_emu/panel_inputs.h"
#include "platform/time.h"

namespace eod::box {

/// The operator's hands on the controls: applies actions, and lets go of push buttons in time.
class OperatorHands {
 public:
  /// A tapped button is held this long: four frames of 50 ms.
  static constexpr Duration kTapTime = std::chrono::milliseconds(200);

  void Apply(const PanelAction& action, TimePoint now);

  /// Holds the button of `motion` (1..22) until `end`, or longer if it is held already.
  void HoldMotionUntil(int motion, TimePoint end);
  /// Requests `preset` (1..7) until `end`, or longer if it is requested already.
  void HoldPresetUntil(int preset, TimePoint end);
  /// Holds the fire button `button` (Control::kFireLeft or kFireRight) until `end`, or longer if it
  /// is held already.
  void HoldFireUntil(Control button, TimePoint end);
  void SetLampTestUntil(TimePoint end);

  /// Lets go of what was held long enough. To be called every tick.
  void Tick(TimePoint now);

  const PanelInputs& inputs() const { return inputs_; }

 private:
  void ApplyTap(Control control, int choice, TimePoint end);
  void ApplySelector(const PanelAction& action);
  void ReleaseAll();

  PanelInputs inputs_;
  std::optional<TimePoint> reset_end_;
  std::optional<TimePoint> start_end_;
  std::optional<TimePoint> menu_end_;
  std::optional<TimePoint> acknowledge_end_;
  std::optional<TimePoint> alarm_reset_end_;
  std::optional<TimePoint> lamp_test_end_;
  std::optional<TimePoint> preset_end_;
  std::optional<TimePoint> fire_left_end_;
  std::optional<TimePoint> fire_right_end_;
  std::array<std::optional<TimePoint>, dbc::kMotionCount> motion_end_;
};

}  // namespace eod::box
