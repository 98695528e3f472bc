// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/render/offscreen_context.h"

#include <QCoreApplication>
#include <QOffscreenSurface>
#include <QOpenGLContext>

#include "app/render/gl_support.h"

namespace toile {

namespace {

class QtContext : public OffscreenContext {
public:
    /// @return whether it is current and good enough
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
            "pictures need OpenGL 3.3, and there is neither a display that offers it nor a driver "
            "that does without one; xvfb-run lends a display, and the package libgl1-mesa-dri "
            "has such a driver");
        return nullptr;
    }
    return context;
}

}  // namespace toile
