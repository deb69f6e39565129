#include "tests/unit/camera/picture_statistics.h"

#include <cstdlib>

namespace eod::sim {

RegionStatistics Look(const std::vector<uint8_t>& rgba, int width, int height,
                      const Region& region) {
  RegionStatistics look;
  Eigen::Vector3d squares = Eigen::Vector3d::Zero();
  int count = 0;
  for (int y = region.top; y < region.bottom; ++y) {
    for (int x = region.left; x < region.right; ++x) {
      const uint8_t* pixel = &rgba.at(static_cast<size_t>((height - 1 - y) * width + x) * 4);
      const Eigen::Vector3d colour(pixel[0], pixel[1], pixel[2]);
      look.mean += colour;
      squares += colour.cwiseProduct(colour);
      ++count;
    }
  }
  look.mean /= count;
  look.deviation = (squares / count - look.mean.cwiseProduct(look.mean)).cwiseMax(0).cwiseSqrt();
  return look;
}

int CountColour(const std::vector<uint8_t>& rgba, const uint8_t* colour) {
  int count = 0;
  for (size_t i = 0; i < rgba.size(); i += 4) {
    bool is_near = true;
    for (size_t channel = 0; channel < 3; ++channel) {
      is_near = is_near && std::abs(rgba[i + channel] - colour[channel]) <= 12;
    }
    count += is_near ? 1 : 0;
  }
  return count;
}

}  // namespace eod::sim
