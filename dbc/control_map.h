#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "dbc/panel_state.h"
#include "dbc/robot_feedback.h"

namespace eod::dbc {

/// One message named by the map.
struct MappedMessage {
  std::string message;
  int line = 0;  ///< in the map file
};

/// One signal named by the map, "MESSAGE.SIGNAL", with what the map adds to the DBC.
struct MappedSignal {
  std::string message;  ///< empty: "none", this box does not have it
  std::string signal;
  bool inverted = false;  ///< switches: 0 means on; axes: full deflection the other way
  /// Role value (such as "operate") to DBC label (such as "Operate"; "" = this box cannot say it).
  /// Empty: the raw number, or a bit.
  std::map<std::string, std::string> labels;
  int line = 0;  ///< in the map file
};

/// How a stick drives motions.
struct AxisMap {
  MappedSignal signal;
  /// Share of full deflection around the centre that counts as neutral, 0..0.5.
  double dead_zone = 0.05;
  /// Motions 1..22 of positive and negative deflection, by control mode; 0 = none.
  struct Pair {
    ControlMode mode = ControlMode::kDrive;
    int positive = 0;
    int negative = 0;
  };
  std::vector<Pair> motions;
};

/// What an alarm does on the box.
struct AlarmMap {
  int code = 0;
  std::string name;
  std::optional<Lamp> lamp;
  LampPattern pattern = LampPattern::kFastBlink;
  BuzzerPattern buzzer = BuzzerPattern::kOff;
  int priority = 0;  ///< the highest active one is on the display and owns the buzzer
};

/// The meaning of a box's signals to the robot: a `*.map.toml` file.
///
/// `controls` (box to robot) and `displays` (robot to box) go by role, such as "key_switch",
/// "motion.m01" or "lamp.collision"; the roles are listed in roles.cpp and in the shipped map.
struct ControlMap {
  std::filesystem::path file;
  std::filesystem::path dbc;  ///< the DBC file it speaks of
  /// Role ("safety", "alarm") to DBC message; without those that the box does not have.
  std::map<std::string, MappedMessage> box_messages;
  std::map<std::string, MappedMessage> robot_messages;
  std::string crc_signal;      ///< name of the E2E CRC signal in each message
  std::string counter_signal;  ///< name of the E2E counter signal
  std::map<std::string, MappedSignal> controls;
  std::map<std::string, MappedSignal> displays;
  std::array<AxisMap, kAxisCount> axes;
  std::vector<AlarmMap> alarms;

  const AlarmMap* FindAlarm(int code) const;
};

/// Throws std::runtime_error with one line "FILE:LINE: key = value: what is allowed" for a missing
/// file, bad TOML, an unknown key (names the nearest known one), a missing role, or a bad value.
ControlMap LoadControlMap(const std::filesystem::path& file);

/// Rate 0..1 wanted for each motion by buttons and sticks together: buttons give `joint_rate`
/// (drive motions: 1), sticks their deflection beyond the dead zone, rescaled to 0..1; the larger
/// one counts. `speed_limit` scales the result. Opposite buttons are both kept: the caller resolves
/// them.
std::array<double, kMotionCount> WantedRates(const ControlMap& map, const PanelState& panel);

}  // namespace eod::dbc
