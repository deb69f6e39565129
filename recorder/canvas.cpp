#include "recorder/canvas.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace eod::recorder {
namespace {

// How much of the pixel at (x, y) a rounded rectangle covers, 0..255: by the distance of the
// pixel's centre from the corner's circle.
int RoundedCoverage(const Rectangle& area, int radius, int x, int y) {
  const double centre_x = std::clamp(x + 0.5, area.x + 0.0 + radius, area.right() - 0.0 - radius);
  const double centre_y = std::clamp(y + 0.5, area.y + 0.0 + radius, area.bottom() - 0.0 - radius);
  const double distance = std::hypot(x + 0.5 - centre_x, y + 0.5 - centre_y);
  return static_cast<int>(std::lround(255 * std::clamp(radius + 0.5 - distance, 0.0, 1.0)));
}

// Mean of the picture's pixels in columns [x0, x1) and rows [y0, y1), at least one.
Colour Mean(const Picture& picture, int x0, int y0, int x1, int y1) {
  unsigned red = 0;
  unsigned green = 0;
  unsigned blue = 0;
  for (int y = y0; y < y1; ++y) {
    for (int x = x0; x < x1; ++x) {
      const uint8_t* pixel = &picture.rgb[(static_cast<size_t>(y) * picture.width + x) * 3];
      red += pixel[0];
      green += pixel[1];
      blue += pixel[2];
    }
  }
  const auto count = static_cast<unsigned>((x1 - x0) * (y1 - y0));
  const auto rounded = [count](unsigned sum) {
    return static_cast<uint8_t>((sum + count / 2) / count);
  };
  return {rounded(red), rounded(green), rounded(blue)};
}

}  // namespace

Canvas::Canvas(int width, int height, Colour background) {
  if (width <= 0 || height <= 0) throw std::invalid_argument("canvas without a size");
  picture_.width = width;
  picture_.height = height;
  picture_.rgb.resize(static_cast<size_t>(width) * height * 3);
  Fill({0, 0, width, height}, background);
}

void Canvas::Fill(const Rectangle& area, Colour colour) { FillRounded(area, 0, colour); }

void Canvas::FillRounded(const Rectangle& area, int radius, Colour colour) {
  for (int y = area.y; y < area.bottom(); ++y) {
    for (int x = area.x; x < area.right(); ++x) {
      Blend(x, y, colour, radius == 0 ? 255 : RoundedCoverage(area, radius, x, y));
    }
  }
}

void Canvas::Place(const Picture& picture, const Rectangle& area) {
  if (picture.width <= 0 || picture.height <= 0) return;
  const auto span = [](int i, int target, int source) {
    const int begin = static_cast<int>(int64_t{i} * source / target);
    const int end = static_cast<int>(int64_t{i + 1} * source / target);
    return std::pair(begin, std::max(end, begin + 1));
  };
  for (int y = 0; y < area.height; ++y) {
    const auto [y0, y1] = span(y, area.height, picture.height);
    for (int x = 0; x < area.width; ++x) {
      const auto [x0, x1] = span(x, area.width, picture.width);
      Blend(area.x + x, area.y + y, Mean(picture, x0, y0, x1, y1), 255);
    }
  }
}

void Canvas::Blend(int x, int y, Colour colour, int coverage) {
  if (x < 0 || y < 0 || x >= picture_.width || y >= picture_.height) return;
  uint8_t* pixel = &picture_.rgb[(static_cast<size_t>(y) * picture_.width + x) * 3];
  const auto mixed = [coverage](uint8_t old, uint8_t wanted) {
    return static_cast<uint8_t>((old * (255 - coverage) + wanted * coverage + 127) / 255);
  };
  pixel[0] = mixed(pixel[0], colour.red);
  pixel[1] = mixed(pixel[1], colour.green);
  pixel[2] = mixed(pixel[2], colour.blue);
}

Colour Canvas::At(int x, int y) const {
  const uint8_t* pixel = &picture_.rgb[(static_cast<size_t>(y) * picture_.width + x) * 3];
  return {pixel[0], pixel[1], pixel[2]};
}

}  // namespace eod::recorder
