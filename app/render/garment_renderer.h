// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "app/render/camera.h"
#include "app/render/morph.h"
#include "app/render/scene_renderer.h"

namespace toile::app {

/// Draws the garment in 3D: lit cloth, outlines, selection. A fixed number of draw calls whatever
/// the number of pieces.
class GarmentRenderer : public SceneRenderer {
public:
    /// Into the bound framebuffer. @param width, height device pixels
    /// @param morph  how far the garment is on its way to the pattern
    /// @param sewnWay  how far from the design to the cloth that is sewn, 0 to 1
    void paint(const Camera3D& camera, const ViewState& view, const RenderStyle& style, int width,
               int height, double pixelRatio, const Morph& morph = {}, double sewnWay = 0);

protected:
    ProgramFiles programFiles() const override;
    const MeshIndices& meshOf(const Scene& scene) const override { return scene.garment; }
    const LineRuns& linesOf(const Scene& scene) const override { return scene.garmentLines; }
    std::vector<FaceValues> faceValues(const Scene& scene) const override {
        return garmentFaces(scene);
    }
    void setOwnUniforms(ShaderProgram& program) override;
    bool isInDepth() const override { return !xray_; }
    void releaseOwn() override;

private:
    void synchronizeMorph(const Morph& morph);
    void paintCloth(const Frame& frame, const Camera3D& camera);
    /// Cloth that is seen through, with the program bound.
    void paintSheets(ShaderProgram& cloth);

    /// Motions of the pieces on their way to the sheet: three texels each.
    TableTexture morphTable_{counts_};
    float bend_ = 0, sewnWay_ = 0;
    bool xray_ = false;
    /// What the table was made for.
    Morph tableMorph_;
    int tableContent_ = -1;
};

}  // namespace toile::app
