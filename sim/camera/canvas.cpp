#include "sim/camera/canvas.h"

#include <algorithm>
#include <cmath>

namespace eod::sim {

Canvas::Canvas(int width, int height)
    : width_(width),
      height_(height),
      pixels_(static_cast<size_t>(width) * static_cast<size_t>(height),
              Eigen::Vector3f::Zero().eval()) {}

Eigen::Vector3f& Canvas::At(int x, int y) {
  const int column = ((x % width_) + width_) % width_;
  const int row = ((y % height_) + height_) % height_;
  return pixels_[static_cast<size_t>(row) * static_cast<size_t>(width_) +
                 static_cast<size_t>(column)];
}

void Canvas::Stroke(const Eigen::Vector2f& from, const Eigen::Vector2f& to,
                    const Eigen::Vector3f& colour, float opacity) {
  const Eigen::Vector2f way = to - from;
  const int steps = std::max(1, static_cast<int>(std::ceil(way.cwiseAbs().maxCoeff())));
  for (int step = 0; step <= steps; ++step) {
    const Eigen::Vector2f point =
        from + way * (static_cast<float>(step) / static_cast<float>(steps));
    Eigen::Vector3f& pixel =
        At(static_cast<int>(std::floor(point.x())), static_cast<int>(std::floor(point.y())));
    pixel += (colour - pixel) * opacity;
  }
}

Image Canvas::ToImage() const {
  Image image{width_, height_, {}};
  image.rgba.reserve(pixels_.size() * 4);
  for (const Eigen::Vector3f& pixel : pixels_) {
    for (int channel = 0; channel < 3; ++channel) {
      const float value = std::clamp(pixel[channel], 0.0F, 1.0F);
      image.rgba.push_back(static_cast<uint8_t>(std::lround(value * 255.0F)));
    }
    image.rgba.push_back(255);
  }
  return image;
}

}  // namespace eod::sim
