#include "sim/scenario/fault_spec.h"

#include <array>
#include <string_view>

#include "sim/rules/toml_table.h"

namespace eod::sim {
namespace {

constexpr std::array<std::string_view, 7> kFaultKeys = {
    "kind", "target", "amount", "at_s", "after_step", "on_grasp", "duration_s"};
constexpr std::array<std::string_view, 16> kKinds = {  // as the enum
    "camera_dead",  "camera_frozen", "camera_noisy",  "camera_wrong_light",
    "joint_stuck",  "joint_slow",    "joint_drift",   "track_weak",
    "gripper_slip", "battery_sag",   "radio_loss",    "cable_snag",
    "field_estop",  "stuck_button",  "sensor_offset", "lamp_broken"};

}  // namespace

FaultSpec ReadFaultSpec(const TomlTable& table) {
  table.RejectUnknownKeys(kFaultKeys);
  FaultSpec fault;
  fault.kind = static_cast<FaultSpec::Kind>(table.Choice("kind", kKinds));
  fault.target = table.Text("target", "");
  fault.amount = table.Number("amount", -1000, 1000, 0.0);
  if (table.Has("at_s")) fault.at = table.Number("at_s", 0, 86400);
  fault.after_step = static_cast<int>(table.Integer("after_step", 1, 100, 0));
  fault.on_grasp = table.Flag("on_grasp", false);
  fault.duration = table.Number("duration_s", 0, 86400, 0.0);
  const int triggers =
      (fault.at ? 1 : 0) + (fault.after_step > 0 ? 1 : 0) + (fault.on_grasp ? 1 : 0);
  if (triggers != 1) {
    table.Fail(table.line(), "a fault begins by one of at_s, after_step, on_grasp = true");
  }
  return fault;
}

}  // namespace eod::sim
