#include <array>
#include <memory>
#include <stdexcept>
#include <string>

#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <dlfcn.h>
#include <fmt/format.h>

#include "sim/camera/gl_context.h"

namespace eod::sim {
namespace {

[[noreturn]] void Refuse(const std::string& why) {
  throw std::runtime_error(
      fmt::format("cameras: {}; install libegl1, or run with --gl osmesa or --no-cameras", why));
}

struct CloseLibrary {
  void operator()(void* library) const { dlclose(library); }
};

/// The functions of libEGL, opened by name: nothing links it.
class EglLibrary {
 public:
  EglLibrary() : library_(dlopen("libEGL.so.1", RTLD_NOW | RTLD_LOCAL)) {
    if (library_ == nullptr) Refuse("libEGL.so.1 cannot be opened");
    Find("eglGetProcAddress", get_proc_address);
    Find("eglInitialize", initialize);
    Find("eglTerminate", terminate);
    Find("eglBindAPI", bind_api);
    Find("eglChooseConfig", choose_config);
    Find("eglCreateContext", create_context);
    Find("eglDestroyContext", destroy_context);
    Find("eglMakeCurrent", make_current);
    // An extension of the client, so it is asked for through EGL itself.
    get_platform_display = reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(
        get_proc_address("eglGetPlatformDisplayEXT"));
    if (get_platform_display == nullptr) Refuse("libEGL lacks eglGetPlatformDisplayEXT");
  }

  PFNEGLGETPROCADDRESSPROC get_proc_address = nullptr;
  PFNEGLINITIALIZEPROC initialize = nullptr;
  PFNEGLTERMINATEPROC terminate = nullptr;
  PFNEGLBINDAPIPROC bind_api = nullptr;
  PFNEGLCHOOSECONFIGPROC choose_config = nullptr;
  PFNEGLCREATECONTEXTPROC create_context = nullptr;
  PFNEGLDESTROYCONTEXTPROC destroy_context = nullptr;
  PFNEGLMAKECURRENTPROC make_current = nullptr;
  PFNEGLGETPLATFORMDISPLAYEXTPROC get_platform_display = nullptr;

 private:
  template <typename Function>
  void Find(const char* name, Function& function) {
    function = reinterpret_cast<Function>(dlsym(library_.get(), name));
    if (function == nullptr) Refuse(fmt::format("libEGL lacks {}", name));
  }

  std::unique_ptr<void, CloseLibrary> library_;
};

/// One for the process, and for good: drivers do not like to be unloaded.
const EglLibrary& TheEglLibrary() {
  static const EglLibrary* library = new EglLibrary;
  return *library;
}

class EglGlContext final : public GlContext {
 public:
  EglGlContext() : egl_(TheEglLibrary()) {
    display_ = egl_.get_platform_display(EGL_PLATFORM_SURFACELESS_MESA,
                                         reinterpret_cast<void*>(EGL_DEFAULT_DISPLAY), nullptr);
    if (display_ == EGL_NO_DISPLAY || egl_.initialize(display_, nullptr, nullptr) == EGL_FALSE) {
      Refuse("EGL has no surfaceless platform");
    }
    context_ = Create();
    EglGlContext::MakeCurrent();
    gl_ = LoadGlFunctions(egl_.get_proc_address);
  }

  // The display is shared by all contexts of the process, so it is left open.
  ~EglGlContext() override {
    egl_.make_current(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    egl_.destroy_context(display_, context_);
  }
  EglGlContext(const EglGlContext&) = delete;
  EglGlContext& operator=(const EglGlContext&) = delete;

  const GlFunctions& gl() const override { return gl_; }

  void MakeCurrent() override {
    if (egl_.make_current(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_) == EGL_FALSE) {
      Refuse("EGL makes no context current without a surface");
    }
  }

 private:
  EGLContext Create() const {
    constexpr std::array kConfig{EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_RENDERABLE_TYPE,
                                 EGL_OPENGL_BIT, EGL_NONE};
    constexpr std::array kContext{EGL_CONTEXT_MAJOR_VERSION,
                                  3,
                                  EGL_CONTEXT_MINOR_VERSION,
                                  3,
                                  EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                  EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                  EGL_NONE};
    EGLConfig config = nullptr;
    EGLint configs = 0;
    if (egl_.bind_api(EGL_OPENGL_API) == EGL_FALSE ||
        egl_.choose_config(display_, kConfig.data(), &config, 1, &configs) == EGL_FALSE ||
        configs < 1) {
      Refuse("EGL has no configuration for OpenGL");
    }
    const EGLContext context =
        egl_.create_context(display_, config, EGL_NO_CONTEXT, kContext.data());
    if (context == EGL_NO_CONTEXT) Refuse("EGL gives no OpenGL 3.3 core context");
    return context;
  }

  const EglLibrary& egl_;
  EGLDisplay display_ = EGL_NO_DISPLAY;
  EGLContext context_ = EGL_NO_CONTEXT;
  GlFunctions gl_;
};

}  // namespace

std::unique_ptr<GlContext> MakeEglContext() { return std::make_unique<EglGlContext>(); }

std::unique_ptr<GlContext> MakeGlContext(GlBackend backend) {
  return backend == GlBackend::kEgl ? MakeEglContext() : MakeOsMesaContext();
}

}  // namespace eod::sim
