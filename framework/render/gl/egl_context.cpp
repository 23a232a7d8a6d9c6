// SPDX-License-Identifier: MIT
#include "render/gl/egl_context.hpp"

#include <EGL/egl.h>
#include <EGL/eglext.h>

#include <array>
#include <stdexcept>

namespace rigor {
namespace {

class EglContext final : public Context {
public:
    EglContext()
    {
        display_ = eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, nullptr, nullptr);
        if (display_ == EGL_NO_DISPLAY || !eglInitialize(display_, nullptr, nullptr))
            throw std::runtime_error("EGL has no surfaceless display");
        eglBindAPI(EGL_OPENGL_API);
        const std::array<EGLint, 7> wanted = {EGL_CONTEXT_MAJOR_VERSION,
                                              3,
                                              EGL_CONTEXT_MINOR_VERSION,
                                              3,
                                              EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                              EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                              EGL_NONE};
        context_ = eglCreateContext(display_, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, wanted.data());
        if (context_ == EGL_NO_CONTEXT) throw std::runtime_error("EGL has no OpenGL 3.3 core");
    }
    // The display is left open, since other renderers of the process share it.
    ~EglContext() override
    {
        eglBindAPI(EGL_OPENGL_API);
        eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
        eglDestroyContext(display_, context_);
    }

    void make_current() override
    {
        eglBindAPI(EGL_OPENGL_API);
        if (!eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_))
            throw std::runtime_error("EGL refuses its own context");
    }
    const char* name() const override { return "EGL"; }

private:
    EGLDisplay display_ = EGL_NO_DISPLAY;
    EGLContext context_ = EGL_NO_CONTEXT;
};

} // namespace

std::unique_ptr<Context> make_egl_context()
{
    return std::make_unique<EglContext>();
}

} // namespace rigor
