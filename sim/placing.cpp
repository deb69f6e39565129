#include "sim/placing.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "sim/rules/toml_table.h"
#include "sim/task/task.h"

namespace eod::sim {
namespace {

[[noreturn]] void Fail(const Scenario& scenario, const Placement& place, const std::string& what) {
  // A start that is no table of the file has no line: the first one then.
  throw std::runtime_error(
      fmt::format("{}:{}: {}", scenario.file.string(), std::max(1U, place.line), what));
}

void CheckArea(const Scenario& scenario, const ModuleModel& module, const Placement& place) {
  if (!place.position) return;
  const Eigen::Vector2d reach = place.position->head<2>().cwiseAbs() + place.spread.head<2>();
  if ((reach.array() <= module.half_size.array()).all()) return;
  Fail(scenario, place,
       fmt::format("position_m = [{}, {}, {}] and its spread reach beyond module {} ({}), allowed "
                   "x within {}, y within {}",
                   place.position->x(), place.position->y(), place.position->z(), module.id,
                   module.name, module.half_size.x(), module.half_size.y()));
}

void CheckObject(const Scenario& scenario, const ModuleModel& module, const Placement& place) {
  std::vector<std::string_view> names;
  for (const MovableObject& movable : module.movables) names.push_back(movable.name);
  if (std::find(names.begin(), names.end(), place.object) != names.end()) return;
  const std::string what = fmt::format("object '{}' is no movable of module {} ({})", place.object,
                                       module.id, module.name);
  if (names.empty()) Fail(scenario, place, what);
  Fail(scenario, place,
       fmt::format("{}; did you mean '{}'?", what, NearestName(place.object, names)));
}

}  // namespace

StartPose StartOf(const Scenario& scenario, const ModuleModel& module) {
  const Placement& start = scenario.start;
  StartPose pose;
  pose.is_given = start.position || start.heading || !start.shift.isZero(0);
  pose.attitude = module.start_attitude;
  if (!pose.is_given) return pose;
  if (start.position) pose.p_M = *start.position;
  pose.p_M.head<2>() += start.shift.head<2>();
  const double heading = start.heading.value_or(module.start_attitude.heading);
  pose.attitude.heading = WrapHeading(heading + start.shift.z());
  return pose;
}

Eigen::Isometry3d StartOf(const MovableObject& movable, const Placement& place) {
  Eigen::Isometry3d X_MO = movable.X_MO;
  if (place.position) X_MO.translation() = *place.position;
  X_MO.translation().head<2>() += place.shift.head<2>();
  double turn = place.shift.z();
  if (place.heading) {
    const Eigen::Vector3d forward = X_MO.linear().col(1);
    turn += *place.heading - std::atan2(-forward.x(), forward.y());
  }
  if (turn != 0) {
    X_MO.linear() = ToRotation({.heading = turn}) * X_MO.linear();
  }
  return X_MO;
}

void CheckFits(const Scenario& scenario, const WorldModel& world) {
  const auto found =
      std::find_if(world.modules.begin(), world.modules.end(),
                   [&](const ModuleModel& one) { return one.id == scenario.module; });
  if (found == world.modules.end()) {
    throw std::runtime_error(fmt::format("{}: module {} is not in {}", scenario.file.string(),
                                         scenario.module, world.file.string()));
  }
  const ModuleModel& module = *found;
  const Task has_its_objects(scenario, module, {});
  CheckArea(scenario, module, scenario.start);
  if (!scenario.area.empty() && !IsWithin(scenario.area, StartOf(scenario, module).p_M.head<2>())) {
    Fail(scenario, scenario.start, "the start lies outside of [area]");
  }
  const std::vector<Placement>& places = scenario.places;
  for (size_t i = 0; i < places.size(); ++i) {
    CheckObject(scenario, module, places[i]);
    CheckArea(scenario, module, places[i]);
    const auto is_same = [&](const Placement& one) { return one.object == places[i].object; };
    if (std::any_of(places.begin(), places.begin() + static_cast<std::ptrdiff_t>(i), is_same)) {
      Fail(scenario, places[i], fmt::format("object '{}' is placed twice", places[i].object));
    }
  }
}

}  // namespace eod::sim
