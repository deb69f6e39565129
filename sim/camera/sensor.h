#pragma once

#include <cstdint>
#include <vector>

#include "sim/camera/pixel_view.h"

namespace eod::sim {

/// How a camera takes one picture.
struct Exposure {
  float stops = 0;        ///< times two of light each, too much or (below 0) too little
  bool is_noisy = false;  ///< a fault of the camera
  uint32_t seed = 0;      ///< of the noise: another one each picture
};

/// What a lens and a small sensor do to a picture of one size: dark corners, and noise that grows
/// with the gain a dark picture asks for. On the processor, after the picture was read back: the
/// same bytes whoever rendered it, and less work than another pass over the picture.
class Sensor {
 public:
  Sensor(int width, int height);

  void Expose(const Exposure& exposure, const PixelView& picture);

  /// Standard deviation of the noise [0..255] in a picture of that mean brightness [0..255].
  static double NoiseOf(double brightness);

 private:
  std::vector<uint16_t> columns_;  ///< of 4 bytes a pixel: share of light, 256 in the middle
  std::vector<uint16_t> rows_;
};

/// Mean of the three colours [0..255] of every 16th pixel of every 16th row.
double MeanBrightness(const PixelView& picture);

/// A repeatable number of two.
uint32_t Hash(uint32_t a, uint32_t b);

}  // namespace eod::sim
