#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "dbc/box_codec.h"
#include "firmware_emu/panel_inputs.h"
#include "firmware_emu/panel_scanner.h"
#include "firmware_emu/panel_status.h"
#include "firmware_emu/transmit_schedule.h"
#include "platform/can_frame.h"
#include "platform/time.h"

namespace eod::box {

struct ControlBoxConfig {
  Duration boot_time = std::chrono::milliseconds(100);       ///< power to boot-up heartbeat
  Duration self_test_time = std::chrono::milliseconds(400);  ///< boot-up heartbeat to operational
  Duration link_timeout = std::chrono::milliseconds(500);    ///< without a valid robot frame
  double supply_v = 24;                                      ///< [V] reported battery voltage
  int variant = 0;                                           ///< BoxVariant: 0 emulator
  int protocol_major = 1;
  ScannerConfig scanner;
};

/// The firmware of a control box: controls in, frames out; frames in, lamps and buzzer out.
///
/// Pure: to be ticked every millisecond with the positions of the controls.
///
///   power ──▶ boot ──▶ self-test ──▶ standby ◀─key─▶ ready ◀─robot─▶ operate
///                                       └── e-stop latched, fault, link lost: gravest first ──┘
class ControlBox {
 public:
  ControlBox(dbc::BoxCodec codec, const ControlBoxConfig& config);

  /// Advances to `now`. The frames are to be sent at once, in this order; they stay valid until the
  /// next call.
  std::span<const CanFrame> Tick(TimePoint now, const PanelInputs& inputs);

  /// Takes one frame from the bus, received at `now`.
  void OnFrame(const CanFrame& frame, TimePoint now);

  const PanelStatus& status() const { return status_; }
  const dbc::BoxCodec& codec() const { return codec_; }

 private:
  enum class Phase : uint8_t { kOff, kBoot, kSelfTest, kRunning };
  void AdvancePhase(TimePoint now, bool powered);
  void EnterPhase(Phase phase, TimePoint since);
  void PowerDown();
  void Report(TimePoint now, const PanelInputs& inputs);
  BoxFault FindFault() const;
  void SuperviseLink(TimePoint now);
  void UpdateEstopLatch();
  BoxState FindState() const;
  void Transmit(TimePoint now);
  void Queue(dbc::BoxMessage role);
  void Show(TimePoint now);
  void ShowLocalLamps();

  ControlBoxConfig config_;
  dbc::BoxCodec codec_;
  PanelScanner scanner_;
  TransmitSchedule schedule_;
  PanelStatus status_;
  std::vector<CanFrame> frames_;
  Phase phase_ = Phase::kOff;
  TimePoint phase_since_{};
  TimePoint last_rx_{};
  TimePoint buzzer_since_{};
  BoxFault announced_fault_ = BoxFault::kNone;
  bool is_link_lost_ = false;
  bool is_estop_latched_ = false;
  bool is_safety_event_ = false;
};

}  // namespace eod::box
