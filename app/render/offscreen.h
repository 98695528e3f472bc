// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QImage>
#include <QString>
#include <memory>

#include "app/render/gl.h"

namespace toile::app {

/// A context of OpenGL 3.3 to draw in without a window. It is current on the thread that made it
/// until it goes.
class OffscreenContext {
public:
    virtual ~OffscreenContext() = default;
};

/// Makes a context and makes it current: of the display where Qt has one that offers OpenGL, else
/// one that needs no display. Needs a QGuiApplication; GUI thread.
/// @param problem  receives a sentence for a person where null is returned
std::unique_ptr<OffscreenContext> makeOffscreenContext(QString& problem);

/// A context of OpenGL 3.3 core that needs neither display nor surface, made current on this thread
/// (EGL with Mesa's surfaceless platform: a graphics card where one may be used, else the
/// processor). Null where there is no such thing, or Toile was built without EGL.
std::unique_ptr<OffscreenContext> makeEglContext();

/// Whether a context of EGL is current on this thread.
bool isEglCurrent();

/// Something to draw on that is no window: colour with `samplesPerPixel()`, and depth.
/// Every call, the destructor's too, needs the same context current.
class Framebuffer {
public:
    Framebuffer() = default;
    ~Framebuffer();
    Framebuffer(const Framebuffer&) = delete;
    Framebuffer& operator=(const Framebuffer&) = delete;

    /// Makes the buffers and binds them for drawing; once.
    /// @return false where they are larger than the driver allows, or there is no room for them
    bool make(int width, int height);
    /// What has been drawn, opaque, top row first.
    QImage read();

private:
    struct Target {
        GLuint framebuffer = 0, colour = 0, depth = 0;
    };
    bool makeTarget(Target& target, int samples, bool withDepth);
    void freeTarget(Target& target);

    Target drawn_, resolved_;
    int width_ = 0, height_ = 0;
};

}  // namespace toile::app
