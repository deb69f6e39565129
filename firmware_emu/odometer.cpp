#include "firmware_emu/odometer.h"

#include <algorithm>
#include <cmath>

namespace eod::box {
namespace {

constexpr Duration kLongestCoast = std::chrono::milliseconds(100);  // two pose cycles

}  // namespace

double WrapDegrees(double angle_deg) {
  const double wrapped = std::remainder(angle_deg, 360.0);
  return wrapped == -180.0 ? 180.0 : wrapped;
}

void Odometer::Restart(TimePoint now, const PanelStatus& status) {
  Update(now, status);
  start_m_ = travel_m_;
  turned_deg_ = 0;
}

void Odometer::Update(TimePoint now, const PanelStatus& status) {
  const dbc::RobotFeedback& robot = status.feedback;
  if (status.pose_time != pose_) {
    // The first frame, also after the box was off, has none before it to be joined with.
    if (pose_ != TimePoint{} && status.pose_time > pose_) {
      const double mean_mps = (pose_speed_mps_ + robot.speed_mps) / 2;
      pose_travel_m_ += mean_mps * ToSeconds(status.pose_time - pose_);
    }
    pose_ = status.pose_time;
    pose_speed_mps_ = robot.speed_mps;
  }
  const Duration coast = std::clamp(now - pose_, Duration::zero(), kLongestCoast);
  travel_m_ = pose_travel_m_ + pose_speed_mps_ * ToSeconds(coast);
  turned_deg_ += WrapDegrees(robot.heading_deg - heading_deg_);
  heading_deg_ = robot.heading_deg;
}

}  // namespace eod::box
