#include "sim/camera/render_target.h"

#include <array>
#include <stdexcept>

#include <fmt/format.h>

namespace eod::sim {
namespace {

void CheckComplete(const GlFunctions& gl, int width, int height) {
  const GLenum status = gl.CheckFramebufferStatus(GL_FRAMEBUFFER);
  if (status != GL_FRAMEBUFFER_COMPLETE) {
    throw std::runtime_error(fmt::format("cameras: OpenGL refuses a picture of {} x {} (0x{:x})",
                                         width, height, status));
  }
}

GlObject MakeStorage(const GlFunctions& gl, GLenum format, int width, int height) {
  GlObject buffer = MakeRenderbuffer(gl);
  gl.BindRenderbuffer(GL_RENDERBUFFER, buffer.id());
  gl.RenderbufferStorage(GL_RENDERBUFFER, format, width, height);
  return buffer;
}

GlObject Upload(const GlFunctions& gl, const Image& image) {
  GlObject texture = MakeTexture(gl);
  gl.BindTexture(GL_TEXTURE_2D, texture.id());
  gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, image.width, image.height, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                image.rgba.data());
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  return texture;
}

}  // namespace

RenderTarget::RenderTarget(const GlFunctions& gl, int width, int height)
    : gl_(&gl),
      width_(width),
      height_(height),
      colour_(MakeStorage(gl, GL_RGBA8, width, height)),
      depth_(MakeStorage(gl, GL_DEPTH_COMPONENT24, width, height)),
      framebuffer_(MakeFramebuffer(gl)) {
  gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer_.id());
  gl.FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, colour_.id());
  gl.FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, depth_.id());
  CheckComplete(gl, width, height);
}

void RenderTarget::Bind(const PixelArea& area) const {
  gl_->BindFramebuffer(GL_FRAMEBUFFER, framebuffer_.id());
  gl_->Viewport(area.x, area.y, area.width, area.height);
  if (area == whole()) {
    gl_->Disable(GL_SCISSOR_TEST);
  } else {
    gl_->Enable(GL_SCISSOR_TEST);
    gl_->Scissor(area.x, area.y, area.width, area.height);
  }
}

void RenderTarget::Read(std::vector<uint8_t>& pixels) const {
  pixels.resize(static_cast<size_t>(width_) * static_cast<size_t>(height_) * 4);
  gl_->BindFramebuffer(GL_FRAMEBUFFER, framebuffer_.id());
  gl_->ReadPixels(0, 0, width_, height_, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
}

ShadowMap::ShadowMap(const GlFunctions& gl)
    : gl_(&gl), texture_(MakeTexture(gl)), framebuffer_(MakeFramebuffer(gl)) {
  constexpr std::array kFullyLit{1.0F, 1.0F, 1.0F, 1.0F};
  gl.BindTexture(GL_TEXTURE_2D, texture_.id());
  gl.TexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT24, kSide, kSide, 0, GL_DEPTH_COMPONENT,
                GL_UNSIGNED_INT, nullptr);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_BORDER);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_BORDER);
  gl.TexParameterfv(GL_TEXTURE_2D, GL_TEXTURE_BORDER_COLOR, kFullyLit.data());
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_FUNC, GL_LEQUAL);
  gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer_.id());
  gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, texture_.id(), 0);
  gl.DrawBuffer(GL_NONE);
  gl.ReadBuffer(GL_NONE);
  CheckComplete(gl, kSide, kSide);
}

void ShadowMap::Bind() const {
  gl_->BindFramebuffer(GL_FRAMEBUFFER, framebuffer_.id());
  gl_->Viewport(0, 0, kSide, kSide);
  gl_->Disable(GL_SCISSOR_TEST);
}

GlObject UploadSurface(const GlFunctions& gl, const Image& image) {
  GlObject texture = Upload(gl, image);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_NEAREST);
  gl.TexParameterf(GL_TEXTURE_2D, GL_TEXTURE_LOD_BIAS, -0.4F);
  gl.GenerateMipmap(GL_TEXTURE_2D);
  return texture;
}

GlObject UploadPanorama(const GlFunctions& gl, const Image& image) {
  GlObject texture = Upload(gl, image);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  return texture;
}

}  // namespace eod::sim
