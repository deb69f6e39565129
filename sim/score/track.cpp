#include "sim/score/track.h"

namespace eod::sim {

void Track::Clear() {
  points_.clear();
  spacing_ = kFinest;
}

void Track::Add(const Eigen::Vector2d& point) {
  if (!points_.empty() && (point - points_.back()).norm() < spacing_) return;
  if (points_.size() == kRoom) {
    size_t kept = 0;
    for (size_t i = 0; i < points_.size(); i += 2) points_[kept++] = points_[i];
    points_.resize(kept);
    spacing_ *= 2;
  }
  points_.push_back(point);
}

}  // namespace eod::sim
