#pragma once

#include <array>
#include <string_view>

#include "dbc/panel_state.h"
#include "dbc/robot_feedback.h"

/// The words of scripts, panel commands and displays, each list in the order of its enumeration.
namespace eod::box::words {

using Word = std::string_view;

inline constexpr std::array<Word, 2> kOffOn{"off", "on"};
inline constexpr std::array<Word, 2> kReleasePress{"release", "press"};
inline constexpr std::array<Word, 4> kKey{"off", "standby", "operate", "maintenance"};
inline constexpr std::array<Word, 3> kDeadman{"released", "enabled", "panic"};
inline constexpr std::array<Word, 7> kMode{"none",    "drive",  "flipper", "arm",
                                           "gripper", "camera", "preset"};
inline constexpr std::array<Word, 3> kSpeed{"creep", "low", "high"};
inline constexpr std::array<Word, dbc::kAxisCount> kStick{"drive_y", "drive_x", "arm_y", "arm_x"};
inline constexpr std::array<Word, 8> kPreset{"none",  "stow",     "travel",   "ground_pick",
                                             "carry", "can_drop", "stair_up", "stair_down"};
inline constexpr std::array<Word, 5> kCamera{"quad", "drive", "gripper", "mast", "rear"};
inline constexpr std::array<Word, 3> kZoom{"hold", "in", "out"};
inline constexpr std::array<Word, 3> kFocus{"auto", "near", "far"};
inline constexpr std::array<Word, 4> kLight{"off", "drive", "gripper", "both"};
inline constexpr std::array<Word, 6> kModule{"none", "flat", "slope", "bomb", "outdoor", "indoor"};
inline constexpr std::array<Word, 6> kMenu{"", "start", "pause", "resume", "reset", "end"};
inline constexpr std::array<Word, 3> kArmKey{"fault", "safe", "armed"};
inline constexpr std::array<Word, 3> kFireButton{"fault", "released", "pressed"};

inline constexpr std::array<Word, dbc::kLampCount> kLamp{
    "power",   "link",  "estop", "deadman", "collision", "limit", "tilt",
    "battery", "armed", "fired", "grasp",   "mission",   "fault", "camera"};
inline constexpr std::array<Word, 4> kLampPattern{"off", "on", "slow", "fast"};
inline constexpr std::array<Word, 7> kBuzzer{"off",        "beep",    "slow",   "fast",
                                             "continuous", "success", "failure"};
inline constexpr std::array<Word, 9> kBoxState{"boot",  "self_test", "standby", "ready", "operate",
                                               "estop", "link_lost", "fault",   "off"};
inline constexpr std::array<Word, 9> kRobotState{
    "init", "standby", "ready", "operate", "safe_stop", "estop", "fault", "paused", "replay"};
inline constexpr std::array<Word, 6> kMission{"idle", "brief", "run", "success", "fail", "abort"};
inline constexpr std::array<Word, 12> kInhibitReason{
    "none",  "collision", "joint_limit", "conflict",       "deadman",   "link_loss",
    "estop", "payload",   "tilt",        "neutral_needed", "not_ready", "cable"};
inline constexpr std::array<Word, 8> kGrasp{"open",          "closing",      "contact_left",
                                            "contact_right", "contact_both", "grasped",
                                            "slipping",      "released"};
inline constexpr std::array<Word, 10> kBomb{"none",     "placed",   "touched", "tilted",
                                            "grasped",  "carried",  "dropped", "in_can",
                                            "exploded", "disrupted"};
inline constexpr std::array<Word, 6> kFireState{"safe",  "armed_wait", "ready",
                                                "fired", "fault",      "time_out"};
inline constexpr std::array<Word, 10> kFailure{
    "none",      "exploded", "time_out",   "rollover",  "out_of_area",
    "link_lost", "estop",    "instructor", "bomb_lost", "wrong_order"};
inline constexpr std::array<Word, 12> kPart{"front left wheel",
                                            "front right wheel",
                                            "rear left wheel",
                                            "rear right wheel",
                                            "left hand",
                                            "right hand",
                                            "crossbeam",
                                            "chassis",
                                            "big arm",
                                            "small arm",
                                            "mast",
                                            "charge"};

}  // namespace eod::box::words
