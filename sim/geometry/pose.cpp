#include "sim/geometry/pose.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace eod::sim {

Eigen::Matrix3d ToRotation(const Attitude& attitude) {
  const double sh = std::sin(attitude.heading), ch = std::cos(attitude.heading);
  const double sp = std::sin(attitude.pitch), cp = std::cos(attitude.pitch);
  const double sr = std::sin(attitude.roll), cr = std::cos(attitude.roll);
  Eigen::Matrix3d R_WB;  // Rz(heading) Rx(pitch) Ry(roll), multiplied out
  R_WB << ch * cr - sh * sp * sr, -sh * cp, ch * sr + sh * sp * cr,  //
      sh * cr + ch * sp * sr, ch * cp, sh * sr - ch * sp * cr,       //
      -cp * sr, sp, cp * cr;
  return R_WB;
}

Attitude ToAttitude(const Eigen::Matrix3d& R_WB) {
  return {.heading = WrapHeading(std::atan2(-R_WB(0, 1), R_WB(1, 1))),
          .pitch = std::atan2(R_WB(2, 1), std::hypot(R_WB(2, 0), R_WB(2, 2))),
          .roll = std::atan2(-R_WB(2, 0), R_WB(2, 2))};
}

Attitude AttitudeOnPlane(const Eigen::Vector3d& n_W, double heading) {
  const double sh = std::sin(heading), ch = std::cos(heading);
  const double along_forward = -sh * n_W.x() + ch * n_W.y();
  const double along_right = ch * n_W.x() + sh * n_W.y();
  return {.heading = WrapHeading(heading),
          .pitch = std::atan2(-along_forward, n_W.z()),
          .roll = std::asin(std::clamp(along_right, -1.0, 1.0))};
}

double TiltOf(const Attitude& attitude) {
  return std::acos(std::clamp(std::cos(attitude.pitch) * std::cos(attitude.roll), -1.0, 1.0));
}

double WrapHeading(double angle) {
  constexpr double kTurn = 2 * std::numbers::pi;
  const double wrapped = angle - kTurn * std::floor(angle / kTurn);
  return wrapped < kTurn ? wrapped : 0.0;  // a tiny negative angle rounds up to a whole turn
}

}  // namespace eod::sim
