// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/render/garment_renderer.h"

#include <algorithm>

#include "app/render/shader_program.h"

namespace toile::app {

namespace {

/// Lifts lines off the cloth by about half a pixel, as a share of their distance from the eye.
constexpr double kLineDepthShift = 3e-4;

constexpr int kMorphTableUnit = 3;
/// Opacity in x-ray mode, of the nearest layer (whose colours stay readable) and of those behind.
constexpr float kXrayNearest = 0.58F, kXrayBehind = 0.34F;

/// The table depends on the camera only once pieces fly to the sheet.
bool needNewTable(const Morph& now, const Morph& before) {
    return now.flight() != before.flight() ||
           (now.flight() > 0 &&
            (now.sheetAxes != before.sheetAxes || now.sheetCentre != before.sheetCentre));
}

}  // namespace

SceneRenderer::ProgramFiles GarmentRenderer::programFiles() const {
    return {{"piece_table.glsl", "morph.glsl", "garment.vert", "surface.glsl", "garment.frag"},
            {"piece_table.glsl", "morph.glsl", "garment_line.vert", "line.geom", "line.frag"},
            {"piece_table.glsl", "glyph.glsl", "garment_glyph.vert", "glyph.geom", "glyph.glsl",
             "glyph.frag"}};
}

void GarmentRenderer::paint(const Camera3D& camera, const ViewState& view, const RenderStyle& style,
                            int width, int height, double pixelRatio, const Morph& morph,
                            double sewnWay) {
    if (!isReady_) {
        return;
    }
    glViewport(0, 0, width, height);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    Frame frame{glm::mat4(1.0F), view, style, width, height, static_cast<float>(pixelRatio)};
    paintBackdrop(frame);
    if (!synchronize(view)) {
        return;
    }
    synchronizeMorph(morph);
    sewnWay_ = sewn() ? static_cast<float>(sewnWay) : 0.0F;
    xray_ = view.xray;
    const glm::dmat4 eye = camera.view();
    Eigen::AlignedBox3d box = content_.scene->box;
    if (sewnWay_ > 0) {
        box.extend(sewn()->box);
    }
    if (morph.way > 0) {
        for (const Eigen::AlignedBox3d& piece :
             morphBoxes(*content_.scene, content_.places, morph)) {
            box.extend(piece);
        }
    }
    frame.viewProjection = glm::mat4(camera.projection(box) * eye);
    const auto depthShift = static_cast<float>(camera.depthShift(box, kLineDepthShift));

    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LEQUAL);
    paintCloth(frame, camera);

    if (morph.way == 0 &&
        sewnWay_ == 0) {  // strokes on the garment that do not follow it to the sheet
        // Spacing is chosen at the target's depth; glyphs nearer or farther follow the perspective.
        const Eigen::Vector3d here = camera.pointAtTargetDepth(0, 0);
        constexpr double kPixels = 100;
        paintCrosses(frame, depthShift,
                     (camera.pointAtTargetDepth(kPixels, 0) - here).norm() / kPixels);
    }
    if (morph.way == 0) {  // leftovers have no flat position
        paintLeftOut(frame, -depthShift);
    }
    paintLines(frame, depthShift);
    glDisable(GL_DEPTH_TEST);
}

void GarmentRenderer::paintCloth(const Frame& frame, const Camera3D& camera) {
    glEnable(GL_POLYGON_OFFSET_FILL);
    glPolygonOffset(1.0F, 1.0F);
    ShaderProgram& cloth = beginCloth(frame);
    cloth.setUniformValue("normalToView", glm::mat3(glm::dmat3(camera.view())));
    cloth.setUniformValue("clothAlpha", 1.0F);
    cloth.setUniformValue("shaded", frame.view.shaded);
    if (xray_) {
        paintSheets(cloth);
    } else {
        mesh_.drawTriangles();
    }
    cloth.release();
    glDisable(GL_POLYGON_OFFSET_FILL);
}

void GarmentRenderer::paintSheets(ShaderProgram& cloth) {
    beginBlending();
    // Fill the depth buffer with the nearest layer, still invisible.
    cloth.setUniformValue("clothAlpha", 0.0F);
    mesh_.drawTriangles();
    glDepthMask(GL_FALSE);
    // Draw the layers behind it, back faces first, since most of them are farther away.
    glDepthFunc(GL_GREATER);
    cloth.setUniformValue("clothAlpha", kXrayBehind);
    glEnable(GL_CULL_FACE);
    for (const GLenum culled : {GL_FRONT, GL_BACK}) {
        glCullFace(culled);
        mesh_.drawTriangles();
    }
    glDisable(GL_CULL_FACE);
    glDepthFunc(GL_LEQUAL);
    cloth.setUniformValue("clothAlpha", kXrayNearest);
    mesh_.drawTriangles();
    glDepthMask(GL_TRUE);
    glDisable(GL_BLEND);
    glClear(GL_DEPTH_BUFFER_BIT);  // draw lines over all layers
}

void GarmentRenderer::synchronizeMorph(const Morph& morph) {
    bend_ = static_cast<float>(morph.bend());
    if (bend_ == 0 || (tableContent_ == contentNumber() && !needNewTable(morph, tableMorph_))) {
        return;
    }
    const std::vector<SpaceMotion> motions = morphMotions(*content_.scene, content_.places, morph);
    std::vector<float> texels;
    for (const SpaceMotion& motion : motions) {
        for (int k = 0; k < 3; ++k) {
            for (int row = 0; row < 3; ++row) {
                texels.push_back(static_cast<float>(motion.turn(row, k)));
            }
            texels.push_back(static_cast<float>(motion.offset[k]));
        }
    }
    morphTable_.upload(texels);
    tableMorph_ = morph;
    tableContent_ = contentNumber();
}

void GarmentRenderer::setOwnUniforms(ShaderProgram& program) {
    program.setUniformValue("bend", bend_);
    program.setUniformValue("sewnWay", sewnWay_);
    program.setUniformValue("morphTable", kMorphTableUnit);
    morphTable_.bind(kMorphTableUnit);
}

void GarmentRenderer::releaseOwn() {
    morphTable_.release();
    tableContent_ = -1;
}

}  // namespace toile::app
