// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QImage>
#include <QString>
#include <memory>

#include "app/render/gl.h"

namespace toile::app {

/// An OpenGL 3.3 context for drawing without a window. It stays current on the creating thread
/// until destroyed.
class OffscreenContext {
public:
    virtual ~OffscreenContext() = default;
};

/// Creates a context and makes it current: on Qt's display if that offers OpenGL, else one that
/// needs no display. Requires a QGuiApplication; GUI thread.
/// @param problem  receives a message if null is returned
std::unique_ptr<OffscreenContext> makeOffscreenContext(QString& problem);

/// Creates an OpenGL 3.3 core context without display or surface, current on this thread. Uses EGL
/// with Mesa's surfaceless platform, on a graphics card if available, else in software. Null if
/// that is not possible or Toile was built without EGL.
std::unique_ptr<OffscreenContext> makeEglContext();

bool isEglCurrent();

/// A render target without a window: colour with `samplesPerPixel()`, and depth.
/// All calls, including the destructor, need the same context current.
class Framebuffer {
public:
    Framebuffer() = default;
    ~Framebuffer();
    Framebuffer(const Framebuffer&) = delete;
    Framebuffer& operator=(const Framebuffer&) = delete;

    /// Creates the buffers and binds them for drawing. Call once.
    /// @return false if they exceed the driver's limits or its memory
    bool make(int width, int height);
    /// The drawn image, opaque, top row first.
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
