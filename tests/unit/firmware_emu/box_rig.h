#pragma once

#include <chrono>
#include <functional>
#include <vector>

#include "dbc/box_codec.h"
#include "dbc/control_map.h"
#include "dbc/database.h"
#include "firmware_emu/control_box.h"

namespace eod::box {

using std::chrono::milliseconds;
using std::chrono::seconds;

inline TimePoint At(Duration since_epoch) { return TimePoint{since_epoch}; }

inline dbc::BoxCodec ShippedCodec() {
  return {dbc::LoadDatabase(EOD_DATA_DIR "/dbc/control_box.dbc"),
          dbc::LoadControlMap(EOD_DATA_DIR "/dbc/control_box.map.toml")};
}

/// A control box on a desk: virtual time from 0, hands in `inputs`, and a robot that says `robot`
/// every 50 ms while `robot_talks`.
class BoxRig {
 public:
  explicit BoxRig(const ControlBoxConfig& config = {}) : dut(ShippedCodec(), config) {}

  /// Ticks every millisecond up to and including now + `duration`.
  void Run(Duration duration) {
    for (const TimePoint end = now + duration; now < end;) {
      now += milliseconds(1);
      Tick();
    }
  }

  void Tick() {
    for (const CanFrame& frame : dut.Tick(now, inputs)) {
      sent.push_back(frame);
      sent.back().stamp = now;
    }
    const bool is_robot_due = now.time_since_epoch() % milliseconds(50) == Duration::zero();
    if (robot_talks && is_robot_due) RobotSays();
  }

  void RobotSays() {
    for (const auto role : {dbc::RobotMessage::kStatus, dbc::RobotMessage::kAlarm,
                            dbc::RobotMessage::kPose, dbc::RobotMessage::kFire}) {
      dut.OnFrame(*robot_codec.Encode(role, robot), now);
    }
  }

  /// Boot and self-test are over after this.
  void PowerUp() {
    Tick();
    Run(milliseconds(520));
  }

  std::vector<CanFrame> SentWithId(uint32_t id) const {
    std::vector<CanFrame> frames;
    for (const CanFrame& frame : sent) {
      if (frame.id == id) frames.push_back(frame);
    }
    return frames;
  }

  TimePoint now{};
  PanelInputs inputs;
  dbc::RobotFeedback robot;
  bool robot_talks = false;
  dbc::BoxCodec robot_codec = ShippedCodec();
  ControlBox dut;
  std::vector<CanFrame> sent;  ///< stamp: when it was sent
};

inline constexpr uint32_t kSafetyId = 0x190;
inline constexpr uint32_t kMotionId = 0x290;
inline constexpr uint32_t kAxesId = 0x390;
inline constexpr uint32_t kPanelId = 0x490;
inline constexpr uint32_t kFireId = 0x0F0;
inline constexpr uint32_t kHeartbeatId = 0x710;
inline constexpr uint32_t kEmergencyId = 0x090;

}  // namespace eod::box
