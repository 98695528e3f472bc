// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/render/camera.h"
#include "app/render/scene_renderer.h"
#include "core/base/units.h"

namespace toile::app {

/// Distance between the grid's strong lines (mm) at a scale, into how many parts the fine lines
/// divide it, and how visible these are, 0 to 1. At the usual scales 100 mm in tenths; where
/// lengths are in inches 10 in in tenths, or an inch in eighths.
struct GridSteps {
    double major;
    int parts;
    double minorStrength;

    double minor() const { return major / parts; }
};

GridSteps gridSteps(double pixelsPerMillimetre, LengthUnit unit = LengthUnit::Millimetre);

/// Draws the flat pieces at their places on the sheet, over a grid.
class PatternRenderer : public SceneRenderer {
public:
    /// Into the bound framebuffer. @param width, height device pixels
    void paint(const Camera2D& camera, const ViewState& view, const RenderStyle& style, int width,
               int height, double pixelRatio);
    /// What the grid counts in from the next painting on; millimetres at first.
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
