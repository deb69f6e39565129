#include <array>
#include <cstdint>
#include <memory>
#include <stdexcept>

// First: the old header that OSMesa includes would hide the types of the functions.
#include <GL/glcorearb.h>
#include <GL/osmesa.h>

#include "sim/camera/gl_context.h"

namespace eod::sim {
namespace {

struct DestroyOsMesa {
  void operator()(OSMesaContext context) const { OSMesaDestroyContext(context); }
};

class OsMesaGlContext final : public GlContext {
 public:
  OsMesaGlContext() : context_(Create()) {
    OsMesaGlContext::MakeCurrent();
    gl_ = LoadGlFunctions(&OSMesaGetProcAddress);
  }

  const GlFunctions& gl() const override { return gl_; }

  void MakeCurrent() override {
    if (context_ == nullptr || OSMesaMakeCurrent(context_.get(), dummy_.data(), GL_UNSIGNED_BYTE,
                                                 kSide, kSide) == GL_FALSE) {
      throw std::runtime_error(
          "cameras: OSMesa gives no OpenGL 3.3 core context; install libosmesa6 22.3 or newer, or "
          "run with --no-cameras");
    }
  }

 private:
  static constexpr int kSide = 16;

  static OSMesaContext Create() {
    constexpr std::array kAttributes{OSMESA_FORMAT,
                                     OSMESA_RGBA,
                                     OSMESA_PROFILE,
                                     OSMESA_CORE_PROFILE,
                                     OSMESA_CONTEXT_MAJOR_VERSION,
                                     3,
                                     OSMESA_CONTEXT_MINOR_VERSION,
                                     3,
                                     0};
    return OSMesaCreateContextAttribs(kAttributes.data(), nullptr);
  }

  // Declared before the context, so that it outlives it.
  std::array<uint8_t, 4UL * kSide * kSide> dummy_{};
  std::unique_ptr<std::remove_pointer_t<OSMesaContext>, DestroyOsMesa> context_;
  GlFunctions gl_;
};

}  // namespace

std::unique_ptr<GlContext> MakeOsMesaContext() { return std::make_unique<OsMesaGlContext>(); }

}  // namespace eod::sim
