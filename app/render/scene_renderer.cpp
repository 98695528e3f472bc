// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/render/scene_renderer.h"

#include <QCoreApplication>
#include <QOpenGLShaderProgram>
#include <utility>

#include <glm/gtc/type_ptr.hpp>

#include "app/render/colour_map.h"
#include "app/render/gl_uniforms.h"
#include "app/render/piece_table.h"

namespace toile {

namespace {

constexpr int kPieceTableUnit = 0, kColourMapUnit = 1;

/// Widths in logical pixels.
constexpr float kOutlineWidth = 1.25F, kSelectedWidth = 3.0F, kWireWidth = 0.7F;
constexpr float kSeamWidth = 4.0F, kSeamHaloWidth = 8.0F, kDesignerWidth = 1.5F;
constexpr float kDashPixels = 11.0F;
/// How much of a seam shows through the cloth that hides it.
constexpr int kHiddenSeamAlpha = 75;

GLuint makeTexture(Gl& gl, GLint filter) {
    GLuint texture = 0;
    gl.glGenTextures(1, &texture);
    gl.glBindTexture(GL_TEXTURE_2D, texture);
    gl.glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, filter);
    gl.glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, filter);
    gl.glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    gl.glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    return texture;
}

GLuint makeColourMapTexture(Gl& gl, const ColourMap& map) {
    const GLuint texture = makeTexture(gl, GL_LINEAR);
    gl.glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    gl.glTexImage2D(GL_TEXTURE_2D, 0, GL_RGB8, kColourMapSize, 1, 0, GL_RGB, GL_UNSIGNED_BYTE,
                    map.data());
    gl.glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
    return texture;
}

void beginBlending(Gl& gl) {
    gl.glEnable(GL_BLEND);
    // Alpha of the framebuffer stays 1: the window is not to shine through.
    gl.glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
}

}  // namespace

SceneRenderer::SceneRenderer() = default;

SceneRenderer::~SceneRenderer() = default;

QString SceneRenderer::initialize() {
    gl_ = currentGl();
    if (!gl_) {
        return QCoreApplication::translate(
            "SceneRenderer",
            "This view needs OpenGL 3.3, which the graphics driver does not offer.");
    }
    const ProgramFiles files = programFiles();
    QString problem;
    cloth_ = loadProgram(files.cloth, problem);
    if (cloth_) {
        lines_ = loadProgram(files.lines, problem);
    }
    if (lines_) {
        backdrop_ = loadProgram({"backdrop.vert", "backdrop.frag"}, problem);
    }
    if (!cloth_ || !lines_ || !backdrop_) {
        return QCoreApplication::translate("SceneRenderer",
                                           "The graphics driver refused to draw this view (%1).")
            .arg(problem);
    }
    gl_->glGenVertexArrays(1, &emptyArray_);
    pieceTable_ = makeTexture(*gl_, GL_NEAREST);
    uploadColourMaps();
    sceneChanged_ = tableChanged_ = scene_ != nullptr;
    return {};
}

void SceneRenderer::release() {
    if (!gl_) {
        return;
    }
    mesh_.release(*gl_);
    overLines_.release(*gl_);
    gl_->glDeleteVertexArrays(1, &emptyArray_);
    for (GLuint* texture : {&pieceTable_, &divergingMap_, &sequentialMap_}) {
        gl_->glDeleteTextures(1, texture);
        *texture = 0;
    }
    emptyArray_ = 0;
    cloth_.reset();
    lines_.reset();
    backdrop_.reset();
    gl_ = nullptr;
}

void SceneRenderer::setScene(std::shared_ptr<const Scene> scene) {
    if (scene == scene_) {
        return;
    }
    scene_ = std::move(scene);
    sceneChanged_ = tableChanged_ = true;
}

void SceneRenderer::setSelection(std::set<int> selection) {
    selection_ = std::move(selection);
    tableChanged_ = true;
}

bool SceneRenderer::synchronize() {
    if (!scene_ || !cloth_) {
        return false;
    }
    if (std::exchange(sceneChanged_, false)) {
        upload(*gl_, *scene_, mesh_, overLines_);
    }
    if (std::exchange(tableChanged_, false)) {
        uploadPieceTable();
    }
    return true;
}

void SceneRenderer::uploadPieceTable() {
    const PieceTable table = makePieceTable(*scene_, selection_);
    gl_->glBindTexture(GL_TEXTURE_2D, pieceTable_);
    gl_->glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, kPieceTableWidth, table.height, 0, GL_RGBA,
                      GL_FLOAT, table.texels.data());
}

void SceneRenderer::uploadColourMaps() {
    divergingMap_ = makeColourMapTexture(*gl_, divergingMap());
    sequentialMap_ = makeColourMapTexture(*gl_, sequentialMap());
}

void SceneRenderer::bindPieceTable() {
    gl_->glActiveTexture(GL_TEXTURE0 + kPieceTableUnit);
    gl_->glBindTexture(GL_TEXTURE_2D, pieceTable_);
}

QOpenGLShaderProgram& SceneRenderer::beginCloth(const Frame& frame) {
    const Overlay overlay = frame.view.overlay;
    const OverlayScale& scale = scene_->scale(overlay);
    gl_->glActiveTexture(GL_TEXTURE0 + kColourMapUnit);
    gl_->glBindTexture(GL_TEXTURE_2D, overlay == Overlay::Angle ? sequentialMap_ : divergingMap_);
    bindPieceTable();

    QOpenGLShaderProgram& program = *cloth_;
    program.bind();
    program.setUniformValue("pieceTable", kPieceTableUnit);
    program.setUniformValue("colourMap", kColourMapUnit);
    program.setUniformValue("overlay", static_cast<int>(overlay));
    program.setUniformValue("overlayRange", static_cast<float>(scale.low),
                            static_cast<float>(scale.high));
    setUniform(*gl_, program, "viewProjection", frame.viewProjection);
    setUniform(program, "selectionColour", frame.style.selection);
    return program;
}

QOpenGLShaderProgram& SceneRenderer::beginLines(const Frame& frame, float depthShift) {
    QOpenGLShaderProgram& program = *lines_;
    program.bind();
    bindPieceTable();
    program.setUniformValue("pieceTable", kPieceTableUnit);
    program.setUniformValue("depthShift", depthShift);
    program.setUniformValue("dashLength", 0.0F);
    program.setUniformValue("viewportPixels", static_cast<float>(frame.width),
                            static_cast<float>(frame.height));
    setUniform(*gl_, program, "viewProjection", frame.viewProjection);
    return program;
}

void SceneRenderer::setLine(const QColor& colour, float width, bool selectedOnly,
                            const Frame& frame) {
    lines_->setUniformValue("lineColour", colour);
    lines_->setUniformValue("lineWidth", width * frame.pixelRatio);
    lines_->setUniformValue("selectedOnly", selectedOnly);
}

void SceneRenderer::paintLines(const Frame& frame, float depthShift) {
    QOpenGLShaderProgram& program = beginLines(frame, depthShift);
    if (frame.view.wireframe) {
        paintWireframe(frame);
    }
    setLine(frame.style.outline, kOutlineWidth, false, frame);
    mesh_.drawOutline(*gl_);
    program.setUniformValue("depthShift", 2 * depthShift);
    setLine(frame.style.selection, kSelectedWidth, true, frame);
    mesh_.drawOutline(*gl_);
    if (frame.view.designerOutline) {
        paintDesignerLines(frame);
    }
    paintSeam(frame, depthShift);
    program.release();
}

void SceneRenderer::paintWireframe(const Frame& frame) {
    QColor wire = frame.style.wire;
    wire.setAlpha(110);
    beginBlending(*gl_);
    setLine(wire, kWireWidth, false, frame);
    mesh_.drawEdges(*gl_);
    gl_->glDisable(GL_BLEND);
}

void SceneRenderer::paintDesignerLines(const Frame& frame) {
    lines_->setUniformValue("dashLength",
                            kDashPixels * frame.pixelRatio * frame.millimetresPerPixel);
    setLine(frame.style.designer, kDesignerWidth, false, frame);
    for (const VertexRun& run : lineRuns(*scene_).designer) {
        overLines_.draw(*gl_, run);
    }
    lines_->setUniformValue("dashLength", 0.0F);
}

void SceneRenderer::paintSeam(const Frame& frame, float depthShift) {
    const LineRuns& runs = lineRuns(*scene_);
    if (!seam_ || *seam_ >= static_cast<int>(runs.seams.size())) {
        return;
    }
    const auto drawSides = [&] {
        for (const VertexRun& side : runs.seams[static_cast<std::size_t>(*seam_)]) {
            overLines_.draw(*gl_, side);
        }
    };
    const bool inDepth = gl_->glIsEnabled(GL_DEPTH_TEST) == GL_TRUE;
    if (inDepth) {
        // Faintly through the cloth, so that a seam on the far side is found.
        QColor hidden = frame.style.seam;
        hidden.setAlpha(kHiddenSeamAlpha);
        gl_->glDisable(GL_DEPTH_TEST);
        beginBlending(*gl_);
        setLine(hidden, kSeamWidth, false, frame);
        drawSides();
        gl_->glDisable(GL_BLEND);
        gl_->glEnable(GL_DEPTH_TEST);
    }
    // The halo leaves no depth behind: at bends it would cover parts of the line itself.
    gl_->glDepthMask(GL_FALSE);
    lines_->setUniformValue("depthShift", 3 * depthShift);
    setLine(frame.style.seamHalo, kSeamHaloWidth, false, frame);
    drawSides();
    setLine(frame.style.seam, kSeamWidth, false, frame);
    drawSides();
    gl_->glDepthMask(GL_TRUE);
}

void SceneRenderer::paintBackdrop(const Frame& frame) {
    gl_->glDisable(GL_DEPTH_TEST);
    gl_->glDisable(GL_CULL_FACE);
    gl_->glDisable(GL_BLEND);
    backdrop_->bind();
    setUniform(*backdrop_, "topColour", frame.style.top);
    setUniform(*backdrop_, "bottomColour", frame.style.bottom);
    setUniform(*backdrop_, "gridColour", frame.style.grid);
    gl_->glBindVertexArray(emptyArray_);
    gl_->glDrawArrays(GL_TRIANGLES, 0, 3);
    gl_->glBindVertexArray(0);
    backdrop_->release();
}

}  // namespace toile
