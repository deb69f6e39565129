#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace eod::sim {

/// Part of a picture [px], its origin at the bottom left.
struct PixelArea {
  int x = 0;
  int y = 0;
  int width = 0;
  int height = 0;
  bool operator==(const PixelArea&) const = default;
};

/// A picture in memory, or a part of one: RGBA, 8 bit, bottom row first.
struct PixelView {
  uint8_t* first = nullptr;  ///< of the bottom left pixel
  int width = 0;
  int height = 0;
  int stride = 0;  ///< [px] from row to row

  /// The leftmost pixel of a row, counted from the top.
  uint8_t* Row(int from_top) const {
    return first + 4 * static_cast<ptrdiff_t>(height - 1 - from_top) * stride;
  }
  PixelView Part(const PixelArea& area) const {
    return {first + 4 * (static_cast<ptrdiff_t>(area.y) * stride + area.x), area.width, area.height,
            stride};
  }
  /// All of a picture; `rgba` must hold it.
  static PixelView Of(std::vector<uint8_t>& rgba, int width, int height) {
    return {rgba.data(), width, height, width};
  }
};

}  // namespace eod::sim
