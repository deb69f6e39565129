#include "dbc/role_choices.h"

#include <algorithm>
#include <array>

namespace eod::dbc {
namespace {

using Names = std::string_view[];

constexpr Names kAxisNames = {"drive_y", "drive_x", "arm_y", "arm_x"};
constexpr Names kBoxMessageNames = {"safety", "motion",    "axes",     "panel",
                                    "fire",   "heartbeat", "emergency"};
constexpr Names kRobotMessageNames = {"status",  "alarm",     "joint_a",  "joint_b",
                                      "joint_c", "pose",      "battery",  "mission",
                                      "fire",    "heartbeat", "emergency"};
constexpr std::array kAll = {
    &choices::kKeySwitch,   &choices::kDeadman,     &choices::kButton,       &choices::kControlMode,
    &choices::kSpeedRange,  &choices::kFireContact, &choices::kHeartbeat,    &choices::kCamera,
    &choices::kModule,      &choices::kMenuCommand, &choices::kJoint,        &choices::kPreset,
    &choices::kZoom,        &choices::kFocus,       &choices::kLight,        &choices::kCircuit,
    &choices::kAxis,        &choices::kSystemState, &choices::kMissionState, &choices::kInhibit,
    &choices::kLampPattern, &choices::kBuzzer,      &choices::kGrasp,        &choices::kBomb,
    &choices::kFailure,     &choices::kFireState};

struct Unit {
  Dimension dimension;
  std::string_view name;
  double scale;
};

constexpr double kDegreesPerRadian = 57.295779513082320877;
constexpr Unit kUnits[] = {
    {Dimension::kShare, "%", 0.01},
    {Dimension::kShare, "", 1},
    {Dimension::kLength, "mm", 0.001},
    {Dimension::kLength, "cm", 0.01},
    {Dimension::kLength, "m", 1},
    {Dimension::kTime, "ms", 0.001},
    {Dimension::kTime, "s", 1},
    {Dimension::kSpeed, "m/s", 1},
    {Dimension::kSpeed, "mm/s", 0.001},
    {Dimension::kSpeed, "km/h", 1 / 3.6},
    {Dimension::kAngle, "deg", 1},
    {Dimension::kAngle, "\u00B0", 1},
    {Dimension::kAngle, "rad", kDegreesPerRadian},
    {Dimension::kAngle, "mrad", kDegreesPerRadian / 1000},
    {Dimension::kVoltage, "V", 1},
    {Dimension::kVoltage, "mV", 0.001},
    {Dimension::kCurrent, "A", 1},
    {Dimension::kCurrent, "mA", 0.001},
    {Dimension::kTemperature, "degC", 1},
    {Dimension::kTemperature, "\u00B0C", 1},
    {Dimension::kTemperature, "C", 1},
    {Dimension::kScore, "", 1},
    {Dimension::kScore, "%", 1},
};

}  // namespace

std::span<const std::string_view> AxisNames() { return kAxisNames; }
std::span<const std::string_view> BoxMessageNames() { return kBoxMessageNames; }
std::span<const std::string_view> RobotMessageNames() { return kRobotMessageNames; }
std::span<const Choice* const> Choices() { return kAll; }
const Choice& FlagChoice() { return choices::kFlag; }
const Choice& AxisChoice() { return choices::kAxis; }
const Choice& LampChoice() { return choices::kLamp; }
const Choice& LampPatternChoice() { return choices::kLampPattern; }
const Choice& BuzzerChoice() { return choices::kBuzzer; }
const Choice& ControlModeChoice() { return choices::kControlMode; }

int IndexOf(std::span<const std::string_view> names, std::string_view name) {
  const auto found = std::find(names.begin(), names.end(), name);
  return found == names.end() ? -1 : static_cast<int>(found - names.begin());
}

double UnitScale(Dimension dimension, std::string_view unit) {
  for (const Unit& known : kUnits) {
    if (known.dimension == dimension && known.name == unit) return known.scale;
  }
  return 0;
}

std::string AllowedUnits(Dimension dimension) {
  std::string allowed;
  for (const Unit& known : kUnits) {
    if (known.dimension != dimension) continue;
    if (!allowed.empty()) allowed += ", ";
    allowed += '"' + std::string(known.name) + '"';
  }
  return allowed;
}

}  // namespace eod::dbc
