#pragma once

#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

#include "sim/camera/pixel_view.h"

namespace eod::sim {

/// Letters of one size, rendered once: white with a dark rim, so that they are read before sky and
/// shadow alike. All are as wide as each other, so that numbers do not jump.
class GlyphAtlas {
 public:
  /// `size`: pixels an em. DejaVu Sans Mono Bold, as Debian's fonts-dejavu-core has it. Throws
  /// std::runtime_error that names the file and the package.
  explicit GlyphAtlas(int size);

  int advance() const { return advance_; }
  /// Distance of lines.
  int line_height() const { return line_height_; }
  /// [px] across, its rim included.
  int Width(std::string_view text) const;

  /// Draws `text` (Latin-1) with its left end at `left` and the top of its line at `top`, which
  /// count from the top left of the picture. What reaches beyond the picture is cut off.
  void Draw(std::string_view text, int left, int top, const PixelView& picture) const;

 private:
  static constexpr int kRim = 2;  // [px] around each letter

  int advance_ = 0;
  int line_height_ = 0;
  int cell_width_ = 0;
  int cell_height_ = 0;
  /// Cells of all 256 letters: coverage of the ink, and of the rim with the ink.
  std::vector<uint8_t> ink_;
  std::vector<uint8_t> rim_;
};

/// Blends `colour` over a rectangle, `alpha` 0..255; counts from the top left. Cut at the edges.
void FillRectangle(const PixelView& picture, int left, int top, int width, int height,
                   const std::array<uint8_t, 3>& colour, int alpha = 255);

}  // namespace eod::sim
