// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/render/offscreen.h"

#include <QCoreApplication>
#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <algorithm>
#include <string_view>

#include "app/render/gl_support.h"

#ifdef TOILE_EGL
#include <EGL/egl.h>
#include <EGL/eglext.h>
#endif

namespace toile::app {

namespace {

class QtContext : public OffscreenContext {
public:
    /// @return whether it is current and has the required version
    bool make() {
        context_.setFormat(sceneSurfaceFormat());
        if (!context_.create()) {
            return false;
        }
        surface_.setFormat(context_.format());
        surface_.create();
        return context_.makeCurrent(&surface_) && hasGl();
    }
    ~QtContext() override { context_.doneCurrent(); }

private:
    QOffscreenSurface surface_;
    QOpenGLContext context_;
};

#ifdef TOILE_EGL

class EglContext : public OffscreenContext {
public:
    EglContext(EGLDisplay display, EGLContext context) : display_(display), context_(context) {}
    ~EglContext() override {
        eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
        eglDestroyContext(display_, context_);
        // Do not terminate the display: the whole process shares it.
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
    // Core in EGL 1.5, an extension before that.
    const auto display = reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(
        eglGetProcAddress("eglGetPlatformDisplayEXT"));
    return display ? display(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr)
                   : EGL_NO_DISPLAY;
}

#endif

constexpr int kFlags = 8;  ///< clears of the error flag, more than OpenGL has flags

GLuint makeRenderbuffer(int samples, GLenum format, int width, int height) {
    GLuint buffer = 0;
    glGenRenderbuffers(1, &buffer);
    glBindRenderbuffer(GL_RENDERBUFFER, buffer);
    glRenderbufferStorageMultisample(GL_RENDERBUFFER, samples, format, width, height);
    return buffer;
}

}  // namespace

std::unique_ptr<OffscreenContext> makeOffscreenContext(QString& problem) {
    if (hasScreen()) {
        auto context = std::make_unique<QtContext>();
        if (context->make()) {
            return context;
        }
    }
    auto context = makeEglContext();
    if (!context || !hasGl()) {
        problem = QCoreApplication::translate(
            "OffscreenContext",
            "pictures need OpenGL 3.3, but neither a display nor a driver without display offers "
            "it; use xvfb-run, or install the package libgl1-mesa-dri");
        return nullptr;
    }
    return context;
}

std::unique_ptr<OffscreenContext> makeEglContext() {
#ifdef TOILE_EGL
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
#else
    return nullptr;
#endif
}

bool isEglCurrent() {
#ifdef TOILE_EGL
    return eglGetCurrentContext() != EGL_NO_CONTEXT;
#else
    return false;
#endif
}

Framebuffer::~Framebuffer() {
    freeTarget(drawn_);
    freeTarget(resolved_);
}

void Framebuffer::freeTarget(Target& target) {
    glDeleteFramebuffers(1, &target.framebuffer);
    glDeleteRenderbuffers(1, &target.colour);
    glDeleteRenderbuffers(1, &target.depth);
    target = {};
}

bool Framebuffer::makeTarget(Target& target, int samples, bool withDepth) {
    glGenFramebuffers(1, &target.framebuffer);
    glBindFramebuffer(GL_FRAMEBUFFER, target.framebuffer);
    target.colour = makeRenderbuffer(samples, GL_RGBA8, width_, height_);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, target.colour);
    if (withDepth) {
        target.depth = makeRenderbuffer(samples, GL_DEPTH_COMPONENT24, width_, height_);
        glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER,
                                  target.depth);
    }
    return glGetError() == GL_NO_ERROR &&
           glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
}

bool Framebuffer::make(int width, int height) {
    GLint most = 0, samples = 0;
    glGetIntegerv(GL_MAX_RENDERBUFFER_SIZE, &most);
    glGetIntegerv(GL_MAX_SAMPLES, &samples);
    if (width < 1 || height < 1 || width > most || height > most) {
        return false;
    }
    width_ = width;
    height_ = height;
    for (int i = 0; i < kFlags && glGetError() != GL_NO_ERROR; ++i) {
        // Discard earlier errors.
    }
    return makeTarget(resolved_, 0, false) &&
           makeTarget(drawn_, std::min(samplesPerPixel(), samples), true);
}

QImage Framebuffer::read() {
    glBindFramebuffer(GL_READ_FRAMEBUFFER, drawn_.framebuffer);
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, resolved_.framebuffer);
    glBlitFramebuffer(0, 0, width_, height_, 0, 0, width_, height_, GL_COLOR_BUFFER_BIT,
                      GL_NEAREST);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, resolved_.framebuffer);
    QImage image(width_, height_, QImage::Format_RGBX8888);
    if (image.isNull()) {
        return image;
    }
    glPixelStorei(GL_PACK_ALIGNMENT, 4);
    glReadPixels(0, 0, width_, height_, GL_RGBA, GL_UNSIGNED_BYTE, image.bits());
    glBindFramebuffer(GL_FRAMEBUFFER, drawn_.framebuffer);
    return image.mirrored();
}

}  // namespace toile::app
