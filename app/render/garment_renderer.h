// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/render/camera_3d.h"
#include "app/render/scene_renderer.h"

namespace toile {

/// Draws the garment in 3D: lit cloth, outlines, selection. A fixed number of draw calls whatever
/// the number of pieces.
class GarmentRenderer : public SceneRenderer {
public:
    /// Into the bound framebuffer. @param width, height device pixels
    void paint(const Camera3D& camera, const ViewState& view, const RenderStyle& style, int width,
               int height, double pixelRatio);

protected:
    ProgramFiles programFiles() const override;
    void upload(Gl& gl, const Scene& scene, GpuMesh& mesh, GpuLines& lines) override;
    const LineRuns& lineRuns(const Scene& scene) const override { return scene.garmentLines.runs; }
};

}  // namespace toile
