#pragma once

#include <cstdint>
#include <vector>

namespace eod::recorder {

struct Colour {
  uint8_t red = 0;
  uint8_t green = 0;
  uint8_t blue = 0;
  bool operator==(const Colour&) const = default;
};

/// In pixels; x to the right, y down.
struct Rectangle {
  int x = 0;
  int y = 0;
  int width = 0;
  int height = 0;
  int right() const { return x + width; }
  int bottom() const { return y + height; }
  bool operator==(const Rectangle&) const = default;
};

/// A picture of 8-bit RGB, top row first.
struct Picture {
  int width = 0;
  int height = 0;
  std::vector<uint8_t> rgb;
};

/// A picture to draw on. Whatever lies outside is not drawn.
class Canvas {
 public:
  /// Throws std::invalid_argument unless both sizes are positive.
  Canvas(int width, int height, Colour background);

  void Fill(const Rectangle& area, Colour colour);
  /// With round corners of `radius` pixels, smooth edges.
  void FillRounded(const Rectangle& area, int radius, Colour colour);
  /// `picture` scaled into `area`; each pixel is the mean of what it covers.
  void Place(const Picture& picture, const Rectangle& area);
  /// Mixes `colour` into one pixel; `coverage` 0 leaves it, 255 replaces it.
  void Blend(int x, int y, Colour colour, int coverage);

  Colour At(int x, int y) const;
  const Picture& picture() const { return picture_; }

 private:
  Picture picture_;
};

}  // namespace eod::recorder
