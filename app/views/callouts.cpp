// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/views/callouts.h"

#include <QFontMetricsF>
#include <QPainter>
#include <QPainterPath>
#include <algorithm>

#include "app/document/document.h"
#include "app/render/render_style.h"
#include "app/render/scene.h"
#include "app/text/figures.h"
#include "app/views/view_text.h"

namespace toile::app {

namespace {

constexpr double kRing = 4.5;  ///< radius
constexpr double kAway = 13;   ///< offset of the label from the place, along both axes
constexpr double kPadding = 6;
constexpr double kBadge = 17;  ///< width of the number's part of the label
constexpr int kOverWords = 9;  ///< crossed lines that weigh as much as one leader over other words
constexpr int kMaxSteps = 24;  ///< of half a label, when searching for a free place

bool overlaps(const QRectF& box, const std::vector<QRectF>& taken) {
    return std::ranges::any_of(
        taken, [&box](const QRectF& other) -> bool { return box.intersects(other); });
}

QPointF nearestOn(const QRectF& box, const QPointF& at) {
    return {std::clamp(at.x(), box.left() + 3, box.right() - 3),
            std::clamp(at.y(), box.top(), box.bottom())};
}

bool meets(const QRectF& box, const QPolygonF& line) {
    for (qsizetype i = 1; i < line.size(); ++i) {
        if (crosses({line[i - 1], line[i]}, box)) {
            return true;
        }
    }
    return false;
}

/// Counts crossings: drawn lines with the label, other words with its leader.
int crossed(const QPointF& at, const QRectF& box, const std::vector<QRectF>& taken,
            const std::vector<QPolygonF>& lines) {
    const QLineF leader(at, nearestOn(box, at));
    const auto words = std::ranges::count_if(taken, [&](const QRectF& other) -> bool {
        return !other.contains(at) && crosses(leader, other);
    });
    const auto drawn = std::ranges::count_if(
        lines, [&box](const QPolygonF& line) -> bool { return meets(box, line); });
    return static_cast<int>(kOverWords * words + drawn);
}

/// Prefers the upper right; else another corner, level with the place, or farther away.
QRectF boxFor(const QPointF& at, const QSizeF& size, const QRectF& view,
              const std::vector<QRectF>& taken, const std::vector<QPolygonF>& lines) {
    std::optional<QRectF> best;
    int least = 0;
    for (const double away : {kAway, 2.5 * kAway, 4 * kAway}) {
        const double right = kAway, left = -kAway - size.width();
        const double above = -away - size.height(), below = away;
        const double level = -0.5 * size.height();
        for (const QPointF& corner :
             {QPointF(right, above), QPointF(left, above), QPointF(right, below),
              QPointF(left, below), QPointF(away, level), QPointF(-away - size.width(), level)}) {
            const QRectF box(at + corner, size);
            if (!view.contains(box) || overlaps(box, taken)) {
                continue;
            }
            const int price = crossed(at, box, taken, lines);
            if (!best || price < least) {
                best = box;
                least = price;
            }
        }
    }
    if (best) {
        return *best;
    }
    // In a corner or a crowd: push it into the view, then up or down until it is free.
    QRectF box(at + QPointF(kAway, -kAway - size.height()), size);
    box.moveLeft(std::max(view.left(), std::min(box.left(), view.right() - size.width())));
    const auto atHeight = [&](double top) -> QRectF {
        const double lowest = std::max(view.top(), view.bottom() - size.height());
        return {QPointF(box.left(), std::clamp(top, view.top(), lowest)), size};
    };
    for (int step = 0; step <= kMaxSteps; ++step) {
        for (const int way : {1, -1}) {
            const QRectF moved = atHeight(box.top() + way * step * size.height() / 2);
            if (!overlaps(moved, taken)) {
                return moved;
            }
        }
    }
    return atHeight(box.top());
}

QFont calloutFont(QFont font) {
    font.setPointSizeF(std::max(6.5, font.pointSizeF() * 0.9));
    font.setWeight(QFont::DemiBold);
    return font;
}

void paintCallout(QPainter& painter, const RenderStyle& style, const Callout& callout,
                  const QRectF& box) {
    painter.save();
    painter.setOpacity(callout.faint ? 0.5 : 1.0);
    const QPointF end = nearestOn(box, callout.at);
    QColor halo = style.labelFill;
    halo.setAlpha(230);
    for (const auto& [colour, width] : {std::pair(halo, 4.0), std::pair(style.text, 1.5)}) {
        painter.setPen(QPen(colour, width, callout.faint ? Qt::DotLine : Qt::SolidLine));
        painter.setBrush(Qt::NoBrush);
        painter.drawLine(callout.at, end);
        painter.drawEllipse(callout.at, kRing, kRing);
    }
    painter.setPen(QPen(style.text, 1));
    painter.setBrush(halo);
    painter.drawRoundedRect(box, 4, 4);
    QPainterPath badge;
    badge.addRoundedRect(QRectF(box.topLeft(), QSizeF(kBadge, box.height())), 4, 4);
    painter.fillPath(badge, style.text);
    painter.setPen(halo);
    painter.drawText(QRectF(box.topLeft(), QSizeF(kBadge, box.height())), Qt::AlignCenter,
                     QString::number(callout.number));
    painter.setPen(style.text);
    painter.drawText(box.adjusted(kBadge, 0, 0, 0), Qt::AlignCenter, callout.text);
    painter.restore();
}

}  // namespace

void paintSpotRing(QPainter& painter, const RenderStyle& style, const QPointF& at) {
    constexpr double kRadius = 15, kGap = 5, kTick = 6;
    painter.save();
    painter.setBrush(Qt::NoBrush);
    for (const auto& [colour, width] :
         {std::pair(style.seamHalo, 5.0), std::pair(style.seam, 2.2)}) {
        painter.setPen(QPen(colour, width, Qt::SolidLine, Qt::RoundCap));
        painter.drawEllipse(at, kRadius, kRadius);
        for (const QPointF& way : {QPointF(1, 0), QPointF(-1, 0), QPointF(0, 1), QPointF(0, -1)}) {
            painter.drawLine(at + (kRadius - kGap) * way, at + (kRadius + kTick) * way);
        }
    }
    painter.restore();
}

std::vector<QRectF> calloutBoxes(const QFont& font, const CalloutRoom& room,
                                 const std::vector<Callout>& callouts) {
    const QFontMetricsF metrics(calloutFont(font));
    std::vector<QRectF> taken = room.taken;
    for (const Callout& callout : callouts) {
        if (room.view.contains(callout.at)) {
            taken.emplace_back(callout.at.x() - kRing, callout.at.y() - kRing, 2 * kRing,
                               2 * kRing);
        }
    }
    std::vector<QRectF> boxes;
    for (const Callout& callout : callouts) {
        QRectF& box = boxes.emplace_back();
        if (room.view.contains(callout.at)) {
            const QSizeF size(kBadge + metrics.horizontalAdvance(callout.text) + 2 * kPadding,
                              metrics.height() + 3);
            box = boxFor(callout.at, size, room.view, taken, room.lines);
            taken.push_back(box);
        }
    }
    return boxes;
}

void paintCallouts(QPainter& painter, const RenderStyle& style, const CalloutRoom& room,
                   const std::vector<Callout>& callouts) {
    const std::vector<QRectF> boxes = calloutBoxes(painter.font(), room, callouts);
    painter.save();
    painter.setFont(calloutFont(painter.font()));
    for (std::size_t i = 0; i < callouts.size(); ++i) {
        if (!boxes[i].isEmpty()) {
            paintCallout(painter, style, callouts[i], boxes[i]);
        }
    }
    painter.restore();
}

Eigen::Vector3d spotPoint(const WorstSpot& spot, double sewnWay) {
    return spot.sewn ? Eigen::Vector3d((1 - sewnWay) * spot.position + sewnWay * *spot.sewn)
                     : spot.position;
}

std::optional<SpotPlace> placeOfSpot(const WorstSpot& spot, const Camera3D& camera,
                                     double sewnWay) {
    const Eigen::Vector3d place = spotPoint(spot, sewnWay);
    if (!camera.isBefore(place)) {
        return std::nullopt;
    }
    const Eigen::Vector2d at = camera.project(place);
    const Eigen::Vector3d toEye = camera.isOrthographic() ? Eigen::Vector3d(camera.axes().col(2))
                                                          : Eigen::Vector3d(camera.eye() - place);
    return SpotPlace{{at.x(), at.y()}, spot.normal.dot(toEye) < 0};
}

SpotPlace placeOfSpot(const WorstSpot& spot, const Camera2D& camera, const SheetPlaces& places) {
    const Eigen::Vector2d at =
        camera.toScreen(placeOf(places, spot.piece).placement.applied(spot.flat));
    return {{at.x(), at.y()}, false};
}

void paintSpotCallouts(QPainter& painter, const RenderStyle& style, const CalloutRoom& room,
                       const Document& document, const FlaggedSpots& flagged,
                       const std::function<std::optional<SpotPlace>(const WorstSpot&)>& place) {
    const Scene* scene = document.scene().get();
    if (!document.view().worstSpots || flagged.overlay != document.view().overlay || !scene) {
        return;
    }
    std::vector<Callout> callouts;
    for (std::size_t i = 0; i < flagged.spots.size(); ++i) {
        // For a moment, the spots may belong to the previous scene.
        const WorstSpot& spot = flagged.spots[i];
        const auto piece = static_cast<std::size_t>(spot.piece);
        if (piece < scene->pieces.size() && scene->pieces[piece].flat) {
            if (const auto seen = place(spot)) {
                callouts.push_back({seen->at, static_cast<int>(i) + 1,
                                    overlayValueText(flagged.overlay, spot.value), seen->behind});
            }
        }
    }
    paintCallouts(painter, style, {room.view.adjusted(4, 4, -4, -4), room.taken, room.lines},
                  callouts);
}

}  // namespace toile::app
