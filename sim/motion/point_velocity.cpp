#include "sim/motion/motion.h"

namespace eod::sim {

Eigen::Vector3d PointVelocity(const RobotModel& robot, const RobotState& state,
                              std::span<const Eigen::Isometry3d> X_ML, int link,
                              const Eigen::Vector3d& p_M, int motion, double speed) {
  const Eigen::Vector3d up = Eigen::Vector3d::UnitZ();
  switch (motion) {
    case kDriveForward:
      return ToRotation(state.attitude).col(1) * speed;
    case kDriveReverse:
      return ToRotation(state.attitude).col(1) * -speed;
    // Eq. 3 changes the heading, which is an angle about the vertical through the origin.
    case kTurnLeft:
      return up.cross(p_M - state.position) * speed;
    case kTurnRight:
      return up.cross(p_M - state.position) * -speed;
    default:
      break;
  }

  // Every link of the joint between the point and the chassis adds its share.
  const JointMotion moved = JointOf(robot, motion);
  Eigen::Vector3d v_M = Eigen::Vector3d::Zero();
  if (moved.joint < 0) return v_M;
  for (int l = link; l >= 0; l = robot.links[l].parent) {
    const LinkSpec& spec = robot.links[l];
    if (spec.joint != moved.joint) continue;
    const Eigen::Vector3d axis = X_ML[l].linear() * spec.axis;
    const double rate = moved.sign * spec.scale * speed;
    if (spec.kind == LinkSpec::Kind::kRevolute) {
      v_M += axis.cross(p_M - X_ML[l].translation()) * rate;
    } else if (spec.kind == LinkSpec::Kind::kPrismatic) {
      v_M += axis * rate;
    }
  }
  return v_M;
}

}  // namespace eod::sim
