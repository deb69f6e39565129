#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "dbc/control_map.h"
#include "dbc/database.h"
#include "dbc/e2e.h"
#include "dbc/panel_state.h"
#include "dbc/robot_feedback.h"
#include "platform/can_frame.h"

namespace eod::dbc {

/// What a frame is for. The map names the DBC message of each role; several messages may not share
/// one.
enum class BoxMessage : uint8_t { kSafety, kMotion, kAxes, kPanel, kFire, kHeartbeat, kEmergency };
enum class RobotMessage : uint8_t {
  kStatus,
  kAlarm,
  kJointA,
  kJointB,
  kJointC,
  kPose,
  kBattery,
  kMission,
  kFire,
  kHeartbeat,
  kEmergency
};
inline constexpr int kBoxMessageCount = 7;
inline constexpr int kRobotMessageCount = 11;

/// Verdict on one received frame.
enum class FrameVerdict : uint8_t {
  kAccepted,
  kUnknownId,      ///< not in the DBC or not in the map
  kWrongLength,    ///< shorter than declared: dropped
  kWrongCrc,       ///< dropped
  kRepeated,       ///< counter did not advance: dropped
  kWrongSequence,  ///< counter jumped, or still re-synchronising: dropped
};

/// A frame that concerns this end of the link.
template <typename Role>
struct Received {
  FrameVerdict verdict = FrameVerdict::kUnknownId;
  std::optional<Role> role;  ///< empty for kUnknownId
};

/// Translates between frames and the panel or the feedback, by DBC and map. One object per end of
/// the link and per run: it holds the E2E counters. No allocation after construction.
class BoxCodec {
 public:
  /// Throws std::runtime_error "FILE:LINE: …" if the map names what the DBC does not have.
  BoxCodec(const Database& database, const ControlMap& map);
  ~BoxCodec();
  BoxCodec(BoxCodec&&) noexcept;

  // The box's end.
  /// Frame for `role`, with the next counter and the CRC. Empty if the map has no such message.
  std::optional<CanFrame> Encode(BoxMessage role, const PanelState& panel);
  /// Updates the fields of `feedback` that this frame carries, if it is accepted.
  Received<RobotMessage> Decode(const CanFrame& frame, RobotFeedback& feedback);

  // The robot's end.
  std::optional<CanFrame> Encode(RobotMessage role, const RobotFeedback& feedback);
  /// Updates the fields of `panel` that this frame carries, if it is accepted.
  Received<BoxMessage> Decode(const CanFrame& frame, PanelState& panel);

  /// Declared cycle time; zero for event messages and for roles the map leaves out.
  Duration cycle_time(BoxMessage role) const;
  Duration cycle_time(RobotMessage role) const;

  /// True for an identifier that the DBC lets the robot send.
  bool IsRobotId(uint32_t id, bool extended) const;
  bool IsBoxId(uint32_t id, bool extended) const;

  /// Frames lost in counter gaps, all messages together.
  uint64_t lost() const;
  /// Forgets all E2E sequences, as after a time-out of the link.
  void ResetSequences();

 private:
  struct Plans;
  std::unique_ptr<Plans> plans_;
};

}  // namespace eod::dbc
