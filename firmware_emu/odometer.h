#pragma once

#include "firmware_emu/panel_status.h"
#include "platform/time.h"

namespace eod::box {

/// Path since the last `Restart`, dead-reckoned from what the box's display shows.
///
/// Between two pose frames the displayed speeds are joined by a straight line (trapezoids), which
/// is exact for constant acceleration; after the last one its speed is taken to go on, for 100 ms
/// at most, so that the path does not wait for the next frame. What remains is the rounding of the
/// displayed speed, half of 1 mm/s, and the corners between two frames, a t^2 / 8 for a change of
/// acceleration by a within the cycle t. The heading is the displayed one: it lags by up to a
/// cycle.
class Odometer {
 public:
  void Restart(TimePoint now, const PanelStatus& status);
  void Update(TimePoint now, const PanelStatus& status);

  double travel_m() const { return travel_m_ - start_m_; }  ///< [m] forward positive
  double turned_deg() const { return turned_deg_; }         ///< [deg] left positive, beyond 360 too

 private:
  TimePoint pose_{};           ///< when the last pose frame came
  double pose_speed_mps_ = 0;  ///< the speed in it
  double pose_travel_m_ = 0;   ///< path up to it
  double travel_m_ = 0;        ///< path up to now
  double start_m_ = 0;         ///< path up to the restart
  double heading_deg_ = 0;
  double turned_deg_ = 0;
};

/// `angle_deg` in (-180, 180].
double WrapDegrees(double angle_deg);

}  // namespace eod::box
