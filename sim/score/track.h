#pragma once

#include <vector>

#include <Eigen/Core>

namespace eod::sim {

/// Where something went on the map, as finely as there is room for. Never allocates after it was
/// made: when it is full every second point is given up.
class Track {
 public:
  static constexpr size_t kRoom = 1024;
  Track() { points_.reserve(kRoom); }

  void Clear();
  void Add(const Eigen::Vector2d& point);
  const std::vector<Eigen::Vector2d>& points() const { return points_; }

 private:
  static constexpr double kFinest = 0.05;  // [m]
  std::vector<Eigen::Vector2d> points_;
  double spacing_ = kFinest;
};

}  // namespace eod::sim
