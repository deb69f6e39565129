#pragma once

#include <cstdint>
#include <vector>

#include <Eigen/Core>

namespace eod::sim {

/// A painted picture as OpenGL takes it: RGBA, 8 bit, bottom row first. The values are the square
/// root of linear light (gamma 2), which the shaders undo by one multiplication.
struct Image {
  int width = 0;
  int height = 0;
  std::vector<uint8_t> rgba;
};

/// A picture being painted, in gamma 2 colours of 0..1. Wraps around at its edges.
class Canvas {
 public:
  Canvas(int width, int height);

  int width() const { return width_; }
  int height() const { return height_; }
  Eigen::Vector3f& At(int x, int y);

  /// Sets every pixel to `paint(u, v)`, u and v in 0..1.
  template <typename Paint>
  void Fill(const Paint& paint) {
    for (int y = 0; y < height_; ++y) {
      for (int x = 0; x < width_; ++x) {
        At(x, y) = paint((static_cast<float>(x) + 0.5F) / static_cast<float>(width_),
                         (static_cast<float>(y) + 0.5F) / static_cast<float>(height_));
      }
    }
  }

  /// Line of one pixel's width, blended over what is there with `opacity`.
  void Stroke(const Eigen::Vector2f& from, const Eigen::Vector2f& to, const Eigen::Vector3f& colour,
              float opacity);

  Image ToImage() const;

 private:
  int width_;
  int height_;
  std::vector<Eigen::Vector3f> pixels_;
};

}  // namespace eod::sim
