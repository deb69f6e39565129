#pragma once

#include <array>
#include <string>
#include <string_view>

namespace eod {

/// One row of the LCM contract. A channel's name on the wire is the station's prefix followed by
/// `name`.
struct Channel {
  std::string_view name;
  std::string_view type;
  std::string_view publisher;
  std::string_view subscribers;
  std::string_view rate;
};

/// The one table of channels.
inline constexpr Channel kBoxCommandChannel{"EOD_BOX_COMMAND", "box_command_t", "canbridge",
                                            "sim, recorder, console", "on change, and every 20 ms"};
inline constexpr Channel kRobotStateChannel{"EOD_ROBOT_STATE", "robot_state_t", "sim",
                                            "canbridge, recorder, firmware_emu's scripts",
                                            "every step"};
inline constexpr Channel kAlarmChannel{"EOD_ALARM", "alarm_t", "sim, canbridge",
                                       "canbridge, recorder", "on change, and every 100 ms"};
inline constexpr Channel kIsectorHitsChannel{"EOD_ISECTOR_HITS", "isector_hits_t", "sim",
                                             "recorder", "every step with --publish-isectors"};
inline constexpr Channel kLinkStatusChannel{"EOD_LINK_STATUS", "link_status_t", "canbridge",
                                            "recorder", "on change, and every 100 ms"};
inline constexpr Channel kMissionStatusChannel{"EOD_MISSION_STATUS", "mission_status_t", "sim",
                                               "canbridge, recorder, console",
                                               "on change, and every 200 ms"};
inline constexpr Channel kInstructorChannel{"EOD_INSTRUCTOR", "instructor_command_t",
                                            "any instructor's panel or test", "sim", "on change"};
inline constexpr Channel kSceneChannel{"EOD_SCENE", "scene_t", "sim", "firmware_emu's scripts",
                                       "on entering or a change of the exercise, and every 100 ms"};
inline constexpr Channel kTelemetryStateChannel{"EOD_TELEMETRY_STATE", "robot_state_t", "sim",
                                                "canbridge, recorder",
                                                "every step that gets through a real link"};
inline constexpr Channel kTelemetryAlarmChannel{
    "EOD_TELEMETRY_ALARM", "alarm_t", "sim", "canbridge, recorder", "as EOD_ALARM, over the link"};
inline constexpr Channel kTelemetryMissionChannel{"EOD_TELEMETRY_MISSION", "mission_status_t",
                                                  "sim", "canbridge, recorder",
                                                  "as EOD_MISSION_STATUS, over the link"};
inline constexpr Channel kFaultEventChannel{"EOD_FAULT_EVENT", "fault_event_t", "sim", "recorder",
                                            "when a fault of the exercise begins or ends"};
inline constexpr Channel kDriveCameraChannel{"EOD_CAMERA_DRIVE", "image_t", "sim",
                                             "recorder, console", "25 to 30 Hz"};
inline constexpr Channel kMastCameraChannel{"EOD_CAMERA_MAST", "image_t", "sim",
                                            "recorder, console", "25 to 30 Hz"};
inline constexpr Channel kGripperCameraChannel{"EOD_CAMERA_GRIPPER", "image_t", "sim",
                                               "recorder, console", "25 to 30 Hz while chosen"};
inline constexpr Channel kRearCameraChannel{"EOD_CAMERA_REAR", "image_t", "sim",
                                            "recorder, console", "25 to 30 Hz while chosen"};
inline constexpr Channel kQuadCameraChannel{"EOD_CAMERA_QUAD", "image_t", "sim",
                                            "recorder, console", "25 to 30 Hz while chosen"};
inline constexpr Channel kPanelCommandChannel{"EOD_PANEL_COMMAND", "panel_command_t",
                                              "any panel or test", "firmware_emu", "on change"};
inline constexpr Channel kPanelStatusChannel{"EOD_PANEL_STATUS", "panel_status_t", "firmware_emu",
                                             "recorder", "on change, and every 100 ms"};

inline constexpr std::array kChannels{kBoxCommandChannel,
                                      kRobotStateChannel,
                                      kAlarmChannel,
                                      kIsectorHitsChannel,
                                      kLinkStatusChannel,
                                      kMissionStatusChannel,
                                      kInstructorChannel,
                                      kSceneChannel,
                                      kTelemetryStateChannel,
                                      kTelemetryAlarmChannel,
                                      kTelemetryMissionChannel,
                                      kFaultEventChannel,
                                      kDriveCameraChannel,
                                      kMastCameraChannel,
                                      kGripperCameraChannel,
                                      kRearCameraChannel,
                                      kQuadCameraChannel,
                                      kPanelCommandChannel,
                                      kPanelStatusChannel};

/// Name of `channel` on the wire for the station `prefix` (empty for a single station).
inline std::string ChannelName(std::string_view prefix, const Channel& channel) {
  return std::string(prefix) + std::string(channel.name);
}

}  // namespace eod
