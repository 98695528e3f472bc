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

/// Breadth of the rulers at the upper and left edge of the pattern view, logical pixels.
inline constexpr int kRulerBreadth = 20;

/// The unit of a ruler.
struct RulerUnit {
    QString symbol;
    double millimetres;
    bool inFractions = false;
};

/// Divisions of a ruler at a scale: labelled ticks every `major`, each split into `parts` parts.
struct RulerSteps {
    double major = 100;  ///< mm
    int parts = 10;
};

/// Steps are round in the unit; inches are halved repeatedly, down to 1/64.
RulerSteps rulerSteps(double pixelsPerMillimetre, LengthUnit unit);
/// The user's unit; metres for widely spaced ticks.
RulerUnit rulerUnit(const RulerSteps& steps, LengthUnit unit);
/// The label of a place on the sheet (mm), without unit: "12.5", "1 3/8".
QString rulerText(double millimetres, const RulerUnit& unit);

/// Paints both rulers in the user's unit (`LengthDisplay`), which is written in the corner between
/// them.
/// @param marked  extent of the selection, shown as a band on both; may be empty
void paintRulers(QPainter& painter, const RenderStyle& style, const QRect& view,
                 const SheetMap& onScreen, const Eigen::AlignedBox2d& visible,
                 double pixelsPerMillimetre, const Eigen::AlignedBox2d& marked);

/// Margins for rulers, caption, scale bar and the overlay's legend. The legend's space is always
/// reserved, so that nothing moves when it appears.
Camera2D::Margins patternMargins(bool rulers);

/// Frames pieces, in the view and in pictures of it. Precondition: the camera's viewport is set.
/// @param pieces  indices into Scene::pieces
/// @param also    additional area on the sheet, mm
void framePattern(Camera2D& camera, const Scene& scene, const SheetPlaces& places,
                  const std::set<int>& pieces, bool rulers,
                  const Eigen::AlignedBox2d& also = Eigen::AlignedBox2d());

}  // namespace toile::app
