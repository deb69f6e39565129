#include "sim/camera/spot_lights.h"

#include <algorithm>
#include <cmath>

namespace eod::sim {

using Eigen::Isometry3d;
using Eigen::Vector3d;

std::vector<ShiningSpot> ChooseSpots(const RobotModel& robot, const RobotLights& lights,
                                     std::span<const Isometry3d> X_ML, const Isometry3d& X_MC) {
  struct Candidate {
    ShiningSpot spot;
    double merit;
  };
  std::vector<Candidate> candidates;
  const Vector3d ahead = X_MC.linear().col(1);
  for (const SpotLightSpec& spec : robot.lights) {
    if (!spec.IsOn(lights)) continue;
    const Isometry3d X_MS = X_ML[static_cast<size_t>(spec.link)] * spec.X_LS;
    const Vector3d direction = X_MS.linear().col(1);
    // A metre beside the camera counts as much as 60 degrees off its direction.
    const double merit =
        direction.dot(ahead) - 0.5 * (X_MS.translation() - X_MC.translation()).norm();
    candidates.push_back({{.p_M = X_MS.translation().cast<float>(),
                           .direction = direction.cast<float>(),
                           .light = spec.light,
                           .bright_cosine = static_cast<float>(std::cos(spec.inner_angle)),
                           .dark_cosine = static_cast<float>(std::cos(spec.outer_angle))},
                          merit});
  }
  std::stable_sort(candidates.begin(), candidates.end(),
                   [](const Candidate& a, const Candidate& b) { return a.merit > b.merit; });
  candidates.resize(std::min(candidates.size(), kMaxSpots));
  std::vector<ShiningSpot> spots;
  for (const Candidate& candidate : candidates) spots.push_back(candidate.spot);
  return spots;
}

}  // namespace eod::sim
