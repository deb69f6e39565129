#pragma once

namespace eod::sim {

class TomlTable;

/// What costs points, of 100, and when it does.
struct ScoreRules {
  double collision_points = 0;  ///< a collision that no step asked for
  double push_points = 0;       ///< a second of pushing on against what a contact stopped
  double push_grace = 0;        ///< [s] of pushing that are free: the operator has to notice
  double tilt_points = 0;       ///< each time the tilt goes beyond its limit
  double tilt_hysteresis = 0;   ///< [rad] below the limit, before another time can begin
  double touch_points = 0;      ///< a charge that is touched and not grasped
  double touch_memory = 0;      ///< [s] a touch lasts until the charge was left alone so long
  double fire_points = 0;       ///< the rule of the key or that of the two hands is broken
  double unseen_points = 0;     ///< driving without a camera on the way ahead
  double unseen_way = 0;        ///< [m] driven without, before it counts
  double view_pan = 0;          ///< [rad] the mast camera sees the way when turned so far off it
  double procedure_points = 0;  ///< an item of the check list missing, or out of order
  double time_zero = 0;         ///< of the par time: when the last point for time is gone
  double reversal_points = 0;   ///< driving or turning back at once
  double reversal_time = 0;     ///< [s] what at once means
  double undone_points = 0;     ///< a motion of flippers or arm is taken back at once
  double undone_share = 0;      ///< of it, to count as taken back
  double undone_angle = 0;      ///< [rad] smaller motions are corrections
  double limit_points = 0;      ///< a joint is driven against its limit
  double travel_reach = 0;      ///< [m] a charge nearer to the robot's origin is drawn in
  double travel_slack = 0;      ///< [m] of way with a charge that is not
};

/// Reads [score]. Throws "FILE:LINE: …".
ScoreRules ReadScoreRules(const TomlTable& table);

}  // namespace eod::sim
