#include "sim/radio/cable.h"

namespace eod::sim {

Cable::Cable(double length) : length_(length), most_(length) {
  corners_.reserve(kMostCorners + 1);
  corners_.push_back(Eigen::Vector3d::Zero());
}

void Cable::Reset(const Eigen::Vector3d& fixed_end, const Eigen::Vector3d& robot) {
  corners_.assign(1, fixed_end);
  robot_ = seen_ = robot;
  fixed_ = 0;
  most_ = length_;
  snagged_ = false;
}

void Cable::FindCorners(const World& world, SightLine& sight) {
  if (sight.Walls(world, corners_.back(), robot_) > 0) {
    if (corners_.size() <= kMostCorners && seen_ != corners_.back()) {
      fixed_ += (seen_ - corners_.back()).norm();
      corners_.push_back(seen_);
    }
  } else if (corners_.size() > 1 &&
             sight.Walls(world, corners_[corners_.size() - 2], robot_) == 0) {
    corners_.pop_back();
    fixed_ = 0;
    for (size_t i = 1; i < corners_.size(); ++i) fixed_ += (corners_[i] - corners_[i - 1]).norm();
  }
  seen_ = robot_;
}

void Cable::SetSnagged(bool snagged) {
  if (snagged == snagged_) return;
  snagged_ = snagged;
  most_ = snagged ? std::min(length_, paid_out()) : length_;
}

Eigen::Vector2d Cable::Outwards() const {
  const Eigen::Vector2d way = (robot_ - corners_.back()).head<2>();
  const double length = way.norm();
  return length > 0 ? Eigen::Vector2d(way / length) : Eigen::Vector2d::Zero();
}

}  // namespace eod::sim
