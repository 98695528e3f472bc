// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/render/camera.h"
#include "app/render/scene_renderer.h"
#include "core/base/units.h"

namespace toile::app {

/// Grid at a scale: distance of the strong lines (mm), number of parts between them, and visibility
/// of the fine lines, 0 to 1. At usual scales 100 mm in tenths; for inches 10 in in tenths, or one
/// inch in eighths.
struct GridSteps {
    double major;
    int parts;
    double minorStrength;

    double minor() const { return major / parts; }
};

GridSteps gridSteps(double pixelsPerMillimetre, LengthUnit unit = LengthUnit::Millimetre);

/// Draws the flat pieces on the sheet, over a grid.
class PatternRenderer : public SceneRenderer {
public:
    /// Paints into the bound framebuffer. @param width, height device pixels
    void paint(const Camera2D& camera, const ViewState& view, const RenderStyle& style, int width,
               int height, double pixelRatio);
    /// Sets the unit of the grid; millimetres by default.
    void setGridUnit(LengthUnit unit) { gridUnit_ = unit; }

protected:
    ProgramFiles programFiles() const override;
    const MeshIndices& meshOf(const Scene& scene) const override { return scene.pattern; }
    const LineRuns& linesOf(const Scene& scene) const override { return scene.patternLines; }
    std::vector<FaceValues> faceValues(const Scene& scene) const override { return scene.faces; }
    bool isSheet() const override { return true; }

private:
    void setGrid(const Camera2D& camera, bool shown, double pixelRatio);

    LengthUnit gridUnit_ = LengthUnit::Millimetre;
};

}  // namespace toile::app
