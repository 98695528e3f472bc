// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPointF>
#include <optional>

class QPainter;

namespace toile {

class Document;
class ToolView;
struct RenderStyle;

/// The box around the selected pieces in the pattern view, with a handle above it that turns them.
/// Logical pixels. Each costs the outlines of the selected pieces.

/// Middle of the handle; nothing where no flat piece is selected.
std::optional<QPointF> turnHandle(const Document& document, const ToolView& view);
bool isOnTurnHandle(const Document& document, const ToolView& view, const QPointF& at);
void paintSelectionFrame(QPainter& painter, const RenderStyle& style, const Document& document,
                         const ToolView& view, bool handleHovered);

}  // namespace toile
