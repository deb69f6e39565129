#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "recorder/canvas.h"

namespace eod::recorder {

/// Empty if it is no JPEG.
std::optional<Picture> DecodeJpeg(std::span<const uint8_t> jpeg);

/// The bytes of a PNG file. Throws std::runtime_error if libpng cannot.
std::vector<uint8_t> EncodePng(const Picture& picture);

}  // namespace eod::recorder
