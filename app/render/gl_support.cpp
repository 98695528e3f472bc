// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/render/gl_support.h"

#include <QGuiApplication>
#include <QOffscreenSurface>
#include <QOpenGLContext>

#include "app/render/gl.h"
#include "app/render/offscreen.h"

namespace toile::app {

int samplesPerPixel() {
    constexpr int kUsual = 4;
    bool isNumber = false;
    const int said = qEnvironmentVariableIntValue("TOILE_SAMPLES", &isNumber);
    return isNumber && said > 0 ? said : kUsual;
}

QSurfaceFormat sceneSurfaceFormat() {
    QSurfaceFormat format;
    format.setRenderableType(QSurfaceFormat::OpenGL);
    format.setProfile(QSurfaceFormat::CoreProfile);
    format.setVersion(3, 3);
    format.setDepthBufferSize(24);
    format.setStencilBufferSize(8);  // for QPainter over the scene
    format.setSamples(samplesPerPixel());
    return format;
}

bool hasScreen() {
    const QString platform = QGuiApplication::platformName();
    return platform != "offscreen" && platform != "minimal" && platform != "vnc" &&
           platform != "linuxfb";
}

QString glProblem() {
    QOpenGLContext context;
    context.setFormat(sceneSurfaceFormat());
    if (!hasScreen() || !context.create()) {
        return QCoreApplication::translate(
            "GlSupport",
            "The views need OpenGL 3.3, which is not available. Flattening and export still work. "
            "Update the graphics driver to get the views.");
    }
    QOffscreenSurface surface;
    surface.setFormat(context.format());
    surface.create();
    if (!context.makeCurrent(&surface) || !hasGl()) {
        const auto [major, minor] = context.format().version();
        return QCoreApplication::translate(
                   "GlSupport",
                   "The views need OpenGL 3.3, but the graphics driver only offers %1.%2. "
                   "Flattening and export still work. Update the driver to get the views.")
            .arg(major)
            .arg(minor);
    }
    context.doneCurrent();
    return {};
}

QString glDescription() {
    QOpenGLContext context;
    context.setFormat(sceneSurfaceFormat());
    if (!hasScreen() || !context.create()) {
        return {};
    }
    QOffscreenSurface surface;
    surface.setFormat(context.format());
    surface.create();
    if (!context.makeCurrent(&surface)) {
        return {};
    }
    const auto text = [](GLenum name) {
        return QString::fromUtf8(reinterpret_cast<const char*>(glGetString(name)));
    };
    QString description = text(GL_VERSION) + ", " + text(GL_RENDERER);
    context.doneCurrent();
    return description;
}

bool hasGl() {
    return (QOpenGLContext::currentContext() || isEglCurrent()) && epoxy_is_desktop_gl() &&
           epoxy_gl_version() >= 33;
}

void beginBlending() {
    glEnable(GL_BLEND);
    // Keep the framebuffer's alpha at 1, or the window would be translucent.
    glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
}

}  // namespace toile::app
