#pragma once

#include "dbc/roles.h"

/// The named values of every role. The order is that of the enumerations in panel_state.h and
/// robot_feedback.h, and of the numbers that their comments give.
namespace eod::dbc::choices {

using Names = const std::string_view[];

inline constexpr Names kFlagNames = {"off", "on"};
inline constexpr Choice kFlag{"flag", kFlagNames, 0};

inline constexpr Names kKeySwitchNames = {"off", "standby", "operate", "maintenance",
                                          "not_available"};
inline constexpr Choice kKeySwitch{"key_switch", kKeySwitchNames, 4};

inline constexpr Names kDeadmanNames = {"released", "enabled", "panic", "not_available"};
inline constexpr Choice kDeadman{"deadman", kDeadmanNames, 3};

inline constexpr Names kButtonNames = {"released", "pressed", "error", "not_available"};
inline constexpr Choice kButton{"button", kButtonNames, 3};

inline constexpr Names kControlModeNames = {"none",    "drive",  "flipper", "arm",
                                            "gripper", "camera", "preset",  "not_available"};
inline constexpr Choice kControlMode{"control_mode", kControlModeNames, 7};

inline constexpr Names kSpeedRangeNames = {"creep", "low", "high", "not_available"};
inline constexpr Choice kSpeedRange{"speed_range", kSpeedRangeNames, 3};

inline constexpr Names kFireContactNames = {"fault", "off", "on"};
inline constexpr Choice kFireContact{"fire_contact", kFireContactNames, 0};

inline constexpr Names kHeartbeatNames = {"boot_up", "stopped", "operational", "pre_operational",
                                          "unknown"};
inline constexpr Choice kHeartbeat{"heartbeat", kHeartbeatNames, 4};

inline constexpr Names kCameraNames = {"quad", "drive", "gripper", "mast", "rear", "not_available"};
inline constexpr Choice kCamera{"camera", kCameraNames, 5};

inline constexpr Names kModuleNames = {"none",    "flat",   "slope",        "bomb",
                                       "outdoor", "indoor", "not_available"};
inline constexpr Choice kModule{"module", kModuleNames, 6};

inline constexpr Names kMenuCommandNames = {"none", "start", "pause", "resume", "reset", "end"};
inline constexpr Choice kMenuCommand{"menu_command", kMenuCommandNames, 0};

inline constexpr Names kJointNames = {"none",       "front_flipper", "rear_flipper", "big_arm",
                                      "small_arm",  "wrist",         "gripper_roll", "gripper",
                                      "camera_pan", "camera_tilt"};
inline constexpr Choice kJoint{"joint", kJointNames, 0};

inline constexpr Names kPresetNames = {"none",  "stow",     "travel",   "ground_pick",
                                       "carry", "can_drop", "stair_up", "stair_down"};
inline constexpr Choice kPreset{"preset", kPresetNames, 0};

inline constexpr Names kZoomNames = {"hold", "in", "out"};
inline constexpr Choice kZoom{"zoom", kZoomNames, 0};

inline constexpr Names kFocusNames = {"auto", "near", "far"};
inline constexpr Choice kFocus{"focus", kFocusNames, 0};

inline constexpr Names kLightNames = {"off", "drive", "gripper", "both"};
inline constexpr Choice kLight{"light", kLightNames, 0};

inline constexpr Names kCircuitNames = {"none", "first", "second", "third"};
inline constexpr Choice kCircuit{"circuit", kCircuitNames, 0};

/// Codes that an axis sends in place of a deflection.
inline constexpr Names kAxisNames = {"error", "not_available"};
inline constexpr Choice kAxis{"axis", kAxisNames, 0};

inline constexpr Names kSystemStateNames = {"init",    "standby",   "ready",
                                            "operate", "safe_stop", "estop_latched",
                                            "fault",   "paused",    "replay"};
inline constexpr Choice kSystemState{"system_state", kSystemStateNames, 6};

inline constexpr Names kMissionStateNames = {"idle", "brief", "run", "success", "fail", "abort"};
inline constexpr Choice kMissionState{"mission_state", kMissionStateNames, 0};

inline constexpr Names kInhibitNames = {"none",    "collision",      "joint_limit", "conflict",
                                        "deadman", "link_loss",      "estop",       "payload",
                                        "tilt",    "neutral_needed", "not_ready",   "cable"};
inline constexpr Choice kInhibit{"inhibit_reason", kInhibitNames, 10};

inline constexpr Names kLampNames = {"power", "link",    "estop",   "deadman", "collision",
                                     "limit", "tilt",    "battery", "armed",   "fired",
                                     "grasp", "mission", "fault",   "camera"};
inline constexpr Choice kLamp{"", kLampNames, 0};

/// An unknown pattern must not hide an alarm.
inline constexpr Names kLampPatternNames = {"off", "on", "slow_blink", "fast_blink"};
inline constexpr Choice kLampPattern{"lamp", kLampPatternNames, 3};

inline constexpr Names kBuzzerNames = {"off",        "beep",    "slow",   "fast",
                                       "continuous", "success", "failure"};
inline constexpr Choice kBuzzer{"buzzer", kBuzzerNames, 3};

inline constexpr Names kGraspNames = {"open",         "closing", "contact_left", "contact_right",
                                      "contact_both", "grasped", "slipping",     "released"};
inline constexpr Choice kGrasp{"grasp", kGraspNames, 0};

inline constexpr Names kBombNames = {"none",    "placed",  "touched", "tilted",   "grasped",
                                     "carried", "dropped", "in_can",  "exploded", "disrupted"};
inline constexpr Choice kBomb{"bomb", kBombNames, 0};

inline constexpr Names kFailureNames = {"none",        "exploded",   "time_out", "rollover",
                                        "out_of_area", "link_lost",  "estop",    "instructor",
                                        "bomb_lost",   "wrong_order"};
inline constexpr Choice kFailure{"failure", kFailureNames, 0};

inline constexpr Names kFireStateNames = {"safe",  "armed_wait", "ready",
                                          "fired", "fault",      "time_out"};
inline constexpr Choice kFireState{"fire_state", kFireStateNames, 4};

}  // namespace eod::dbc::choices
