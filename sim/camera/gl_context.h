#pragma once

#include <cstdint>
#include <memory>

#include "sim/camera/gl_functions.h"

namespace eod::sim {

/// An off-screen OpenGL 3.3 core context: the seam between the cameras and the system's OpenGL.
/// It is current on the thread that made it, and must be used and destroyed there, as must its
/// objects.
class GlContext {
 public:
  virtual ~GlContext() = default;
  virtual const GlFunctions& gl() const = 0;
  /// Makes it current again after another context of the same thread. Throws std::runtime_error.
  virtual void MakeCurrent() = 0;
};

/// Where OpenGL comes from.
enum class GlBackend : uint8_t {
  kOsMesa,  ///< plain memory, rendered by the CPU (Mesa's llvmpipe)
  kEgl      ///< EGL without a surface: a GPU's driver if there is one, else llvmpipe too
};

/// Context in plain memory. Everything is drawn into framebuffer objects; its own buffer is a
/// dummy. Throws std::runtime_error with one line if OSMesa gives no OpenGL 3.3.
std::unique_ptr<GlContext> MakeOsMesaContext();

/// Context of EGL's surfaceless platform. libEGL is looked for when this is called: a machine
/// without it runs all the rest. Throws std::runtime_error with one line if it is not there or
/// gives no OpenGL 3.3.
std::unique_ptr<GlContext> MakeEglContext();

/// One of the two above.
std::unique_ptr<GlContext> MakeGlContext(GlBackend backend);

}  // namespace eod::sim
