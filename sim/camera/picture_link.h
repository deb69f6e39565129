#pragma once

#include <cstdint>
#include <vector>

#include "platform/time.h"
#include "sim/camera/pixel_view.h"

namespace eod::sim {

/// The way from a camera to the operator: it compresses harder the worse it gets, loses strips of
/// pictures, then whole ones. Repeatable: what is lost follows from time and seed.
class PictureLink {
 public:
  /// JPEG quality to use at link quality `quality` (0..1) where `best` is that of a good link.
  static int JpegQuality(float quality, int best);

  /// Damages the picture of moment `time` as it arrives. What is lost shows what arrived before.
  void Carry(float quality, TimePoint time, uint32_t seed, const PixelView& picture);

  /// Whether nothing arrives any more.
  static bool IsLost(float quality) { return quality <= 0; }

 private:
  void LoseStrips(float quality, uint32_t chance, const PixelView& picture) const;

  std::vector<uint8_t> arrived_;  ///< the picture before
};

}  // namespace eod::sim
