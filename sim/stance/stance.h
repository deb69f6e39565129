#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include <Eigen/Geometry>

#include "sim/robot/robot_model.h"
#include "sim/robot/robot_state.h"
#include "sim/segments/cast_memory.h"
#include "sim/stance/gravity_centre.h"
#include "sim/stance/resting_plane.h"
#include "sim/world/world.h"

namespace eod::sim {

/// How the robot stands on any ground: quasi-static rest on the points of StanceSpec.
///
/// One vertical line is cast through every point of the underside, as HAT does. The robot rests on
/// the plane above all ground heights that is lowest at its centre of gravity. Two limits make it
/// move as a body does: no point sinks faster than gravity lets it fall, and none rises faster than
/// drive and flippers can lift it. Where nothing carries, that is free fall; where the ground ends
/// before the centre of gravity, it tips. Beyond the friction of StanceSpec it slides downhill.
/// One for each robot and module; no allocation after construction.
class Stance {
 public:
  /// `robot` must outlive it. `module_mask`: bits of the modules whose ground carries.
  Stance(const RobotModel& robot, uint32_t module_mask);

  /// Forgets what it stood on.
  void Reset();

  /// The state after a step of `dt_s` whose motions led from `before` to `state`, with link poses
  /// `X_ML`. Height, pitch and roll are set, the place while it slips, and at_rest, fall_speed,
  /// slip and rolls_over.
  RobotState Stand(const World& world, std::span<const Eigen::Isometry3d> X_ML,
                   const RobotState& before, const RobotState& state, double dt_s,
                   const Load& load = {});

  /// Where it comes to rest if it is put down at `state` with care; gives up after some rounds, and
  /// over an abyss. `X_ML` is overwritten.
  RobotState PutDown(const World& world, RobotState state, std::vector<Eigen::Isometry3d>& X_ML,
                     const Load& load = {});

  /// [m] from the lowest point of the front (0) or rear (1) flippers to the ground below it, in the
  /// last Stand; negative if it presses into it.
  double FlipperGap(int end) const { return flipper_gap_[static_cast<size_t>(end)]; }
  /// Work of the last Stand.
  const CastCounters& counters() const { return memory_.counters; }
  int pivots() const { return plane_.pivots; }

 private:
  struct Limits {
    double sink = 0;  ///< [m] a point may move down in this step
    double rise = 0;  ///< [m] a point may move up
  };
  RobotState StandWithin(const World& world, std::span<const Eigen::Isometry3d> X_ML,
                         const RobotState& state, const Limits& limits, double dt_s,
                         const Load& load);
  void LookForGround(const World& world, std::span<const Eigen::Isometry3d> X_ML);
  void CastLines(const World& world);
  void MeetLevelGround(double z);
  void SetProps(const RobotState& state, const Limits& limits);
  bool Rest(const Eigen::Vector2d& centre, double sink);
  void FallByTheCentre(const Eigen::Vector2d& centre, double sink, double dt_s);
  bool WarmStart(const Eigen::Vector2d& centre, std::array<int, 3>& triangle) const;
  bool IsOnGround(int prop, double sink) const;
  bool IsHeldUp(double sink) const;
  double SinkSpeed(double dt_s) const;
  bool Slip(RobotState& state, double dt_s) const;
  bool Trembles(const RobotState& state, double dt_s);
  void Lie();

  const RobotModel& robot_;
  uint32_t class_mask_;
  double turning_radius_ = 0;    ///< [m] of the tracks' farthest point
  std::vector<int> flipper_of_;  ///< of each point: 0 front, 1 rear, -1 none
  // Of the points that look down in this step:
  std::vector<int> points_;
  std::vector<Eigen::Vector3d> starts_;  ///< of their lines
  std::vector<SegmentQuery> queries_;    ///< on ground that is not level
  std::vector<SegmentHit> hits_;         ///< hit, range and normal, on level ground no more
  std::vector<double> depths_;           ///< [m] of the point in the ground; negative above it
  std::vector<Prop> props_;  ///< the same within the limits, and one more for a robot that tips
  CastMemory memory_;
  RestingPlane plane_;
  std::array<int, 3> stood_on_ = {-1, -1, -1};  ///< points of the last plane
  double centre_sink_ = 0;                      ///< [m] of the centre of gravity in the last step
  Eigen::Vector2d turn_ = Eigen::Vector2d::Zero();  ///< slope of the last step's plane_
  std::array<double, 2> flipper_gap_{};
  struct Calm {
    Eigen::Vector3d position = Eigen::Vector3d::Zero();
    Eigen::Vector3d tilt = Eigen::Vector3d::Zero();  ///< [rad] pitch, roll
  };
  Calm calm_at_;
  double calm_s_ = 0;  ///< spent there by a robot that is not moved; 0: it was
};

}  // namespace eod::sim
