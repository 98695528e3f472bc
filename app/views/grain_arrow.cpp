// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/views/grain_arrow.h"

#include <QPainter>
#include <QPolygonF>
#include <algorithm>
#include <cmath>

#include <Eigen/LU>

#include "app/document/document.h"
#include "app/document/layout.h"
#include "app/document/piece_edits.h"
#include "app/render/picking.h"
#include "app/render/render_style.h"
#include "app/render/scene.h"
#include "app/text/error_text.h"
#include "app/views/tool.h"
#include "core/pattern/piece_grain.h"

namespace toile::app {
namespace {

constexpr double kWellSeen = 28;           // pixels
constexpr double kShortest = 16;           // pixels, even on narrow cloth
constexpr double kHead = 10;               // pixels
constexpr double kHalo = 3.2;              // pixels, both sides together
constexpr double kDash = 3.2, kGap = 2.4;  // widths of the line

void paintArrow(QPainter& painter, const QPointF& tail, const QPointF& tip, const QColor& colour,
                const QColor& halo, double width, bool stated) {
    const QPointF way = tip - tail;
    const double length = std::hypot(way.x(), way.y());
    const QPointF along = way / length, across(-along.y(), along.x());
    const double head = std::min(kHead, 0.35 * length);
    const QPolygonF triangle{tip, tip - head * along + 0.42 * head * across,
                             tip - head * along - 0.42 * head * across};
    const QPointF neck = tip - 0.8 * head * along;
    for (const bool isHalo : {true, false}) {
        QPen pen(isHalo ? halo : colour, isHalo ? width + kHalo : width, Qt::SolidLine,
                 isHalo || stated ? Qt::RoundCap : Qt::FlatCap, Qt::RoundJoin);
        if (!isHalo && !stated) {
            pen.setDashPattern({kDash, kGap});
        }
        painter.setPen(pen);
        painter.drawLine(tail, neck);
        painter.setBrush(isHalo ? Qt::NoBrush : QBrush(colour));
        if (!isHalo) {
            painter.setPen(Qt::NoPen);
        }
        painter.drawPolygon(triangle);
    }
}

}  // namespace

std::optional<GrainArrow> grainArrow(const Document& document, int piece,
                                     double pixelsPerMillimetre) {
    const PieceResult* result = document.result(piece);
    const auto index = static_cast<std::size_t>(piece);
    if (!document.scene() || index >= document.scene()->pieces.size() || !result || !result->flat) {
        return std::nullopt;
    }
    const Placement placement = placementOf(document, piece);
    const PieceMarks& marks = document.marks().of(document, piece, drawingWords());
    const double grain = grainOf(document.settings()[index]);
    const Eigen::Vector2d direction =
        placement.linear() * Eigen::Vector2d(std::cos(grain), std::sin(grain));
    std::optional<Chord> line = marks.grain;
    const bool isWellSeen =
        line && (line->to - line->from).norm() * pixelsPerMillimetre >= kWellSeen;
    if (!isWellSeen) {
        const auto clear = document.marks().clearGrain(document, piece);
        line = clear ? clear : line;
    }
    const Chord at = line.value_or(Chord{marks.label.position, marks.label.position});
    return GrainArrow{placement.offset + 0.5 * (at.from + at.to), direction,
                      std::max((at.to - at.from).norm(), kShortest / pixelsPerMillimetre)};
}

void paintArrow(QPainter& painter, const RenderStyle& style, const QPointF& tail,
                const QPointF& tip, bool marked, bool stated) {
    painter.save();
    paintArrow(painter, tail, tip, marked ? style.selection : style.text, style.labelFill,
               marked ? 2.4 : 2.0, marked || stated);
    painter.restore();
}

std::vector<DrawnArrow> paintGrainArrows(QPainter& painter, const RenderStyle& style,
                                         const SheetMap& onScreen, const Document& document,
                                         bool strong) {
    std::vector<DrawnArrow> arrows;
    painter.save();
    for (int piece = 0; piece < document.pieceCount(); ++piece) {
        if (isHidden(document, piece)) {
            continue;
        }
        const double scale = onScreen.pixelsPerMillimetre();
        const auto arrow = grainArrow(document, piece, scale);
        if (!arrow) {
            continue;
        }
        const auto at = static_cast<std::size_t>(piece);
        const double extent = document.scene()->pieces[at].flatBox.diagonal().norm() * scale;
        if (!strong && extent < kShortest) {
            continue;  // longer than the piece itself
        }
        const QLineF line(onScreen(arrow->end(-0.5)), onScreen(arrow->end(0.5)));
        paintArrow(painter, line.p1(), line.p2(), style.text, style.labelFill, strong ? 2.2 : 1.8,
                   document.settings()[at].grain.has_value());
        arrows.push_back({piece, line});
    }
    painter.restore();
    return arrows;
}

void paintMarkedArrow(QPainter& painter, const RenderStyle& style, const ToolView& view,
                      const GrainArrow& arrow) {
    const SheetMap onScreen(view);
    painter.save();
    paintArrow(painter, onScreen(arrow.end(-0.5)), onScreen(arrow.end(0.5)), style.selection,
               style.labelFill, 2.4, true);
    painter.setPen(QPen(style.selection, 1.5));
    painter.setBrush(style.labelFill);
    painter.drawEllipse(onScreen(arrow.middle), 3.5, 3.5);
    painter.restore();
}

namespace {

constexpr double kLength = 120;        // mm
constexpr double kOfPiece = 0.4;       // of the piece's smaller side, at most
constexpr double kShortestArrow = 10;  // pixels

}  // namespace

std::optional<GarmentArrows::NamePlace> GarmentArrows::namePlaceOf(const Scene& scene, int piece) {
    const PieceScene& drawn = scene.pieces[static_cast<std::size_t>(piece)];
    const auto hit = pickPiece(scene, piece, drawn.label);
    if (!hit) {
        return std::nullopt;
    }
    const auto corner = [&](int k) -> Eigen::Vector2d {
        return patternPoint(scene, piece, hit->face, Eigen::Vector3d::Unit(k));
    };
    NamePlace place{hit->face, corner(0), {}, drawn.label};
    Eigen::Matrix2d sides;
    sides << corner(1) - place.origin, corner(2) - place.origin;
    place.weights = sides.inverse();
    return place.weights.allFinite() ? std::optional(place) : std::nullopt;
}

void GarmentArrows::find(const std::shared_ptr<const Scene>& scene) {
    if (scene == scene_.lock() && (scene || namePlaces_.empty())) {
        return;
    }
    scene_ = scene;
    namePlaces_.clear();
    for (std::size_t i = 0; scene && i < scene->pieces.size(); ++i) {
        namePlaces_.push_back(namePlaceOf(*scene, static_cast<int>(i)));
    }
}

void GarmentArrows::paint(QPainter& painter, const RenderStyle& style, const ToolView& view,
                          const Document& document, int marked) {
    find(document.scene());
    for (int piece = 0; piece < static_cast<int>(namePlaces_.size()); ++piece) {
        const auto at = static_cast<std::size_t>(piece);
        if (!namePlaces_[at] || at >= document.settings().size()) {
            continue;
        }
        const NamePlace& place = *namePlaces_[at];
        // Extrapolating beyond the face's corners is fine: its plane continues.
        const auto onScreen = [&](const Eigen::Vector2d& flat) -> std::optional<QPointF> {
            const Eigen::Vector2d weights = place.weights * (flat - place.origin);
            return view.onScreen(piece, place.face, {1 - weights.sum(), weights.x(), weights.y()});
        };
        const double grain = grainOf(document.settings()[at]);
        const Eigen::Vector2d way(std::cos(grain), std::sin(grain));
        const Eigen::Vector2d sizes = document.scene()->pieces[at].flatBox.sizes();
        const double half = 0.5 * std::min(kLength, kOfPiece * sizes.minCoeff());
        const auto tail = onScreen(place.label - half * way),
                   tip = onScreen(place.label + half * way);
        if (!tail || !tip) {
            continue;
        }
        const QPointF along = *tip - *tail;
        if (std::hypot(along.x(), along.y()) < kShortestArrow) {
            continue;
        }
        const auto hit = view.hitAt(0.5 * (*tip + *tail));
        if (hit && hit->piece == piece) {
            paintArrow(painter, style, *tail, *tip, piece == marked,
                       document.settings()[at].grain.has_value());
        }
    }
}

}  // namespace toile::app
