#include "tests/bench/isector_bench/path.h"

#include <cmath>
#include <numbers>

#include "sim/geometry/pose.h"
#include "tests/bench/isector_bench/site.h"

namespace eod::bench {

namespace {

using Eigen::Isometry3d;
using Eigen::Vector2d;
using Eigen::Vector3d;
using std::numbers::pi;

constexpr double kTrackX = 0.3, kTrackY = 0.4;  // [m] contact points under the tracks

/// A place on the loop: in S, `heading` counter-clockwise from +V.
struct Place {
  Vector2d p_S;
  double heading;
};

/// `distance` along the loop, counter-clockwise from the west end of the south side.
Place OnLoop(double distance) {
  const double straights[] = {2 * kHalfStraightU, 2 * kHalfStraightV};
  const double arc = kCornerRadius * pi / 2;
  distance = std::fmod(distance, 2 * (straights[0] + straights[1]) + 4 * arc);
  // Each side is driven along +U of its own frame, which is turned by 90 degrees from side to side.
  for (int side = 0;; ++side) {
    const double straight = straights[side % 2];
    if (distance >= straight + arc) {
      distance -= straight + arc;
      continue;
    }
    const double out = side % 2 == 0 ? kLoopV : kLoopU;
    const double bend = std::max(0.0, distance - straight) / kCornerRadius;
    const Vector2d on_side(
        std::min(distance, straight) - straight / 2 + kCornerRadius * std::sin(bend),
        -out + kCornerRadius * (1 - std::cos(bend)));
    const Eigen::Rotation2Dd turned(side * pi / 2);
    return {turned * on_side, side * pi / 2 + bend - pi / 2};
  }
}

/// On the plane through four contact points under the tracks, as far as four points have one.
Isometry3d OnSupport(const Place& place) {
  const Isometry3d X_MS = SitePose();
  const double site_heading = sim::ToAttitude(X_MS.linear()).heading;
  const double heading = sim::WrapHeading(site_heading + place.heading);
  Isometry3d X_MR = Isometry3d::Identity();
  X_MR.translation() = X_MS * Vector3d(place.p_S.x(), place.p_S.y(), 0);
  X_MR.linear() = sim::ToRotation({.heading = heading});
  const auto height = [&](double x, double y) {
    const Vector3d p_M = X_MR * Vector3d(x, y, 0);
    return SupportHeight(p_M.x(), p_M.y());
  };
  const double front_left = height(-kTrackX, kTrackY), front_right = height(kTrackX, kTrackY);
  const double rear_left = height(-kTrackX, -kTrackY), rear_right = height(kTrackX, -kTrackY);
  const double rise = (front_left + front_right - rear_left - rear_right) / (4 * kTrackY);
  const double cant = (front_right + rear_right - front_left - rear_left) / (4 * kTrackX);
  const Vector3d n_M = (X_MR.linear() * Vector3d(-cant, -rise, 1)).normalized();
  X_MR.translation().z() = (front_left + front_right + rear_left + rear_right) / 4;
  X_MR.linear() = sim::ToRotation(sim::AttitudeOnPlane(n_M, heading));
  return X_MR;
}

Isometry3d At(double x, double y, double z, double pitch = 0) {
  Isometry3d X = Isometry3d::Identity();
  X.translation() << x, y, z;
  X.linear() = sim::ToRotation({.pitch = pitch});
  return X;
}

/// The arm's elbow and hand, as it swings once in ten seconds between high and near the ground.
void PoseArm(double swing, RobotPose& pose) {
  const double upper = 1.0 + 0.35 * swing, fore = -1.0 + 0.45 * swing;  // [rad] over the horizon
  const Isometry3d X_RE = At(0, -0.1, 0.55, upper) * At(0, 0.55, 0);
  const Isometry3d X_RH =
      At(0, X_RE.translation().y(), X_RE.translation().z(), fore) * At(0, 0.6, 0);
  pose.X_MB[5] = pose.X_MR * X_RE;
  pose.X_MB[7] = pose.X_MR * X_RH;
  pose.X_MB[8] = pose.X_MR * X_RH * At(-0.14, 0.2, 0);
  pose.X_MB[9] = pose.X_MR * X_RH * At(0.14, 0.2, 0);
}

}  // namespace

std::vector<RobotPose> DrivePath(int frames) {
  std::vector<RobotPose> path(static_cast<size_t>(frames));
  for (int frame = 0; frame < frames; ++frame) {
    RobotPose& pose = path[static_cast<size_t>(frame)];
    const double time = frame / kFrameRate;
    pose.X_MR = OnSupport(OnLoop(kSpeed * time));
    pose.heading = sim::ToAttitude(pose.X_MR.linear()).heading;
    const Isometry3d& X_MR = pose.X_MR;
    pose.X_MB[0] = X_MR * At(-0.3, 0.45, 0.13);
    pose.X_MB[1] = X_MR * At(0.3, 0.45, 0.13);
    pose.X_MB[2] = X_MR * At(-0.3, -0.45, 0.13);
    pose.X_MB[3] = X_MR * At(0.3, -0.45, 0.13);
    pose.X_MB[4] = X_MR * At(0, 0.5, 0.28);
    pose.X_MB[6] = X_MR * At(-0.2, -0.25, 1.2);
    PoseArm(std::sin(2 * pi * time / 10), pose);
  }
  return path;
}

}  // namespace eod::bench
