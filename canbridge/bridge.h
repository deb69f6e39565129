#pragma once

#include <optional>
#include <span>
#include <vector>

#include "canbridge/alarm_board.h"
#include "canbridge/bridge_messages.h"
#include "canbridge/feedback.h"
#include "canbridge/link_meter.h"
#include "canbridge/link_supervision.h"
#include "canbridge/transmit_schedule.h"
#include "dbc/box_codec.h"
#include "dbc/control_map.h"
#include "dbc/database.h"
#include "platform/can_frame.h"
#include "platform/time.h"

namespace eod::bridge {

/// Rates of the bridge. The defaults are the product's; tests vary them.
struct BridgeConfig {
  SupervisionLimits limits;
  Duration tick_period = std::chrono::milliseconds(1);
  Duration command_period = std::chrono::milliseconds(20);  ///< without a change
  Duration link_status_period = std::chrono::milliseconds(100);
  Duration alarm_repeat_period = std::chrono::milliseconds(100);
  Duration change_gap = std::chrono::milliseconds(10);  ///< of two on-change frames
  Duration panel_age = std::chrono::milliseconds(500);  ///< older: momentary controls are released
  Duration mission_sound = std::chrono::seconds(2);     ///< buzzer at success or failure
};

/// What there is to send after one input.
struct BridgeOutput {
  std::vector<CanFrame> frames;            ///< to the bus, in this order
  std::optional<BoxCommand> command;       ///< to publish
  std::optional<LinkStatus> link;          ///< to publish
  std::vector<AlarmChange> alarm_changes;  ///< of the bridge's own alarms, one message each
  bool is_alarm_repeat_due = false;        ///< publish the set again, without a change
  std::vector<ActiveAlarm> active_alarms;  ///< the bridge's own, gravest first
};

/// The robot's end of the link: box frames to commands, robot state and alarms to frames.
///
/// Event driven: whatever an input changes is in the output of that very call. Ramps, time-outs and
/// cyclic messages happen in `Tick`. Only robot messages are ever sent: the fire panel goes into
/// the command, to no bus. If another robot's frame is seen on the bus, the bridge sends nothing
/// any more. Outputs are valid until the next call. No allocation after the first second.
class Bridge {
 public:
  /// `map` must outlive the bridge. Throws std::runtime_error "FILE:LINE: …" if the map does not
  /// fit the database.
  Bridge(const BridgeConfig& config, const dbc::Database& database, const dbc::ControlMap& map);

  const BridgeOutput& OnFrame(TimePoint now, const CanFrame& frame);
  const BridgeOutput& OnRobotState(TimePoint now, const RobotReport& robot);
  /// The simulator's active alarms changed or are repeated.
  const BridgeOutput& OnAlarms(TimePoint now, const AlarmReport& alarms);
  const BridgeOutput& OnMission(TimePoint now, const MissionReport& mission);
  const BridgeOutput& Tick(TimePoint now, const BusReport& bus);

  const Supervision& supervision() const { return supervision_.outcome(); }
  bool is_silent() const { return is_foreign_robot_; }

 private:
  void Begin(TimePoint now);
  void TakeBoxFrame(const dbc::Received<dbc::BoxMessage>& received);
  void TakePanel();
  const BridgeOutput& Finish();
  void PublishCommand();
  void PublishAlarms();
  void PublishLinkStatus();
  void RefreshFeedback();
  void SendChanges();
  void SendCyclic();
  void Send(dbc::RobotMessage role);
  bool IsWithin(const std::optional<TimePoint>& time, Duration age) const {
    return time && now_ - *time <= age;
  }

  BridgeConfig config_;
  dbc::BoxCodec codec_;
  LinkSupervision supervision_;
  AlarmBoard alarms_;
  TransmitSchedule schedule_;
  LinkMeter meter_;

  TimePoint now_{};
  dbc::PanelState panel_;
  RobotReport robot_;
  MissionReport mission_;
  BusReport bus_;
  RejectCounts rejects_;
  dbc::RobotFeedback feedback_;
  dbc::RobotFeedback sent_status_;
  dbc::RobotFeedback sent_alarm_;
  dbc::RobotFeedback sent_fire_;
  int sent_emergency_ = 0;
  bool has_booted_ = false;
  bool is_foreign_robot_ = false;
  bool was_acknowledged_ = false;
  std::optional<TimePoint> last_panel_;
  std::optional<TimePoint> last_fire_;
  bool is_fire_doubtful_ = false;  ///< the last fire frame was dropped
  std::optional<TimePoint> mission_sound_end_;
  dbc::BuzzerPattern mission_sound_ = dbc::BuzzerPattern::kOff;

  std::optional<BoxCommand> published_command_;
  TimePoint command_due_{};
  TimePoint alarms_due_{};
  TimePoint link_due_{};
  dbc::SystemState published_state_ = dbc::SystemState::kInit;
  Refusal published_refusal_ = Refusal::kNone;
  BridgeOutput output_;
};

}  // namespace eod::bridge
