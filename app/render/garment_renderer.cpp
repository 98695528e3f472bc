// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/render/garment_renderer.h"

#include <QOpenGLShaderProgram>
#include <cstddef>

#include "app/render/gl_uniforms.h"

namespace toile {

namespace {

/// Lifts lines off the cloth, in normalized depth: about a thousandth of the garment's depth.
constexpr float kLineDepthShift = 6e-4F;

constexpr VertexAttribute kAttributes[] = {
    {0, 3, offsetof(GarmentVertex, position)}, {1, 3, offsetof(GarmentVertex, normal)},
    {2, 2, offsetof(GarmentVertex, flat)},     {3, 3, offsetof(GarmentVertex, values)},
    {4, 1, offsetof(GarmentVertex, piece)},
};

constexpr VertexAttribute kLineAttributes[] = {
    {0, 3, offsetof(GarmentLineVertex, position)},
    {4, 1, offsetof(GarmentLineVertex, piece)},
};

}  // namespace

SceneRenderer::ProgramFiles GarmentRenderer::programFiles() const {
    return {{"piece_table.glsl", "garment.vert", "surface.glsl", "garment.frag"},
            {"piece_table.glsl", "garment_line.vert", "line.geom", "line.frag"}};
}

void GarmentRenderer::upload(Gl& gl, const Scene& scene, GpuMesh& mesh, GpuLines& lines) {
    mesh.upload(gl, scene.garment, kAttributes);
    lines.upload(gl, scene.garmentLines, kLineAttributes);
}

void GarmentRenderer::paint(const Camera3D& camera, const ViewState& view, const RenderStyle& style,
                            int width, int height, double pixelRatio) {
    if (!gl_) {
        return;
    }
    gl_->glViewport(0, 0, width, height);
    gl_->glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    Frame frame{glm::mat4(1.0F), view, style, width, height, static_cast<float>(pixelRatio)};
    paintBackdrop(frame);
    if (!synchronize()) {
        return;
    }
    const glm::dmat4 eye = camera.view();
    frame.viewProjection = glm::mat4(camera.projection(scene_->box) * eye);

    gl_->glEnable(GL_DEPTH_TEST);
    gl_->glDepthFunc(GL_LEQUAL);
    gl_->glEnable(GL_POLYGON_OFFSET_FILL);
    gl_->glPolygonOffset(1.0F, 1.0F);
    QOpenGLShaderProgram& cloth = beginCloth(frame);
    setUniform(*gl_, cloth, "normalToView", glm::mat3(glm::dmat3(eye)));
    mesh_.drawTriangles(*gl_);
    cloth.release();
    gl_->glDisable(GL_POLYGON_OFFSET_FILL);

    paintLines(frame, kLineDepthShift);
    gl_->glDisable(GL_DEPTH_TEST);
}

}  // namespace toile
