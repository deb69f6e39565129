#include "sim/scenario/fault_spec.h"

#include <array>
#include <span>
#include <string_view>

#include "sim/rules/toml_table.h"

namespace eod::sim {
namespace {

using Name = std::string_view;

constexpr std::array<Name, 7> kFaultKeys = {"kind",       "target",   "amount",    "at_s",
                                            "after_step", "on_grasp", "duration_s"};
constexpr std::array<Name, 4> kCameras = {"drive", "gripper", "mast", "rear"};
constexpr std::array<Name, 9> kJoints = {"J1", "J2", "J3", "J4", "J5", "J6", "J7", "J8", "J9"};
constexpr std::array<Name, 2> kTracks = {"left", "right"};
constexpr std::array<Name, 22> kMotions = {"M01", "M02", "M03", "M04", "M05", "M06", "M07", "M08",
                                           "M09", "M10", "M11", "M12", "M13", "M14", "M15", "M16",
                                           "M17", "M18", "M19", "M20", "M21", "M22"};
constexpr std::array<Name, 14> kLamps = {"power", "link",    "estop",   "deadman", "collision",
                                         "limit", "tilt",    "battery", "armed",   "fired",
                                         "grasp", "mission", "fault",   "camera"};

/// What a kind of fault wants to be told.
struct Kind {
  Name name;
  std::span<const Name> targets = {};  ///< none: it needs no target
  double lowest = 0;                   ///< of its amount ...
  double highest = 0;                  ///< ... if it has one
};
constexpr std::array<Kind, 16> kKinds = {{
    // as the enum
    {.name = "camera_dead", .targets = kCameras},
    {.name = "camera_frozen", .targets = kCameras},
    {.name = "camera_noisy", .targets = kCameras},
    {.name = "camera_wrong_light", .targets = kCameras},
    {.name = "joint_stuck", .targets = kJoints},
    {.name = "joint_slow", .targets = kJoints, .highest = 1},
    {.name = "joint_drift", .targets = kJoints, .lowest = -30, .highest = 30},
    {.name = "track_weak", .targets = kTracks, .highest = 1},
    {.name = "gripper_slip"},
    {.name = "battery_sag", .highest = 25},
    {.name = "radio_loss"},
    {.name = "cable_snag"},
    {.name = "field_estop"},
    {.name = "stuck_button", .targets = kMotions},
    {.name = "sensor_offset", .targets = kJoints, .lowest = -180, .highest = 180},
    {.name = "lamp_broken", .targets = kLamps},
}};

void RejectKey(const TomlTable& table, Name key, Name kind) {
  if (!table.Has(key)) return;
  table.Fail(table.LineOf(key),
             std::string("a fault '").append(kind).append("' has no ").append(key));
}

}  // namespace

std::string_view NameOf(FaultSpec::Kind kind) { return kKinds[static_cast<size_t>(kind)].name; }

FaultSpec ReadFaultSpec(const TomlTable& table) {
  table.RejectUnknownKeys(kFaultKeys);
  std::array<Name, kKinds.size()> names;
  for (size_t i = 0; i < kKinds.size(); ++i) names[i] = kKinds[i].name;
  FaultSpec fault;
  const Kind& kind = kKinds[table.Choice("kind", names)];
  fault.kind = static_cast<FaultSpec::Kind>(&kind - kKinds.data());
  if (kind.targets.empty()) {
    RejectKey(table, "target", kind.name);
  } else {
    fault.target = kind.targets[table.Choice("target", kind.targets)];
  }
  if (kind.lowest == kind.highest) {
    RejectKey(table, "amount", kind.name);
  } else {
    fault.amount = table.Number("amount", kind.lowest, kind.highest);
  }
  if (table.Has("at_s")) fault.at = table.Number("at_s", 0, 86400);
  fault.after_step = static_cast<int>(table.Integer("after_step", 1, 100, 0));
  fault.on_grasp = table.Flag("on_grasp", false);
  fault.duration = table.Number("duration_s", 0, 86400, 0.0);
  fault.line = table.LineOf("target");
  const int triggers =
      (fault.at ? 1 : 0) + (fault.after_step > 0 ? 1 : 0) + (fault.on_grasp ? 1 : 0);
  if (triggers != 1) {
    table.Fail(table.line(), "a fault begins by one of at_s, after_step, on_grasp = true");
  }
  return fault;
}

}  // namespace eod::sim
