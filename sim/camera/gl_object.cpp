#include "sim/camera/gl_object.h"

#include <array>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

namespace eod::sim {
namespace {

std::string FirstLine(const char* log) {
  const std::string_view text(log);
  return std::string(text.substr(0, text.find('\n')));
}

GlObject CompileStage(const GlFunctions& gl, GLenum stage, std::string_view name,
                      std::string_view source, std::string_view defines) {
  GlObject shader(gl, gl.CreateShader(stage),
                  [](const GlFunctions& table, GLuint id) { table.DeleteShader(id); });
  const std::string text = fmt::format("#version 330 core\n{}\n{}", defines, source);
  const char* pointer = text.c_str();
  gl.ShaderSource(shader.id(), 1, &pointer, nullptr);
  gl.CompileShader(shader.id());
  GLint compiled = GL_FALSE;
  gl.GetShaderiv(shader.id(), GL_COMPILE_STATUS, &compiled);
  if (compiled == GL_FALSE) {
    std::array<char, 1024> log{};
    gl.GetShaderInfoLog(shader.id(), static_cast<GLsizei>(log.size()), nullptr, log.data());
    throw std::runtime_error(fmt::format("cameras: shader {}: {}", name, FirstLine(log.data())));
  }
  return shader;
}

}  // namespace

GlObject::GlObject(const GlFunctions& gl, GLuint id, Destroy destroy)
    : gl_(&gl), id_(id), destroy_(destroy) {}

GlObject::GlObject(GlObject&& other) noexcept
    : gl_(other.gl_), id_(std::exchange(other.id_, 0)), destroy_(other.destroy_) {}

GlObject& GlObject::operator=(GlObject&& other) noexcept {
  std::swap(gl_, other.gl_);
  std::swap(id_, other.id_);
  std::swap(destroy_, other.destroy_);
  return *this;
}

GlObject::~GlObject() {
  if (id_ != 0) destroy_(*gl_, id_);
}

GlObject MakeBuffer(const GlFunctions& gl) {
  GLuint id = 0;
  gl.GenBuffers(1, &id);
  return {gl, id, [](const GlFunctions& table, GLuint old) { table.DeleteBuffers(1, &old); }};
}

GlObject MakeVertexArray(const GlFunctions& gl) {
  GLuint id = 0;
  gl.GenVertexArrays(1, &id);
  return {gl, id, [](const GlFunctions& table, GLuint old) { table.DeleteVertexArrays(1, &old); }};
}

GlObject MakeTexture(const GlFunctions& gl) {
  GLuint id = 0;
  gl.GenTextures(1, &id);
  return {gl, id, [](const GlFunctions& table, GLuint old) { table.DeleteTextures(1, &old); }};
}

GlObject MakeFramebuffer(const GlFunctions& gl) {
  GLuint id = 0;
  gl.GenFramebuffers(1, &id);
  return {gl, id, [](const GlFunctions& table, GLuint old) { table.DeleteFramebuffers(1, &old); }};
}

GlObject MakeRenderbuffer(const GlFunctions& gl) {
  GLuint id = 0;
  gl.GenRenderbuffers(1, &id);
  return {gl, id, [](const GlFunctions& table, GLuint old) { table.DeleteRenderbuffers(1, &old); }};
}

GlObject MakeProgram(const GlFunctions& gl, std::string_view name, std::string_view vertex,
                     std::string_view fragment, std::string_view defines) {
  const GlObject vertex_stage = CompileStage(gl, GL_VERTEX_SHADER, name, vertex, defines);
  const GlObject fragment_stage = CompileStage(gl, GL_FRAGMENT_SHADER, name, fragment, defines);
  GlObject program(gl, gl.CreateProgram(),
                   [](const GlFunctions& table, GLuint id) { table.DeleteProgram(id); });
  gl.AttachShader(program.id(), vertex_stage.id());
  gl.AttachShader(program.id(), fragment_stage.id());
  gl.LinkProgram(program.id());
  GLint linked = GL_FALSE;
  gl.GetProgramiv(program.id(), GL_LINK_STATUS, &linked);
  if (linked == GL_FALSE) {
    std::array<char, 1024> log{};
    gl.GetProgramInfoLog(program.id(), static_cast<GLsizei>(log.size()), nullptr, log.data());
    throw std::runtime_error(fmt::format("cameras: program {}: {}", name, FirstLine(log.data())));
  }
  return program;
}

const void* BufferOffset(size_t bytes) {
  return reinterpret_cast<const void*>(bytes);  // NOLINT(performance-no-int-to-ptr): the API's way
}

}  // namespace eod::sim
