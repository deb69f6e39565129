#include "sim/stance/gravity_centre.h"

namespace eod::sim {

Eigen::Vector3d CentreOfGravity(const RobotModel& robot, std::span<const Eigen::Isometry3d> X_ML,
                                const Load& load) {
  Eigen::Vector3d moment = load.mass * load.p_M;
  double mass = load.mass;
  for (size_t i = 0; i < robot.links.size(); ++i) {
    const LinkSpec& link = robot.links[i];
    if (link.mass == 0) continue;
    moment += link.mass * (X_ML[i] * link.p_LC);
    mass += link.mass;
  }
  return moment / mass;
}

}  // namespace eod::sim
