// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <set>
#include <vector>

#include <Eigen/Geometry>

#include "app/render/camera.h"
#include "app/render/scene.h"
#include "core/base/units.h"

class QPainter;
class QRect;

namespace toile::app {

class SheetMap;
struct RenderStyle;

/// Breadth of the rulers along the upper and the left edge of the pattern view, logical pixels.
inline constexpr int kRulerBreadth = 20;

/// What a ruler counts in.
struct RulerUnit {
    QString symbol;
    double millimetres;
    bool inFractions = false;
};

/// How a ruler is divided at a scale: labelled ticks every `major`, each in `parts` parts.
struct RulerSteps {
    double major = 100;  ///< mm
    int parts = 10;
};

/// Round numbers of the unit; parts of an inch are halves of each other, down to 1/64.
RulerSteps rulerSteps(double pixelsPerMillimetre, LengthUnit unit);
/// The person's unit; metres where ticks are so far apart.
RulerUnit rulerUnit(const RulerSteps& steps, LengthUnit unit);
/// A place of the sheet (mm) as the ruler's label says it, without the unit: "12.5", "1 3/8".
QString rulerText(double millimetres, const RulerUnit& unit);

/// Paints both rulers, in the person's unit (`LengthDisplay`), which stands in the corner between
/// them.
/// @param marked  extent of what is selected, shown as a band on both; may be empty
void paintRulers(QPainter& painter, const RenderStyle& style, const QRect& view,
                 const SheetMap& onScreen, const Eigen::AlignedBox2d& visible,
                 double pixelsPerMillimetre, const Eigen::AlignedBox2d& marked);

/// Room for what is written around the pattern: rulers, caption, scale bar and the overlay's
/// legend, whether that is there or not: nothing moves when it comes.
Camera2D::Margins patternMargins(bool rulers);

/// Brings pieces into sight, in the view and in pictures of it. The camera's viewport is set
/// before.
/// @param pieces  indices into Scene::pieces
/// @param also    on the sheet, mm
void framePattern(Camera2D& camera, const Scene& scene, const SheetPlaces& places,
                  const std::set<int>& pieces, bool rulers,
                  const Eigen::AlignedBox2d& also = Eigen::AlignedBox2d());

}  // namespace toile::app
