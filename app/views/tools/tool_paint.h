// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <QPointF>
#include <QStringList>
#include <optional>
#include <vector>

#include "app/views/tool.h"
#include "app/views/tools/cloth_snapper.h"

class QPainter;

namespace toile::app {

class Document;

/// Painting of tools over the views. Logical pixels.

struct ClothLineStyle {
    QColor colour;
    bool isFixed = true;  ///< solid; dashed while it follows the pointer
};

/// Paints a line over the cloth, with a dark halo for contrast on any colour. Skips parts that are
/// not drawn in this view.
void paintClothLine(const ToolView& view, QPainter& painter, const RenderStyle& style, int piece,
                    const std::vector<SurfacePoint>& points, const ClothLineStyle& line);

/// A place on the cloth: round; square on a corner; hollow until it is set.
void paintHandle(const ToolView& view, QPainter& painter, const RenderStyle& style,
                 const ClothPoint& point, const QColor& colour, bool isSet);

/// A thin dotted line between two places on the screen.
void paintStraight(QPainter& painter, const RenderStyle& style, const QPointF& from,
                   const QPointF& to);

/// Text lines on a label beside the pointer, kept inside the view.
void paintNote(QPainter& painter, const RenderStyle& style, const QPointF& pointer,
               const QStringList& lines);

/// A displacement on the sheet in the user's unit: "12.0, −3.5 mm".
QString wayText(const Eigen::Vector2d& millimetres);

/// The box around the selected pieces in the pattern view, with a handle above it that turns them.
/// Logical pixels. Each function costs the outlines of the selected pieces.

/// Centre of the handle; nullopt if no flat piece is selected.
std::optional<QPointF> turnHandle(const Document& document, const ToolView& view);
bool isOnTurnHandle(const Document& document, const ToolView& view, const QPointF& at);
void paintSelectionFrame(QPainter& painter, const RenderStyle& style, const Document& document,
                         const ToolView& view, bool handleHovered);

}  // namespace toile::app
