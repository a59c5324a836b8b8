#include "ui/gl/headless_context.hpp"

#include <EGL/egl.h>
#include <EGL/eglext.h>

#include <array>

namespace ui {
namespace {

/// The display is shared by all contexts of the process, so it is not terminated with one of them.
class HeadlessContext final : public Context {
  public:
    HeadlessContext(EGLDisplay display, EGLContext context) : display_(display), context_(context) {}
    ~HeadlessContext() override {
        eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
        eglDestroyContext(display_, context_);
    }

  private:
    EGLDisplay display_;
    EGLContext context_;
};

core::Unexpected no_display(const char* why) {
    return core::unexpected(core::ErrorCode::NoDisplay,
                            std::string("pictures cannot be drawn without a screen, because ") + why +
                                "; install libegl1, libgles2 and libgl1-mesa-dri");
}

}  // namespace

core::Result<std::unique_ptr<Context>> make_headless_context() {
    const auto get_display =
        reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(eglGetProcAddress("eglGetPlatformDisplayEXT"));
    if (get_display == nullptr) return no_display("EGL offers no platform displays");
    EGLDisplay display = get_display(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
    EGLint major = 0, minor = 0;
    if (display == EGL_NO_DISPLAY || eglInitialize(display, &major, &minor) == EGL_FALSE) {
        return no_display("EGL has no surfaceless platform");
    }
    eglBindAPI(EGL_OPENGL_ES_API);
    const std::array<EGLint, 5> wanted{EGL_RENDERABLE_TYPE, EGL_OPENGL_ES3_BIT, EGL_SURFACE_TYPE, EGL_PBUFFER_BIT,
                                       EGL_NONE};
    EGLConfig config = nullptr;
    EGLint count = 0;
    eglChooseConfig(display, wanted.data(), &config, 1, &count);
    const std::array<EGLint, 5> version{EGL_CONTEXT_MAJOR_VERSION, 3, EGL_CONTEXT_MINOR_VERSION, 0, EGL_NONE};
    EGLContext context =
        eglCreateContext(display, count > 0 ? config : EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, version.data());
    if (context == EGL_NO_CONTEXT) return no_display("there is no OpenGL ES 3");
    if (eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context) == EGL_FALSE) {
        eglDestroyContext(display, context);
        return no_display("the OpenGL ES context cannot be used without a surface");
    }
    return std::unique_ptr<Context>(std::make_unique<HeadlessContext>(display, context));
}

}  // namespace ui
