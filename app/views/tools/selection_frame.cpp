// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/views/tools/selection_frame.h"

#include <QPainter>
#include <cmath>

#include "app/document/layout.h"
#include "app/render/render_style.h"
#include "app/views/tools/sheet_map.h"

namespace toile {

namespace {

constexpr double kAir = 7;          // pixels between the cloth and the box
constexpr double kStem = 20;        // from the box to the handle's middle
constexpr double kFrameHandle = 6;  // radius
constexpr double kGrab = 10;        // radius that takes a press

std::optional<QRectF> frameOf(const Document& document, const ToolView& view) {
    const Eigen::AlignedBox2d box = boxOnSheet(document, selectedFlat(document));
    if (box.isEmpty()) {
        return std::nullopt;
    }
    return SheetMap(view)(box).adjusted(-kAir, -kAir, kAir, kAir);
}

QPointF handleOf(const QRectF& frame) {
    return {frame.center().x(), frame.top() - kStem};
}

}  // namespace

std::optional<QPointF> turnHandle(const Document& document, const ToolView& view) {
    const auto frame = frameOf(document, view);
    return frame ? std::optional(handleOf(*frame)) : std::nullopt;
}

bool isOnTurnHandle(const Document& document, const ToolView& view, const QPointF& at) {
    const auto handle = turnHandle(document, view);
    return handle && std::hypot(handle->x() - at.x(), handle->y() - at.y()) <= kGrab;
}

void paintSelectionFrame(QPainter& painter, const RenderStyle& style, const Document& document,
                         const ToolView& view, bool handleHovered) {
    const auto frame = frameOf(document, view);
    if (!frame) {
        return;
    }
    const QPointF handle = handleOf(*frame);
    QColor line = style.selection;
    line.setAlpha(150);
    painter.save();
    painter.setPen(QPen(line, 1, Qt::DashLine));
    painter.setBrush(Qt::NoBrush);
    painter.drawRect(*frame);
    painter.setPen(QPen(line, 1));
    painter.drawLine(QPointF(handle.x(), frame->top()), handle + QPointF(0, kFrameHandle));
    QColor ground = style.plate;
    ground.setAlpha(255);
    painter.setPen(QPen(style.selection, 1.5));
    painter.setBrush(handleHovered ? style.selection : ground);
    painter.drawEllipse(handle, kFrameHandle, kFrameHandle);
    painter.restore();
}

}  // namespace toile
