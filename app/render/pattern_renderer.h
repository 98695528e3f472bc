// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/render/camera_2d.h"
#include "app/render/scene_renderer.h"

namespace toile {

/// Distance between the grid's strong lines (mm) at a scale, and how visible the fine lines at a
/// tenth of it are, 0 to 1. At the usual scales 100 mm.
struct GridSteps {
    double major;
    double minorStrength;
};

GridSteps gridSteps(double pixelsPerMillimetre);

/// Draws the flat pieces at their places on the sheet, over a grid.
class PatternRenderer : public SceneRenderer {
public:
    /// Into the bound framebuffer. @param width, height device pixels
    void paint(const Camera2D& camera, const ViewState& view, const RenderStyle& style, int width,
               int height, double pixelRatio);

protected:
    ProgramFiles programFiles() const override;
    void upload(Gl& gl, const Scene& scene, GpuMesh& mesh, GpuLines& lines) override;
    const LineRuns& lineRuns(const Scene& scene) const override { return scene.patternLines.runs; }

private:
    void setGrid(const Camera2D& camera, double pixelRatio);
};

}  // namespace toile
