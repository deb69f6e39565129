#include "sim/camera/jpeg_encoder.h"

#include <algorithm>
#include <stdexcept>

#include <fmt/format.h>
#include <turbojpeg.h>

namespace eod::sim {

JpegEncoder::JpegEncoder(int width, int height, int quality)
    : width_(width), height_(height), quality_(quality), handle_(tjInitCompress(), &tjDestroy) {
  const unsigned long needed = tjBufSize(width, height, TJSAMP_420);
  if (handle_ == nullptr || width <= 0 || height <= 0 || needed == static_cast<unsigned long>(-1)) {
    throw std::runtime_error(
        fmt::format("cameras: no picture of {} x {} is possible", width, height));
  }
  buffer_.resize(needed);
}

std::span<const uint8_t> JpegEncoder::Encode(std::span<const uint8_t> rgba) {
  for (int quality = quality_;; quality = std::max(1, quality - 10)) {
    unsigned char* output = buffer_.data();
    unsigned long size = buffer_.size();
    last_quality_ = quality;
    const int outcome =
        tjCompress2(handle_.get(), rgba.data(), width_, 0, height_, TJPF_RGBX, &output, &size,
                    TJSAMP_420, quality, TJFLAG_BOTTOMUP | TJFLAG_NOREALLOC | TJFLAG_FASTDCT);
    if (outcome != 0) return {};
    if (size <= kMaxBytes) return std::span(buffer_).first(size);
    if (quality == 1) return {};
  }
}

}  // namespace eod::sim
