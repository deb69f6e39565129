#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace eod::sim {

/// Compresses pictures with libjpeg-turbo, 4:2:0. Buffers are reused.
class JpegEncoder {
 public:
  /// A picture that must fit one LCM datagram of 65,507 bytes, its header included.
  static constexpr size_t kMaxBytes = 65000;

  /// `quality` 1..100. Throws std::runtime_error for a size that cannot be compressed.
  JpegEncoder(int width, int height, int quality);
  /// `rgba`: bottom row first. The quality is lowered for this picture until it has at most
  /// kMaxBytes. Empty if it cannot be compressed. Valid until the next call.
  std::span<const uint8_t> Encode(std::span<const uint8_t> rgba);

  /// 1..100, from the next picture on.
  void set_quality(int quality) { quality_ = quality; }
  /// Quality of the last picture.
  int last_quality() const { return last_quality_; }

 private:
  int width_;
  int height_;
  int quality_;
  int last_quality_ = 0;
  std::unique_ptr<void, int (*)(void*)> handle_;  // tjDestroy
  std::vector<uint8_t> buffer_;
};

}  // namespace eod::sim
