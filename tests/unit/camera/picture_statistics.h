#pragma once

#include <cstdint>
#include <vector>

#include <Eigen/Core>

namespace eod::sim {

/// Part of a picture [px], the origin at its top left.
struct Region {
  int left = 0;
  int top = 0;
  int right = 0;
  int bottom = 0;
};

/// What a region looks like; colours 0..255.
struct RegionStatistics {
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  Eigen::Vector3d deviation = Eigen::Vector3d::Zero();
  double brightness() const { return mean.mean(); }
};

/// `rgba`: bottom row first, as the renderer hands it out.
RegionStatistics Look(const std::vector<uint8_t>& rgba, int width, int height,
                      const Region& region);

/// Number of pixels within 12 of `colour` in each channel.
int CountColour(const std::vector<uint8_t>& rgba, const uint8_t* colour);

}  // namespace eod::sim
