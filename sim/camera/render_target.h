#pragma once

#include <cstdint>
#include <vector>

#include "sim/camera/canvas.h"
#include "sim/camera/gl_object.h"
#include "sim/camera/pixel_view.h"

namespace eod::sim {

/// Colour and depth buffer of one picture.
class RenderTarget {
 public:
  RenderTarget(const GlFunctions& gl, int width, int height);

  int width() const { return width_; }
  int height() const { return height_; }
  PixelArea whole() const { return {0, 0, width_, height_}; }
  /// Makes this the buffer that is drawn into, `area` the viewport, and leaves all else alone.
  void Bind(const PixelArea& area) const;
  /// Copies the picture out: RGBA, bottom row first. `pixels` keeps its memory between calls.
  void Read(std::vector<uint8_t>& pixels) const;

 private:
  const GlFunctions* gl_;
  int width_;
  int height_;
  GlObject colour_;
  GlObject depth_;
  GlObject framebuffer_;
};

/// Depth of the scene seen from the sun; compared while it is sampled, which softens edges.
class ShadowMap {
 public:
  static constexpr int kSide = 1024;

  explicit ShadowMap(const GlFunctions& gl);
  void Bind() const;
  GLuint texture() const { return texture_.id(); }

 private:
  const GlFunctions* gl_;
  GlObject texture_;
  GlObject framebuffer_;
};

/// Repeating texture with mipmaps: bilinear in the nearest one, which a CPU renders twice as fast
/// as trilinear.
GlObject UploadSurface(const GlFunctions& gl, const Image& image);

/// Texture that repeats around the horizon only; no mipmaps.
GlObject UploadPanorama(const GlFunctions& gl, const Image& image);

}  // namespace eod::sim
