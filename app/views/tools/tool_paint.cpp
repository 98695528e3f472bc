// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/views/tools/tool_paint.h"

#include <QFontMetricsF>
#include <QPaintDevice>
#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <cmath>

#include "app/document/layout.h"
#include "app/render/render_style.h"
#include "app/text/figures.h"
#include "app/views/tool.h"

namespace toile::app {

namespace {

constexpr double kLineWidth = 2.2, kHaloWidth = 4.6, kHandle = 4.5;

constexpr double kAir = 7;          // pixels between cloth and box
constexpr double kStem = 20;        // from the box to the handle's centre
constexpr double kFrameHandle = 6;  // radius
constexpr double kGrab = 10;        // picking radius

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

void paintClothLine(const ToolView& view, QPainter& painter, const RenderStyle& style, int piece,
                    const std::vector<SurfacePoint>& points, const ClothLineStyle& line) {
    QPainterPath path;
    bool isDown = false;
    for (const SurfacePoint& point : points) {
        const auto at = view.onScreen(piece, point.face, point.barycentric);
        if (at && isDown) {
            path.lineTo(*at);
        } else if (at) {
            path.moveTo(*at);
        }
        isDown = at.has_value();
    }
    painter.save();
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(style.seamHalo, kHaloWidth, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.drawPath(path);
    QPen pen(line.colour, kLineWidth, Qt::SolidLine, Qt::FlatCap, Qt::RoundJoin);
    if (!line.isFixed) {
        pen.setDashPattern({4, 3});
    }
    painter.setPen(pen);
    painter.drawPath(path);
    painter.restore();
}

void paintHandle(const ToolView& view, QPainter& painter, const RenderStyle& style,
                 const ClothPoint& point, const QColor& colour, bool isSet) {
    const auto at = view.onScreen(point.piece, point.at.face, point.at.barycentric);
    if (!at) {
        return;
    }
    // Show the snap target before the click: a corner, an edge, an earlier place.
    const double size = point.on == ClothPoint::On::Own && !isSet ? 1.7 * kHandle : kHandle;
    const QRectF box(at->x() - size, at->y() - size, 2 * size, 2 * size);
    const auto draw = [&] {
        if (point.on == ClothPoint::On::Corner) {
            painter.drawRect(box);
        } else {
            painter.drawEllipse(box);
        }
    };
    painter.save();
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(style.seamHalo, 4));
    draw();
    painter.setPen(QPen(colour, 2));
    const bool isFilled = isSet || point.on == ClothPoint::On::Cloth;
    painter.setBrush(isFilled ? QBrush(colour) : QBrush(Qt::NoBrush));
    draw();
    painter.restore();
}

void paintStraight(QPainter& painter, const RenderStyle& style, const QPointF& from,
                   const QPointF& to) {
    painter.save();
    painter.setPen(QPen(style.text, 1.2, Qt::DotLine));
    painter.drawLine(from, to);
    painter.restore();
}

void paintNote(QPainter& painter, const RenderStyle& style, const QPointF& pointer,
               const QStringList& lines) {
    if (lines.isEmpty()) {
        return;
    }
    constexpr double kPadX = 8, kPadY = 4, kAway = 16, kMargin = 4;
    const QFontMetricsF metrics(painter.font());
    double width = 0;
    for (const QString& line : lines) {
        width = std::max(width, metrics.horizontalAdvance(line));
    }
    const QSizeF size(width + 2 * kPadX,
                      metrics.height() * static_cast<double>(lines.size()) + 2 * kPadY);
    const double ratio = painter.device()->devicePixelRatioF();
    const QSizeF room(painter.device()->width() / ratio, painter.device()->height() / ratio);
    // At the lower right of the pointer, or on its other side near the view's edge.
    double x = pointer.x() + kAway, y = pointer.y() + kAway;
    x = x + size.width() + kMargin > room.width() ? pointer.x() - kAway - size.width() : x;
    y = y + size.height() + kMargin > room.height() ? pointer.y() - kAway - size.height() : y;
    const QRectF box(QPointF(std::max(kMargin, x), std::max(kMargin, y)), size);
    painter.save();
    QColor ground = style.labelFill;
    ground.setAlpha(235);
    painter.setPen(QPen(style.faintText, 1));
    painter.setBrush(ground);
    painter.drawRoundedRect(box, 6, 6);
    painter.setPen(style.text);
    QRectF row(box.left() + kPadX, box.top() + kPadY, box.width(), metrics.height());
    for (const QString& line : lines) {
        painter.drawText(row, Qt::AlignLeft | Qt::AlignVCenter, line);
        row.translate(0, metrics.height());
    }
    painter.restore();
}

QString wayText(const Eigen::Vector2d& millimetres) {
    return QString("%1, %2").arg(lengthNumber(millimetres.x()), lengthWithUnit(millimetres.y()));
}

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
    QColor ground = style.labelFill;
    ground.setAlpha(255);
    painter.setPen(QPen(style.selection, 1.5));
    painter.setBrush(handleHovered ? style.selection : ground);
    painter.drawEllipse(handle, kFrameHandle, kFrameHandle);
    painter.restore();
}

}  // namespace toile::app
