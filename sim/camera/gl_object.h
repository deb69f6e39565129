#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "sim/camera/gl_functions.h"

namespace eod::sim {

/// Owns one OpenGL object (buffer, texture, ...) and deletes it. Move-only.
class GlObject {
 public:
  using Destroy = void (*)(const GlFunctions&, GLuint);

  GlObject() = default;
  GlObject(const GlFunctions& gl, GLuint id, Destroy destroy);
  GlObject(GlObject&& other) noexcept;
  GlObject& operator=(GlObject&& other) noexcept;
  GlObject(const GlObject&) = delete;
  GlObject& operator=(const GlObject&) = delete;
  ~GlObject();

  GLuint id() const { return id_; }

 private:
  const GlFunctions* gl_ = nullptr;
  GLuint id_ = 0;
  Destroy destroy_ = nullptr;
};

GlObject MakeBuffer(const GlFunctions& gl);
GlObject MakeVertexArray(const GlFunctions& gl);
GlObject MakeTexture(const GlFunctions& gl);
GlObject MakeFramebuffer(const GlFunctions& gl);
GlObject MakeRenderbuffer(const GlFunctions& gl);

/// Compiles and links. `defines` go behind the #version line of both stages. Throws
/// std::runtime_error with the compiler's first line.
GlObject MakeProgram(const GlFunctions& gl, std::string_view name, std::string_view vertex,
                     std::string_view fragment, std::string_view defines = "");

/// Place within a buffer, as OpenGL wants it: `bytes` dressed up as a pointer.
const void* BufferOffset(size_t bytes);

}  // namespace eod::sim
