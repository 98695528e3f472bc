// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/marker/cloth_paint.h"

#include <QCoreApplication>
#include <QPainter>
#include <QPainterPath>
#include <QPolygonF>
#include <algorithm>
#include <cmath>

#include "app/render/render_style.h"
#include "app/text/figures.h"
#include "app/views/grain_arrow.h"
#include "app/views/view_text.h"
#include "core/pattern/pole.h"

namespace toile::app {

namespace {

constexpr double kSelvedge = 3;          // pixels
constexpr double kLeastStripes = 4;      // pixels from one to the next
constexpr double kArrow = 34, kPin = 5;  // pixels
constexpr double kWordsAir = 6;

QPolygonF onCloth(const SheetMap& onScreen, const Points2& line) {
    QPolygonF polygon;
    polygon.reserve(line.rows());
    for (Eigen::Index k = 0; k < line.rows(); ++k) {
        polygon << onScreen(Eigen::Vector2d(line.row(k)));
    }
    return polygon;
}

QColor faded(QColor colour, int alpha) {
    colour.setAlpha(alpha);
    return colour;
}

/// Lines across a box, one every `step` from `origin`.
void paintStripes(QPainter& painter, const SheetMap& onScreen, const Eigen::AlignedBox2d& box,
                  int axis, double step, double origin) {
    if (!(step * onScreen.pixelsPerMillimetre() >= kLeastStripes)) {
        return;
    }
    const double first = std::ceil((box.min()[axis] - origin) / step);
    const auto count = static_cast<int>(std::floor((box.max()[axis] - origin) / step) - first) + 1;
    for (int k = 0; k < count; ++k) {
        Eigen::Vector2d from = box.min(), to = box.max();
        from[axis] = to[axis] = origin + (first + k) * step;
        painter.drawLine(onScreen(from), onScreen(to));
    }
}

void paintRepeat(QPainter& painter, const RenderStyle& style, const SheetMap& onScreen,
                 const Eigen::AlignedBox2d& cloth, const ClothRepeat& repeat) {
    painter.setPen(QPen(faded(style.reference, 110), 1));
    if (repeat.warp > 0) {
        paintStripes(painter, onScreen, cloth, 0, repeat.warp, repeat.origin.x());
    }
    if (repeat.weft > 0) {
        paintStripes(painter, onScreen, cloth, 1, repeat.weft, repeat.origin.y());
    }
}

/// A roll: selvedges on both sides, or the fold on the lower one; it goes on beyond its end.
void paintRoll(QPainter& painter, const RenderStyle& style, const SheetMap& onScreen,
               const ClothMarker& marker, bool isFolded) {
    const QPointF upperLeft = onScreen(Eigen::Vector2d(0, marker.width));
    const QPointF upperRight = onScreen(Eigen::Vector2d(marker.length, marker.width));
    const QPointF lowerLeft = onScreen(Eigen::Vector2d(0, 0));
    const QPointF lowerRight = onScreen(Eigen::Vector2d(marker.length, 0));
    painter.setPen(QPen(style.text, kSelvedge, Qt::SolidLine, Qt::FlatCap));
    painter.drawLine(upperLeft, upperRight);
    painter.setPen(
        QPen(style.text, kSelvedge, isFolded ? Qt::DashDotLine : Qt::SolidLine, Qt::FlatCap));
    painter.drawLine(lowerLeft, lowerRight);
    painter.setPen(QPen(style.text, 1));
    painter.drawLine(upperLeft, lowerLeft);
    painter.setPen(QPen(style.text, 1.4, Qt::DashLine));
    painter.drawLine(upperRight, lowerRight);
    const QFontMetricsF metrics(painter.font());
    painter.setPen(style.faintText);
    painter.drawText(upperLeft + QPointF(0, -kWordsAir),
                     QCoreApplication::translate("ClothView", "selvedge"));
    const double below = metrics.ascent() + kWordsAir;
    painter.drawText(lowerLeft + QPointF(0, below),
                     isFolded ? QCoreApplication::translate("ClothView", "fold of the cloth")
                              : QCoreApplication::translate("ClothView", "selvedge"));
    const QString warp = QCoreApplication::translate("ClothView", "warp");
    const double width = metrics.horizontalAdvance(warp);
    const QPointF at = lowerRight + QPointF(-width - kArrow - kWordsAir, below);
    if (at.x() > lowerLeft.x() + 2 * width) {
        painter.drawText(at, warp);
        const QPointF tail = at + QPointF(width + kWordsAir, -0.35 * metrics.ascent());
        paintArrow(painter, style, tail, tail + QPointF(kArrow - kWordsAir, 0), false, true);
    }
    painter.setPen(style.text);
    const QString length = lengthWithUnit(marker.length);
    painter.drawText(upperRight + QPointF(-metrics.horizontalAdvance(length), -kWordsAir), length);
}

void paintParts(QPainter& painter, const RenderStyle& style, const SheetMap& onScreen,
                const ClothMarker& marker) {
    for (const ClothPart& part : marker.parts) {
        painter.setPen(QPen(style.text, 1.6));
        painter.setBrush(Qt::NoBrush);
        painter.drawPolygon(onCloth(onScreen, part.outline));
        for (const HideZone& zone : part.zones) {
            const QPolygonF polygon = onCloth(onScreen, zone.outline);
            painter.setPen(QPen(style.text, 1));
            painter.setBrush(zone.grade == 0
                                 ? QBrush(style.bottom)
                                 : QBrush(faded(style.reference, 60), Qt::BDiagPattern));
            painter.drawPolygon(polygon);
            if (zone.grade > 0) {
                painter.drawText(
                    polygon.boundingRect(), Qt::AlignCenter,
                    QCoreApplication::translate("ClothView", "grade %1").arg(zone.grade));
            }
        }
    }
}

/// A pin that holds a piece down, its tip at the place.
void paintPin(QPainter& painter, const RenderStyle& style, const QPointF& tip) {
    const QPointF head = tip + QPointF(kPin, -2.2 * kPin);
    painter.setPen(QPen(style.text, 1.6));
    painter.drawLine(tip, head);
    painter.setPen(QPen(style.labelFill, 1));
    painter.setBrush(style.selection);
    painter.drawEllipse(head, kPin, kPin);
}

void paintShape(QPainter& painter, const RenderStyle& style, const SheetMap& onScreen,
                const ClothShape& shape) {
    const QPolygonF edge = onCloth(onScreen, shape.edge);
    painter.setPen(QPen(shape.isMisplaced  ? misplacedColour()
                        : shape.isSelected ? style.selection
                                           : style.outline,
                        shape.isMisplaced || shape.isSelected ? 2.4 : 1.2, Qt::SolidLine,
                        Qt::RoundCap, Qt::RoundJoin));
    painter.setBrush(shape.colour);
    painter.drawPolygon(edge);
    if (shape.isMisplaced) {
        painter.setBrush(faded(misplacedColour(), 70));
        painter.drawPolygon(edge);
        painter.setBrush(QBrush(faded(misplacedColour(), 200), Qt::BDiagPattern));
        painter.drawPolygon(edge);
    }
    if (shape.seam.rows() > 0) {
        painter.setPen(QPen(faded(style.outline, 130), 0.8));
        painter.setBrush(Qt::NoBrush);
        painter.drawPolygon(onCloth(onScreen, shape.seam));
    }
}

/// The name where there is room for it, the arrow of the grain below.
void paintWords(QPainter& painter, const RenderStyle& style, const SheetMap& onScreen,
                const ClothShape& shape) {
    const QRectF room = onCloth(onScreen, shape.edge).boundingRect();
    const QPointF at = onScreen(shape.label);
    const QSizeF size = labelSize(painter.font(), shape.name, shape.isSelected);
    const bool hasName = size.width() <= room.width() && 2 * size.height() <= room.height();
    const QPointF arrow = at + QPointF(0, hasName ? 0.95 * size.height() : 0);
    const QPointF way = 0.5 * kArrow * QPointF(shape.grain.x(), -shape.grain.y());
    const QPolygonF edge = onCloth(onScreen, shape.edge);
    if (edge.containsPoint(arrow - way, Qt::OddEvenFill) &&
        edge.containsPoint(arrow + way, Qt::OddEvenFill)) {
        paintArrow(painter, style, arrow - way, arrow + way, shape.isSelected, shape.isStated);
    }
    if (hasName) {
        paintLabel(painter, style, QRectF(at - QPointF(size.width() / 2, size.height() / 2), size),
                   shape.name, shape.isSelected);
    }
    if (shape.isKept) {
        paintPin(painter, style, at + QPointF(hasName ? size.width() / 2 : 0, -size.height() / 2));
    }
}

}  // namespace

QColor misplacedColour() {
    return {220, 24, 24};
}

const Eigen::Vector2d& ClothLabels::of(const std::shared_ptr<const Pattern>& pattern, int piece) {
    if (pattern != pattern_) {
        pattern_ = pattern;
        places_.assign(pattern->pieces.size(), std::nullopt);
    }
    auto& place = places_[static_cast<std::size_t>(piece)];
    if (!place) {
        const PatternPiece& laid = pattern->pieces[static_cast<std::size_t>(piece)];
        FreeCloth cloth{{laid.outline}};
        cloth.loops.insert(cloth.loops.end(), laid.holes.begin(), laid.holes.end());
        const auto pole = circlePole(cloth, {0.02, 0.3});
        place = pole ? pole->place : Eigen::Vector2d(laid.outline.colwise().mean());
    }
    return *place;
}

void paintCloth(QPainter& painter, const RenderStyle& style, const SheetMap& onScreen,
                const ClothMarker& marker, const MarkerSettings& settings, const QColor& ground) {
    painter.save();
    const bool isRoll = marker.isRoll;
    const Eigen::AlignedBox2d cloth(Eigen::Vector2d::Zero(),
                                    Eigen::Vector2d(marker.length, marker.width));
    QPainterPath area;
    if (isRoll) {
        area.addRect(onScreen(cloth));
    }
    for (const ClothPart& part : isRoll ? std::vector<ClothPart>() : marker.parts) {
        area.addPolygon(onCloth(onScreen, part.outline));
        area.closeSubpath();
    }
    painter.fillPath(area, ground);
    painter.save();
    painter.setClipPath(area);
    paintRepeat(painter, style, onScreen, cloth, settings.repeat);
    painter.restore();
    if (isRoll) {
        paintRoll(painter, style, onScreen, marker, settings.isFolded);
    } else {
        paintParts(painter, style, onScreen, marker);
    }
    painter.restore();
}

void paintCopies(QPainter& painter, const RenderStyle& style, const SheetMap& onScreen,
                 const std::vector<ClothShape>& shapes) {
    painter.save();
    std::vector<const ClothShape*> order;
    order.reserve(shapes.size());
    for (const ClothShape& shape : shapes) {
        order.push_back(&shape);
    }
    std::ranges::stable_sort(order, {}, [](const ClothShape* shape) -> int {
        return (shape->isMisplaced ? 1 : 0) + (shape->isSelected ? 2 : 0);
    });
    for (const ClothShape* shape : order) {
        paintShape(painter, style, onScreen, *shape);
    }
    for (const ClothShape* shape : order) {
        paintWords(painter, style, onScreen, *shape);
    }
    painter.restore();
}

}  // namespace toile::app
