// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/render/gl_support.h"

#include <QCoreApplication>
#include <QFile>
#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QOpenGLShaderProgram>
#include <QOpenGLVersionFunctionsFactory>

namespace toile {

namespace {

QOpenGLShader::ShaderType stageOf(std::string_view file) {
    if (file.ends_with(".vert")) {
        return QOpenGLShader::Vertex;
    }
    return file.ends_with(".geom") ? QOpenGLShader::Geometry : QOpenGLShader::Fragment;
}

}  // namespace

QSurfaceFormat sceneSurfaceFormat() {
    QSurfaceFormat format;
    format.setRenderableType(QSurfaceFormat::OpenGL);
    format.setProfile(QSurfaceFormat::CoreProfile);
    format.setVersion(3, 3);
    format.setDepthBufferSize(24);
    format.setStencilBufferSize(8);  // for QPainter over the scene
    format.setSamples(4);
    return format;
}

QString glProblem() {
    QOpenGLContext context;
    context.setFormat(sceneSurfaceFormat());
    if (!context.create()) {
        return QCoreApplication::translate(
            "GlSupport",
            "The views need OpenGL 3.3, but this computer offers none here. Flattening and export "
            "work all the same; a newer graphics driver brings the views back.");
    }
    QOffscreenSurface surface;
    surface.setFormat(context.format());
    surface.create();
    if (!context.makeCurrent(&surface) || !currentGl()) {
        const auto [major, minor] = context.format().version();
        return QCoreApplication::translate(
                   "GlSupport",
                   "The views need OpenGL 3.3, but the graphics driver offers only %1.%2. "
                   "Flattening and export work all the same; a newer driver brings the views back.")
            .arg(major)
            .arg(minor);
    }
    context.doneCurrent();
    return {};
}

Gl* currentGl() {
    QOpenGLContext* context = QOpenGLContext::currentContext();
    return context ? QOpenGLVersionFunctionsFactory::get<Gl>(context) : nullptr;
}

std::unique_ptr<QOpenGLShaderProgram> loadProgram(const std::vector<std::string_view>& files,
                                                  QString& problem) {
    auto program = std::make_unique<QOpenGLShaderProgram>();
    const QByteArray version = "#version 330 core\n";
    QByteArray source = version;
    for (const std::string_view name : files) {
        QFile file(":/shaders/" + QString::fromUtf8(name.data(), qsizetype(name.size())));
        if (!file.open(QIODevice::ReadOnly)) {
            problem = file.fileName();
            return nullptr;
        }
        source += file.readAll();
        if (name.ends_with(".glsl")) {
            continue;
        }
        if (!program->addShaderFromSourceCode(stageOf(name), source)) {
            problem = file.fileName() + ": " + program->log();
            return nullptr;
        }
        source = version;
    }
    if (!program->link()) {
        problem = program->log();
        return nullptr;
    }
    return program;
}

}  // namespace toile
