#include "sim/camera/plume_pass.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "sim/camera/noise.h"
#include "sim/camera/render_target.h"
#include "sim/camera/shaders.h"

namespace eod::sim {
namespace {

constexpr int kSide = 64;
constexpr int kLumps = 6;  // across the texture
constexpr uint32_t kSeed = 71;

uint8_t ToByte(float value) {
  return static_cast<uint8_t>(std::lround(std::clamp(value, 0.0F, 1.0F) * 255.0F));
}

float SmoothStep(float from, float to, float value) {
  const float t = std::clamp((value - from) / (to - from), 0.0F, 1.0F);
  return t * t * (3 - 2 * t);
}

}  // namespace

Image PaintPuff() {
  Image image{kSide, kSide, std::vector<uint8_t>(4 * kSide * kSide)};
  for (int y = 0; y < kSide; ++y) {
    for (int x = 0; x < kSide; ++x) {
      const float u = (static_cast<float>(x) + 0.5F) / kSide;
      const float v = (static_cast<float>(y) + 0.5F) / kSide;
      const float radius = 2 * std::hypot(u - 0.5F, v - 0.5F);
      const float lumps = TilingFbm(u * kLumps, v * kLumps, kLumps, 3, kSeed);
      const float shade = TilingFbm(u * kLumps, v * kLumps, kLumps, 3, kSeed + 9);
      // Lumps eat into the rim; the very edge is clear whatever they do.
      const float alpha = SmoothStep(1.0F, 0.25F, radius + 0.9F * (lumps - 0.5F)) *
                          SmoothStep(0.96F, 0.75F, radius);
      uint8_t* pixel = &image.rgba[static_cast<size_t>(4 * (y * kSide + x))];
      std::fill_n(pixel, 3, ToByte(0.62F + 0.7F * (shade - 0.5F)));
      pixel[3] = ToByte(alpha);
    }
  }
  return image;
}

PlumePass::PlumePass(const GlFunctions& gl)
    : gl_(&gl),
      program_(MakeProgram(gl, "plume", kPlumeVertexShader, kPlumeFragmentShader)),
      texture_(UploadSurface(gl, PaintPuff())),
      array_(MakeVertexArray(gl)),
      buffer_(MakeBuffer(gl)) {
  constexpr GLsizei kStride = sizeof(PlumeVertex);
  gl.BindVertexArray(array_.id());
  gl.BindBuffer(GL_ARRAY_BUFFER, buffer_.id());
  const auto attribute = [&](GLuint index, GLint size, size_t offset) {
    gl.VertexAttribPointer(index, size, GL_FLOAT, GL_FALSE, kStride, BufferOffset(offset));
    gl.EnableVertexAttribArray(index);
  };
  attribute(0, 4, offsetof(PlumeVertex, position));
  attribute(1, 2, offsetof(PlumeVertex, uv));
  attribute(2, 4, offsetof(PlumeVertex, colour));
  attribute(3, 1, offsetof(PlumeVertex, cover));
  gl.UseProgram(program_.id());
  gl.Uniform1i(gl.GetUniformLocation(program_.id(), "u_texture"), 0);
}

int PlumePass::Draw(std::span<const PlumeQuad> quads, const Eigen::Isometry3d& X_MC,
                    const Lens& lens) {
  FaceCamera(quads, X_MC, lens, vertices_);
  if (vertices_.empty()) return 0;
  gl_->UseProgram(program_.id());
  gl_->ActiveTexture(GL_TEXTURE0);
  gl_->BindTexture(GL_TEXTURE_2D, texture_.id());
  gl_->BindVertexArray(array_.id());
  gl_->BindBuffer(GL_ARRAY_BUFFER, buffer_.id());
  gl_->BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(vertices_.size() * sizeof(PlumeVertex)),
                  vertices_.data(), GL_STREAM_DRAW);
  // Premultiplied: one equation for flame, which adds its light, and for smoke, which hides.
  gl_->Enable(GL_BLEND);
  gl_->BlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  gl_->DepthMask(GL_FALSE);
  gl_->DrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(vertices_.size()));
  gl_->DepthMask(GL_TRUE);
  gl_->Disable(GL_BLEND);
  return static_cast<int>(vertices_.size() / 3);
}

}  // namespace eod::sim
