#include "sim/faults/fault_targets.h"

#include <algorithm>
#include <stdexcept>

#include <fmt/format.h>

#include "sim/faults/active_faults.h"
#include "sim/rules/toml_table.h"

namespace eod::sim {
namespace {

using Kind = FaultSpec::Kind;
using Names = std::vector<std::string>;

/// In the order of the box's lamps, see panel_status_t.
const Names kLamps = {"power",   "link",  "estop", "deadman", "collision", "limit", "tilt",
                      "battery", "armed", "fired", "grasp",   "mission",   "fault", "camera"};

[[noreturn]] void Fail(const FaultSpec& spec, const Scenario& scenario, const std::string& what) {
  throw std::runtime_error(fmt::format("{}:{}: fault {}: {}", scenario.file.string(), spec.line,
                                       NameOf(spec.kind), what));
}

Names Numbered(const char* format, int count) {
  Names names;
  for (int i = 1; i <= count; ++i) names.push_back(fmt::format(fmt::runtime(format), i));
  return names;
}

/// The names that a target of this kind may have; none: it has no target.
Names TargetsOf(Kind kind, const RobotModel& robot) {
  switch (kind) {
    case Kind::kCameraDead:
    case Kind::kCameraFrozen:
    case Kind::kCameraNoisy:
    case Kind::kCameraWrongLight: {
      Names names;
      for (const CameraSpec& camera : robot.cameras) names.push_back(camera.name);
      names.resize(std::min<size_t>(names.size(), ActiveFaults::kMostCameras));
      return names;
    }
    case Kind::kJointStuck:
    case Kind::kJointSlow:
    case Kind::kJointDrift:
    case Kind::kSensorOffset:
      return Numbered("J{}", kJointCount);
    case Kind::kTrackWeak:
      return {"left", "right"};
    case Kind::kStuckButton:
      return Numbered("M{:02}", kMotionCount);
    case Kind::kLampBroken:
      return kLamps;
    default:
      return {};
  }
}

void CheckAmount(const FaultSpec& spec, const Scenario& scenario) {
  const bool is_share = spec.kind == Kind::kJointSlow || spec.kind == Kind::kTrackWeak;
  if (is_share && (spec.amount < 0 || spec.amount > 1)) {
    Fail(spec, scenario, fmt::format("amount = {}, allowed 0 .. 1", spec.amount));
  }
  const bool needs_amount = spec.kind == Kind::kJointDrift || spec.kind == Kind::kSensorOffset ||
                            spec.kind == Kind::kBatterySag;
  if (needs_amount && spec.amount == 0) Fail(spec, scenario, "amount is missing or 0");
}

}  // namespace

int FindFaultTarget(const FaultSpec& spec, const Scenario& scenario, const RobotModel& robot) {
  CheckAmount(spec, scenario);
  if (spec.after_step > static_cast<int>(scenario.steps.size())) {
    Fail(spec, scenario,
         fmt::format("after_step = {}, the exercise has {}", spec.after_step,
                     scenario.steps.size()));
  }
  if (spec.kind == Kind::kCableSnag && scenario.link.kind != ControlLinkSpec::Kind::kCable) {
    Fail(spec, scenario, "there is no cable: [link] kind = 'cable' is missing");
  }
  const Names names = TargetsOf(spec.kind, robot);
  if (names.empty()) {
    if (!spec.target.empty()) {
      Fail(spec, scenario, fmt::format("target = '{}', allowed none", spec.target));
    }
    return -1;
  }
  const auto found = std::find(names.begin(), names.end(), spec.target);
  if (found == names.end()) {
    const std::vector<std::string_view> known(names.begin(), names.end());
    Fail(spec, scenario,
         fmt::format("target = '{}' is unknown; did you mean '{}'?", spec.target,
                     NearestName(spec.target, known)));
  }
  return static_cast<int>(found - names.begin());
}

}  // namespace eod::sim
