#pragma once

#include "dbc/robot_feedback.h"
#include "platform/time.h"

namespace eod::box {

/// Path since the last `Restart`, dead-reckoned from what the box's display shows. It lags the
/// robot by up to one pose cycle (50 ms), as an operator's eye does.
class Odometer {
 public:
  void Restart(TimePoint now, const dbc::RobotFeedback& feedback);
  void Update(TimePoint now, const dbc::RobotFeedback& feedback);

  double travel_m() const { return travel_m_; }      ///< [m] forward positive
  double turned_deg() const { return turned_deg_; }  ///< [deg] left positive, beyond 360 too

 private:
  TimePoint last_{};
  double heading_deg_ = 0;
  double travel_m_ = 0;
  double turned_deg_ = 0;
};

/// `angle_deg` in (-180, 180].
double WrapDegrees(double angle_deg);

}  // namespace eod::box
