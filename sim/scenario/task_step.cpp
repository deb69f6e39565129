#include "sim/scenario/task_step.h"

#include <array>
#include <numbers>
#include <string_view>

#include "sim/geometry/pose.h"
#include "sim/rules/toml_table.h"

namespace eod::sim {
namespace {

constexpr std::array<std::string_view, 10> kStepKeys = {
    "kind", "object", "distance_m", "tolerance_m", "x_m",
    "y_m",  "time_s", "tilt_deg",   "text",        "weight"};

/// What a step of a kind has to say.
enum Need : unsigned {
  kObject = 1,
  kDistance = 2,
  kTolerance = 4,
  kPlace = 8,
  kTime = 16,
};
struct KindName {
  std::string_view name;
  TaskStep::Kind kind;
  unsigned needs;
};
constexpr std::array kKinds = {
    KindName{"contact", TaskStep::Kind::kContact, 0},
    KindName{"clear", TaskStep::Kind::kClear, kDistance},
    KindName{"pass_gate", TaskStep::Kind::kPassGate, kObject | kDistance},
    KindName{"stop_at", TaskStep::Kind::kStopAt, kObject | kDistance | kTolerance},
    KindName{"reach", TaskStep::Kind::kReach, kTolerance | kPlace},
    KindName{"grasp", TaskStep::Kind::kGrasp, kObject},
    KindName{"lift", TaskStep::Kind::kLift, kDistance},
    KindName{"place_in_vessel", TaskStep::Kind::kPlaceInVessel, kObject},
    KindName{"disrupt", TaskStep::Kind::kDisrupt, 0},
    KindName{"climb", TaskStep::Kind::kClimb, kDistance | kTolerance | kPlace},
    KindName{"hold_still", TaskStep::Kind::kHoldStill, kTime},
    KindName{"retreat", TaskStep::Kind::kRetreat, kObject | kDistance}};

constexpr double kMaxLength = 3000;  // [m] the whole world
constexpr double kMaxTime = 86400;   // [s]

const KindName& ReadKind(const TomlTable& table) {
  std::array<std::string_view, kKinds.size()> names;
  for (size_t i = 0; i < kKinds.size(); ++i) names[i] = kKinds[i].name;
  return kKinds[table.Choice("kind", names)];
}

}  // namespace

TaskStep ReadTaskStep(const TomlTable& table) {
  table.RejectUnknownKeys(kStepKeys);
  TaskStep step;
  const KindName& kind = ReadKind(table);
  const auto needs = [&kind](Need need) { return (kind.needs & need) != 0; };
  step.kind = kind.kind;
  step.text = table.Text("text");
  step.weight = table.Number("weight", 0, 100, 1.0);
  step.object = needs(kObject) ? table.Text("object") : table.Text("object", "");
  if (needs(kDistance)) step.distance = table.Number("distance_m", 0, kMaxLength);
  if (needs(kTolerance)) step.tolerance = table.Number("tolerance_m", 0, kMaxLength);
  if (needs(kPlace)) {
    step.x = table.Number("x_m", -kMaxLength, kMaxLength);
    step.y = table.Number("y_m", -kMaxLength, kMaxLength);
  }
  if (needs(kTime)) {
    step.time = table.Number("time_s", 0, kMaxTime);
    step.tilt = table.Number("tilt_deg", 0, 90, 0.0) * std::numbers::pi / 180;
  }
  return step;
}

}  // namespace eod::sim
