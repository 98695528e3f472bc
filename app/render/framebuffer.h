// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QImage>

#include "app/render/gl.h"

namespace toile {

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

}  // namespace toile
