#include "sim/scenario/task_step.h"

#include <array>
#include <numbers>
#include <string_view>

#include <fmt/format.h>

#include "sim/geometry/pose.h"
#include "sim/rules/toml_table.h"

namespace eod::sim {
namespace {

constexpr std::array<std::string_view, 13> kStepKeys = {
    "kind",     "object", "distance_m", "tolerance_m", "x_m",    "y_m",   "time_s",
    "tilt_deg", "text",   "weight",     "point_m",     "camera", "strict"};
constexpr std::array<std::string_view, 5> kCameras = {"any", "drive", "gripper", "mast", "rear"};

/// What a step of a kind has to say.
enum Need : unsigned {
  kObject = 1,
  kDistance = 2,
  kTolerance = 4,
  kPlace = 8,
  kTime = 16,
  kLasting = 32,  ///< it takes time, and so has no moment at which it is out of turn
};
struct KindName {
  std::string_view name;
  TaskStep::Kind kind;
  unsigned needs;
};
constexpr std::array kKinds = {
    KindName{"contact", TaskStep::Kind::kContact, 0},
    KindName{"clear", TaskStep::Kind::kClear, kDistance | kLasting},
    KindName{"pass_gate", TaskStep::Kind::kPassGate, kObject | kDistance},
    KindName{"stop_at", TaskStep::Kind::kStopAt, kObject | kDistance | kTolerance | kLasting},
    KindName{"reach", TaskStep::Kind::kReach, kTolerance | kPlace},
    KindName{"grasp", TaskStep::Kind::kGrasp, kObject},
    KindName{"lift", TaskStep::Kind::kLift, kDistance},
    KindName{"place_in_vessel", TaskStep::Kind::kPlaceInVessel, kObject},
    KindName{"disrupt", TaskStep::Kind::kDisrupt, 0},
    KindName{"climb", TaskStep::Kind::kClimb, kDistance | kTolerance | kPlace},
    KindName{"hold_still", TaskStep::Kind::kHoldStill, kTime | kLasting},
    KindName{"retreat", TaskStep::Kind::kRetreat, kObject | kDistance},
    KindName{"inspect", TaskStep::Kind::kInspect, kObject | kDistance | kTime | kLasting}};

constexpr double kMaxLength = 3000;  // [m] the whole world
constexpr double kMaxTime = 86400;   // [s]

const KindName& ReadKind(const TomlTable& table) {
  std::array<std::string_view, kKinds.size()> names;
  for (size_t i = 0; i < kKinds.size(); ++i) names[i] = kKinds[i].name;
  return kKinds[table.Choice("kind", names)];
}

void ReadInspection(const TomlTable& table, TaskStep& step) {
  if (step.kind != TaskStep::Kind::kInspect) {
    for (const std::string_view key : {"point_m", "camera"}) {
      if (table.Has(key)) {
        table.Fail(table.LineOf(key), fmt::format("'{}' belongs to a step 'inspect'", key));
      }
    }
    return;
  }
  const std::vector<double> point = table.Numbers("point_m", 3, -kMaxLength, kMaxLength);
  if (!point.empty()) step.point = Eigen::Vector3d(point.data());
  step.camera = static_cast<int>(table.Choice("camera", kCameras, 0));
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
  step.line = table.LineOf("object");
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
  ReadInspection(table, step);
  step.strict = table.Flag("strict", false);
  if (step.strict && needs(kLasting)) {
    table.Fail(table.LineOf("strict"),
               fmt::format("a step '{}' takes its time and cannot be strict", kind.name));
  }
  return step;
}

}  // namespace eod::sim
