#include "tests/bench/paper_claims/stop_gap.h"

#include <algorithm>
#include <limits>
#include <stdexcept>

#include "sim/isectors/isector_set.h"
#include "sim/motion/motion.h"
#include "sim/response/response.h"
#include "sim/world/analytic_world.h"

namespace eod::claims {
namespace {

using Eigen::Vector3d;
using sim::DistanceLaw;

constexpr double kWallY = 3;  // [m] ahead of the module's origin

/// A line of a small wheel; all that lie level have one D0.
const sim::SegmentSpec& FirstLine(const sim::RobotModel& robot) {
  return robot.isectors.at(sim::FindIsector(robot, "B1")).segments[0];
}

/// The robot before a wall, stepped as the simulator does it: cast, judge, move what may move.
class Approach {
 public:
  Approach(const sim::RobotModel& robot, double speed_mps, const DistanceLaw& law)
      : robot_(robot), law_(law), isectors_(robot_, sim::kModuleFlat, sim::Coverage::kPaper) {
    robot_.drive_speed = {speed_mps, speed_mps, speed_mps};
    wall_.AddPlane("wall", sim::kModuleFlat | sim::kBumpProxy, {0, kWallY, 0}, -Vector3d::UnitY());
    demand_.rate[sim::kDriveForward] = 1;
    demand_.commanded = sim::SetOf(sim::kDriveForward);
  }
  Approach(const Approach&) = delete;
  Approach& operator=(const Approach&) = delete;

  /// Gap [m] at which it stands, after it has come from `start_gap`.
  double StopFrom(double start_gap) {
    state_ = sim::HomeState(robot_);
    state_.joint[sim::kFrontFlipper] = 0;  // the small wheels go first
    state_.joint[sim::kRearFlipper] = 0;
    response_ = {};
    state_.position.y() += Gap() - start_gap;
    constexpr int kMostSteps = 10;
    for (int i = 0; i < kMostSteps; ++i) {
      if (Step()) return Gap();
    }
    throw std::logic_error("the robot did not stop before the wall");
  }

 private:
  /// From the foremost point of the front left small wheel to the wall.
  double Gap() {
    sim::LinkPoses(robot_, state_, X_ML_);
    const sim::IsectorSpec& wheel = robot_.isectors.at(sim::FindIsector(robot_, "B1"));
    const Vector3d centre = X_ML_[wheel.link] * wheel.X_LI.translation();
    const double radius = FirstLine(robot_).d0 - FirstLine(robot_).skin;
    return kWallY - centre.y() - radius;
  }

  /// True if the robot may not go on.
  bool Step() {
    sim::LinkPoses(robot_, state_, X_ML_);
    isectors_.Cast(wall_, X_ML_, demand_.commanded | response_.Watched());
    sim::Respond(robot_, state_, X_ML_, isectors_.segments(), demand_, law_, response_);
    if (sim::Contains(response_.blocked, sim::kDriveForward)) return true;
    state_ = sim::Advance(robot_, state_, demand_, law_.dt_s);
    return false;
  }

  sim::RobotModel robot_;
  DistanceLaw law_;
  sim::IsectorSet isectors_;
  sim::AnalyticWorld wall_;
  sim::MotionDemand demand_;
  sim::RobotState state_;
  sim::Response response_;
  std::vector<Eigen::Isometry3d> X_ML_;
};

StopGap StopsAt(const sim::RobotModel& robot, double speed_mps, const DistanceLaw& law,
                int starts) {
  Approach approach(robot, speed_mps, law);
  const double step = speed_mps * law.dt_s;
  const double beyond_d = FirstLine(robot).skin + 2 * step;  // Eq. 2 adds one step at most
  StopGap gap{.speed_mps = speed_mps,
              .worst = std::numeric_limits<double>::infinity(),
              .mean = 0,
              .largest = -std::numeric_limits<double>::infinity()};
  for (int i = 0; i < starts; ++i) {
    // Half a place off, so that no start is on the rim, where rounding would decide.
    const double shift = step * (i + 0.5) / starts;
    const double stop = approach.StopFrom(beyond_d + shift);
    gap.worst = std::min(gap.worst, stop);
    gap.largest = std::max(gap.largest, stop);
    gap.mean += stop / starts;
  }
  return gap;
}

}  // namespace

StopGaps MeasureStopGaps(const sim::RobotModel& robot, double dt_s,
                         const std::vector<double>& speeds_mps, int starts) {
  const DistanceLaw fixed{.dt_s = dt_s, .with_factor = false}, eq2{.dt_s = dt_s};
  StopGaps gaps;
  gaps.dt_s = dt_s;
  gaps.d0 = FirstLine(robot).skin;
  gaps.v0_mps = gaps.d0 / dt_s;
  for (const double speed : speeds_mps) {
    gaps.fixed.push_back(StopsAt(robot, speed, fixed, starts));
    gaps.eq2.push_back(StopsAt(robot, speed, eq2, starts));
  }
  gaps.below_v0 = StopsAt(robot, gaps.v0_mps * (1 - 1e-6), eq2, starts);
  gaps.above_v0 = StopsAt(robot, gaps.v0_mps * (1 + 1e-6), eq2, starts);
  return gaps;
}

}  // namespace eod::claims
