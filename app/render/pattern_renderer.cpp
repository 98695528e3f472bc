// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/render/pattern_renderer.h"

#include <algorithm>
#include <cmath>

namespace toile::app {

namespace {

/// Minimum screen distance of strong lines; fine lines fade in over the range below.
constexpr double kMajorPixels = 34.0;
constexpr double kMinorFrom = 6.0, kMinorFull = 24.0;

}  // namespace

GridSteps gridSteps(double pixelsPerMillimetre, LengthUnit unit) {
    // Powers of ten of the unit; fractions of an inch are halved repeatedly.
    const bool isInch = unit == LengthUnit::Inch;
    const double one = isInch ? millimetresPer(unit) : 1;
    const double least = kMajorPixels / pixelsPerMillimetre / one;
    const bool isPartOfInch = isInch && least <= 1;
    const double base = isPartOfInch ? 8 : 10;
    const double power = std::ceil(std::log(least) / std::log(base) - 1e-9);
    const double major = one * std::pow(base, power);
    const int parts = isInch && power <= 0 ? 8 : 10;
    const double minorPixels = major / parts * pixelsPerMillimetre;
    return {major, parts,
            0.5 * std::clamp((minorPixels - kMinorFrom) / (kMinorFull - kMinorFrom), 0.0, 1.0)};
}

SceneRenderer::ProgramFiles PatternRenderer::programFiles() const {
    return {{"piece_table.glsl", "pattern.vert", "surface.glsl", "pattern.frag"},
            {"piece_table.glsl", "pattern_line.vert", "line.geom", "line.frag"},
            {"piece_table.glsl", "glyph.glsl", "pattern_glyph.vert", "glyph.geom", "glyph.glsl",
             "glyph.frag"}};
}

void PatternRenderer::setGrid(const Camera2D& camera, bool shown, double pixelRatio) {
    const GridSteps steps = gridSteps(camera.pixelsPerMillimetre(), gridUnit_);
    const Eigen::Vector2d corner = camera.visible().min();
    ShaderProgram& program = backdropProgram();
    program.bind();
    program.setUniformValue("gridStrength", shown ? 0.75F : 0.0F);
    // Position of the sheet's origin from the lower left corner, device pixels.
    const Eigen::Vector2d origin = -corner * camera.pixelsPerMillimetre() * pixelRatio;
    program.setUniformValue("sheetOrigin", static_cast<float>(origin.x()),
                            static_cast<float>(origin.y()));
    program.setUniformValue("axisWidth", static_cast<float>(pixelRatio));
    // Subtract whole steps in double precision, because only the remainder fits a float.
    program.setUniformValue(
        "gridOrigin",
        static_cast<float>(corner.x() - steps.major * std::floor(corner.x() / steps.major)),
        static_cast<float>(corner.y() - steps.major * std::floor(corner.y() / steps.major)));
    program.setUniformValue("unitsPerPixel",
                            static_cast<float>(1.0 / (camera.pixelsPerMillimetre() * pixelRatio)));
    program.setUniformValue("majorStep", static_cast<float>(steps.major));
    program.setUniformValue("minorStep", static_cast<float>(steps.minor()));
    program.setUniformValue("minorStrength", static_cast<float>(steps.minorStrength));
}

void PatternRenderer::paint(const Camera2D& camera, const ViewState& view, const RenderStyle& style,
                            int width, int height, double pixelRatio) {
    if (!isReady_) {
        return;
    }
    glViewport(0, 0, width, height);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    const Frame frame{glm::mat4(camera.projection()),
                      view,
                      style,
                      width,
                      height,
                      static_cast<float>(pixelRatio),
                      static_cast<float>(1 / (camera.pixelsPerMillimetre() * pixelRatio))};
    setGrid(camera, view.grid, pixelRatio);
    paintBackdrop(frame);
    if (!synchronize(view)) {
        return;
    }
    ShaderProgram& cloth = beginCloth(frame);
    mesh_.drawTriangles();
    cloth.release();
    paintCrosses(frame, 0.0F, 1 / camera.pixelsPerMillimetre());
    paintLines(frame, 0.0F);
}

}  // namespace toile::app
