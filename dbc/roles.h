#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "dbc/panel_state.h"
#include "dbc/robot_feedback.h"

namespace eod::dbc {

/// How a role's value stands in a signal.
enum class RoleKind : uint8_t {
  kFlag,      ///< a bit, or the labels "off" and "on"
  kChoice,    ///< one of named values, found by their DBC labels
  kCount,     ///< a whole number or a set of bits, as it is
  kQuantity,  ///< a physical quantity, converted by the DBC's unit
  kAxis,      ///< a share of full deflection, with labels for "not valid"
};

/// What a quantity is, and so which units the DBC may give it in.
enum class Dimension : uint8_t {
  kNone,
  kShare,        ///< [1] of 1 or %
  kLength,       ///< [m]
  kTime,         ///< [s]
  kSpeed,        ///< [m/s]
  kAngle,        ///< [deg]
  kVoltage,      ///< [V]
  kCurrent,      ///< [A]
  kTemperature,  ///< [degree Celsius]
  kScore,        ///< points 0..100
};

/// The named values of a role; a value's number is its place in `values`.
struct Choice {
  std::string_view name;  ///< of its table of labels in the map
  std::span<const std::string_view> values;
  int fallback;  ///< the safe value: what an unknown raw value decodes to
};

/// Something that a box or a robot says: its name in the map and how it stands in a signal.
struct RoleSpec {
  std::string_view section;  ///< table of the map
  std::string key;           ///< in that table
  std::string name;          ///< in ControlMap: key, with the section's prefix
  RoleKind kind = RoleKind::kCount;
  const Choice* choice = nullptr;
  Dimension dimension = Dimension::kNone;
  double safe = 0;         ///< value if the signal says nothing valid
  bool essential = false;  ///< may not be "none" in the map
};

/// A role with its field of State. Values go through double, which holds every field exactly; NaN
/// is an invalid axis.
template <typename State>
struct Role : RoleSpec {
  int index = 0;  ///< into an array or a set of bits
  double (*get)(const State&, int index) = nullptr;
  void (*set)(State&, int index, double value) = nullptr;
};

/// All that a box says, axes last, in the order of AxisNames().
const std::vector<Role<PanelState>>& PanelRoles();
/// All that a robot shows.
const std::vector<Role<RobotFeedback>>& FeedbackRoles();

/// Keys of [axes] in the map, in the order of PanelState::axis.
std::span<const std::string_view> AxisNames();
std::span<const std::string_view> BoxMessageNames();    ///< in the order of BoxMessage
std::span<const std::string_view> RobotMessageNames();  ///< in the order of RobotMessage

/// Every table of labels that a map may have.
std::span<const Choice* const> Choices();
const Choice& FlagChoice();
const Choice& AxisChoice();
const Choice& LampChoice();
const Choice& LampPatternChoice();
const Choice& BuzzerChoice();
const Choice& ControlModeChoice();

/// Place of `name` in `names`, -1 if it is not there.
int IndexOf(std::span<const std::string_view> names, std::string_view name);

/// SI value (degrees for angles) of one `unit`; 0 if the dimension is not measured in that unit.
double UnitScale(Dimension dimension, std::string_view unit);
/// The units that UnitScale takes, for an error text.
std::string AllowedUnits(Dimension dimension);

}  // namespace eod::dbc
