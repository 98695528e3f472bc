// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "app/render/camera.h"
#include "app/render/morph.h"
#include "app/render/scene_renderer.h"

namespace toile::app {

/// Draws the garment in 3D: lit cloth, outlines, selection. The number of draw calls does not
/// depend on the number of pieces.
class GarmentRenderer : public SceneRenderer {
public:
    /// Paints into the bound framebuffer. @param width, height device pixels
    /// @param morph  position between garment and pattern
    /// @param sewnWay  position between the design and the sewn cloth, 0 to 1
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
    /// Paints translucent cloth; the program is bound.
    void paintSheets(ShaderProgram& cloth);

    /// Motions of the pieces to the sheet: three texels each.
    TableTexture morphTable_{counts_};
    float bend_ = 0, sewnWay_ = 0;
    bool xray_ = false;
    /// The morph and content of the current table.
    Morph tableMorph_;
    int tableContent_ = -1;
};

}  // namespace toile::app
