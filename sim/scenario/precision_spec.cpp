#include "sim/scenario/precision_spec.h"

#include <array>
#include <numbers>
#include <string_view>

#include <fmt/format.h>

#include "sim/rules/toml_table.h"

namespace eod::sim {
namespace {

constexpr double kRadiansPerDegree = std::numbers::pi / 180;
constexpr double kMaxLength = 3000;  // [m] the whole world

/// What a measure of a kind has to say.
enum Need : unsigned {
  kOneObject = 1,
  kLine = 2,
  kHeading = 4,
  kObjectOrPoint = 8,
};
struct KindName {
  std::string_view name;
  std::string_view unit;
  unsigned needs;
};
constexpr std::array kKinds = {  // as the enum
    KindName{"stop_error", "m", 0},
    KindName{"path_error", "m", kLine},
    KindName{"heading_error", "deg", kHeading},
    KindName{"tilt_peak", "deg", 0},
    KindName{"centring_error", "m", 0},
    KindName{"release_offset", "m", kOneObject},
    KindName{"rim_clearance", "m", kOneObject},
    KindName{"placement_error", "m", kObjectOrPoint},
    KindName{"contacts", "", 0},
    KindName{"wall_clearance", "m", kLine},
    KindName{"turn_count", "", 0},
    KindName{"moved", "m", 0}};

const KindName& Entry(PrecisionSpec::Kind kind) { return kKinds[static_cast<size_t>(kind)]; }

std::vector<std::string_view> KeysOf(const std::string& best, const std::string& worst) {
  return {"kind",     "text",  "weight",      "step", "objects",
          "points_m", "box_m", "heading_deg", best,   worst};
}

void CheckNeeds(const TomlTable& table, const PrecisionSpec& spec) {
  const unsigned needs = Entry(spec.kind).needs;
  const auto want = [&](bool there, std::string_view what) {
    if (!there) {
      table.Fail(table.line(), fmt::format("precision '{}' needs {}", NameOf(spec.kind), what));
    }
  };
  if ((needs & kOneObject) != 0) want(spec.objects.size() == 1, "objects = ['one vessel']");
  if ((needs & kLine) != 0) want(spec.points.size() >= 2, "points_m = [[x, y], [x, y], ...]");
  if ((needs & kHeading) != 0) want(table.Has("heading_deg"), "heading_deg");
  if ((needs & kObjectOrPoint) != 0) {
    want(spec.objects.size() + spec.points.size() == 1, "one of objects and points_m, with one");
  }
  if (spec.best == spec.worst) {
    table.Fail(table.line(), fmt::format("precision '{}': best and worst are both {}",
                                         NameOf(spec.kind), spec.best));
  }
}

}  // namespace

std::string_view NameOf(PrecisionSpec::Kind kind) { return Entry(kind).name; }
std::string_view UnitOf(PrecisionSpec::Kind kind) { return Entry(kind).unit; }

PrecisionSpec ReadPrecisionSpec(const TomlTable& table) {
  std::array<std::string_view, kKinds.size()> names;
  for (size_t i = 0; i < kKinds.size(); ++i) names[i] = kKinds[i].name;
  PrecisionSpec spec;
  spec.kind = static_cast<PrecisionSpec::Kind>(table.Choice("kind", names));
  const std::string_view unit = UnitOf(spec.kind);
  const std::string suffix = unit.empty() ? "" : fmt::format("_{}", unit);
  const std::string best = "best" + suffix, worst = "worst" + suffix;
  table.RejectUnknownKeys(KeysOf(best, worst));
  const double to_si = unit == "deg" ? kRadiansPerDegree : 1;
  spec.text = table.Text("text", "");
  spec.weight = table.Number("weight", 0, 100, 1.0);
  spec.best = table.Number(best, 0, 1000) * to_si;
  spec.worst = table.Number(worst, 0, 1000) * to_si;
  spec.step = static_cast<int>(table.Integer("step", 1, 100, 0));
  spec.objects = table.Texts("objects");
  for (const auto& [x, y] : table.Points("points_m", -kMaxLength, kMaxLength)) {
    spec.points.emplace_back(x, y);
  }
  const std::vector<double> box = table.Numbers("box_m", 4, -kMaxLength, kMaxLength);
  if (!box.empty()) {
    if (box[0] >= box[2] || box[1] >= box[3]) {
      table.Fail(table.LineOf("box_m"), "box_m has to be [x0, y0, x1, y1] with x0 < x1, y0 < y1");
    }
    spec.box = Eigen::Vector4d(box.data());
  }
  spec.heading = table.Number("heading_deg", -360, 360, 0.0) * kRadiansPerDegree;
  CheckNeeds(table, spec);
  return spec;
}

}  // namespace eod::sim
