#include "tests/bench/paper_claims/dynamic_loading.h"

#include "sim/world/analytic_world.h"

namespace eod::claims {
namespace {

using sim::kMotionCount;
using sim::MotionSet;

/// Segments that are cast while `commanded`.
int CountCast(sim::IsectorSet& isectors, const std::vector<Eigen::Isometry3d>& X_ML,
              MotionSet commanded) {
  static const sim::AnalyticWorld kEmpty;
  isectors.Cast(kEmpty, X_ML, commanded);
  return static_cast<int>(isectors.segments().size());
}

}  // namespace

LoadingCount CountLoaded(const sim::RobotModel& robot, sim::Coverage coverage) {
  std::vector<Eigen::Isometry3d> X_ML;
  sim::LinkPoses(robot, sim::HomeState(robot), X_ML);
  sim::IsectorSet loaded(robot, sim::kModuleFlat, coverage);
  sim::IsectorSet all(robot, sim::kModuleFlat, coverage, {.dynamic_loading = false});
  LoadingCount count{
      .coverage = coverage, .all = CountCast(all, X_ML, 0), .all_always = 0, .motions = {}};
  const int always = CountCast(loaded, X_ML, 0);
  count.all_always = always;
  for (int motion = 0; motion < kMotionCount; ++motion) {
    const int cast = CountCast(loaded, X_ML, sim::SetOf(motion));
    count.motions[static_cast<size_t>(motion)] = {.always = always, .loaded = cast - always};
  }
  return count;
}

WholeCount CountWholeIsectors(const sim::RobotModel& robot) {
  WholeCount count;
  for (const sim::IsectorSpec& isector : robot.isectors) {
    const bool is_tripod = isector.method == sim::IsectorMethod::kTripod;
    const bool is_of_set = is_tripod || isector.method == sim::IsectorMethod::kBump;
    if (isector.extended || !is_of_set) continue;
    const auto lines = static_cast<int>(isector.segments.size());
    count.all += lines;
    for (int motion = 0; motion < kMotionCount; ++motion) {
      const bool is_loaded =
          is_tripod ? motion <= sim::kRearFlipperDown : sim::Contains(isector.motions, motion);
      if (is_loaded) count.motions[static_cast<size_t>(motion)] += lines;
    }
  }
  return count;
}

}  // namespace eod::claims
