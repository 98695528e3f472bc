// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/render/offscreen_context.h"

#ifdef TOILE_EGL
#include <string_view>

#include <EGL/egl.h>
#include <EGL/eglext.h>
#endif

namespace toile {

#ifdef TOILE_EGL

namespace {

class EglContext : public OffscreenContext {
public:
    EglContext(EGLDisplay display, EGLContext context) : display_(display), context_(context) {}
    ~EglContext() override {
        eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
        eglDestroyContext(display_, context_);
        // The display stays initialised: it is one for the whole process.
    }

private:
    EGLDisplay display_;
    EGLContext context_;
};

bool has(EGLDisplay display, std::string_view extension) {
    const char* all = eglQueryString(display, EGL_EXTENSIONS);
    std::string_view rest = all ? all : "";
    while (!rest.empty()) {
        const std::size_t end = std::min(rest.find(' '), rest.size());
        if (rest.substr(0, end) == extension) {
            return true;
        }
        rest.remove_prefix(std::min(end + 1, rest.size()));
    }
    return false;
}

EGLDisplay surfacelessDisplay() {
    if (!has(EGL_NO_DISPLAY, "EGL_MESA_platform_surfaceless")) {
        return EGL_NO_DISPLAY;
    }
    // Of EGL 1.5, or an extension of the version before.
    const auto display = reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(
        eglGetProcAddress("eglGetPlatformDisplayEXT"));
    return display ? display(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr)
                   : EGL_NO_DISPLAY;
}

}  // namespace

std::unique_ptr<OffscreenContext> makeEglContext() {
    const EGLDisplay display = surfacelessDisplay();
    if (display == EGL_NO_DISPLAY || !eglInitialize(display, nullptr, nullptr) ||
        !has(display, "EGL_KHR_surfaceless_context") || !eglBindAPI(EGL_OPENGL_API)) {
        return nullptr;
    }
    const EGLint wanted[] = {EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_SURFACE_TYPE, EGL_PBUFFER_BIT,
                             EGL_NONE};
    EGLConfig config = nullptr;
    EGLint count = 0;
    if (!eglChooseConfig(display, wanted, &config, 1, &count) || count < 1) {
        return nullptr;
    }
    const EGLint attributes[] = {EGL_CONTEXT_MAJOR_VERSION,
                                 3,
                                 EGL_CONTEXT_MINOR_VERSION,
                                 3,
                                 EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                 EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                 EGL_NONE};
    const EGLContext context = eglCreateContext(display, config, EGL_NO_CONTEXT, attributes);
    if (context == EGL_NO_CONTEXT) {
        return nullptr;
    }
    auto made = std::make_unique<EglContext>(display, context);
    if (!eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context)) {
        return nullptr;
    }
    return made;
}

bool isEglCurrent() {
    return eglGetCurrentContext() != EGL_NO_CONTEXT;
}

#else

std::unique_ptr<OffscreenContext> makeEglContext() {
    return nullptr;
}

bool isEglCurrent() {
    return false;
}

#endif

}  // namespace toile
