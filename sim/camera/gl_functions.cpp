#include "sim/camera/gl_functions.h"

#include <stdexcept>
#include <string>

#include <fmt/format.h>

namespace eod::sim {

GlFunctions LoadGlFunctions(const std::function<void (*(const char*))()>& lookup) {
  GlFunctions gl;
#define EOD_GL_LOAD(type, name)                                                     \
  gl.name = reinterpret_cast<type>(lookup("gl" #name));                             \
  if (gl.name == nullptr) {                                                         \
    throw std::runtime_error(                                                       \
        "cameras: the OpenGL library lacks gl" #name                                \
        "; install libosmesa6 and libegl1 of Debian 12, or run with --no-cameras"); \
  }
  EOD_GL_FUNCTIONS(EOD_GL_LOAD)
#undef EOD_GL_LOAD

  GLint major = 0;
  GLint minor = 0;
  gl.GetIntegerv(GL_MAJOR_VERSION, &major);
  gl.GetIntegerv(GL_MINOR_VERSION, &minor);
  if (major * 10 + minor < 33) {
    throw std::runtime_error(
        fmt::format("cameras: OpenGL {}.{} found, 3.3 needed; is libGL linked before libOSMesa?",
                    major, minor));
  }
  return gl;
}

}  // namespace eod::sim
