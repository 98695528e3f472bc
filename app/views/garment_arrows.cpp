// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/views/garment_arrows.h"

#include <QPainter>
#include <algorithm>
#include <cmath>

#include <Eigen/LU>

#include "app/document/document.h"
#include "app/document/layout.h"
#include "app/render/picking.h"
#include "app/render/render_style.h"
#include "app/views/grain_arrow.h"
#include "app/views/tool_view.h"

namespace toile::app {

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
        // The face's plane goes on beyond its corners.
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
