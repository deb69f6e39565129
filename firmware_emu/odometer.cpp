#include "firmware_emu/odometer.h"

#include <cmath>

namespace eod::box {

double WrapDegrees(double angle_deg) {
  const double wrapped = std::remainder(angle_deg, 360.0);
  return wrapped == -180.0 ? 180.0 : wrapped;
}

void Odometer::Restart(TimePoint now, const dbc::RobotFeedback& feedback) {
  last_ = now;
  heading_deg_ = feedback.heading_deg;
  travel_m_ = turned_deg_ = 0;
}

void Odometer::Update(TimePoint now, const dbc::RobotFeedback& feedback) {
  travel_m_ += feedback.speed_mps * ToSeconds(now - last_);
  turned_deg_ += WrapDegrees(feedback.heading_deg - heading_deg_);
  heading_deg_ = feedback.heading_deg;
  last_ = now;
}

}  // namespace eod::box
