// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>
#include <vector>

#include <Eigen/Geometry>

#include "core/formats/drawing/drawing.h"
#include "core/mesh/mesh_arrays.h"
#include "core/pattern/curve_fit.h"
#include "core/pattern/line_settings.h"
#include "core/pattern/pattern.h"

namespace toile {

/// The layers of sheets, by index: the kinds of the drawing, then two of the pages.
inline constexpr int kGridLayer = static_cast<int>(kLayerKinds.size());
inline constexpr int kPageLayer = kGridLayer + 1;

/// The anchor of a line of text.
enum class TextStart { Left, Middle };

/// A canvas for sheets of paper, in a file or on a printer: millimetres, y up, from the lower left
/// corner of the sheet. Each `begin` has its `end`; state set between `save` and `restore` ends
/// with it.
class SheetCanvas {
public:
    virtual ~SheetCanvas() = default;

    virtual void save() = 0;
    virtual void restore() = 0;
    /// Transforms everything drawn from now on: (a x + c y, b x + d y) + move.
    virtual void transform(double a, double b, double c, double d, const Eigen::Vector2d& move) = 0;
    virtual void clip(const Eigen::AlignedBox2d& box) = 0;
    /// The printed part of the drawing, in its own coordinates: the same on every sheet.
    virtual void drawing() = 0;

    virtual void beginLayer(int layer) = 0;
    /// Until its end, everything drawn belongs to this id, in other programs and in reading back.
    /// @param piece  empty: no piece
    virtual void beginItem(std::string_view id, std::string_view piece = {}) = 0;
    virtual void end() = 0;

    /// 0 is black, 1 white.
    virtual void setGrey(double grey) = 0;
    virtual void setWidth(double width) = 0;
    virtual void setDashes(double line, double gap) = 0;
    virtual void setRoundEnds() = 0;

    virtual void line(const Points2& points, bool closed) = 0;
    /// Closed if the last ends where the first starts. @param curves  at least one, joined
    virtual void curves(const std::vector<CubicCurve>& curves, bool closed) = 0;
    virtual void box(const Eigen::AlignedBox2d& box) = 0;
    virtual void segment(const Eigen::Vector2d& from, const Eigen::Vector2d& to) = 0;

    /// A line of text, in any script. @param position  on the baseline  @param height  of a capital
    /// @param angle  radians  @param most  maximum width, to which it is shrunk; 0: unlimited
    /// @return its width
    virtual double text(std::string_view text, const Eigen::Vector2d& position, double height,
                        TextStart start, double angle = 0, double most = 0) = 0;
};

/// Line widths, mm, by kind of line.
struct SheetLineWidths {
    double cut = 0.35, others = 0.25, marks = 0.18;
};

/// Draws the whole drawing, in its own coordinates: layer by layer, each line with its id and its
/// piece. Seam lines of pieces with a curved outline are drawn as the curves of `curvesOf`, if
/// these stay close to the line; everything else by its points.
/// @param pattern  the drawn pattern  @param layers  to draw, in this order
/// Cost: linear, and that of `curvesOf` per segment and of the canvas per text.
void drawPattern(SheetCanvas& out, const Drawing& drawing, const Pattern& pattern,
                 const std::vector<LayerKind>& layers, const SheetLineWidths& widths = {});

}  // namespace toile
