// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFont>
#include <QPointF>
#include <QPolygonF>
#include <QRectF>
#include <QString>
#include <functional>
#include <optional>
#include <vector>

#include "app/document/view_state.h"
#include "app/render/camera.h"
#include "app/render/overlay_figures.h"
#include "app/render/scene.h"

class QPainter;

namespace toile::app {

class Document;
struct RenderStyle;

/// A place that asks for a person's eye.
struct Callout {
    QPointF at;          ///< logical pixels
    int number = 1;      ///< the same in every view
    QString text;        ///< "+12.4 %"
    bool faint = false;  ///< on the far side of the cloth
};

/// What callouts may use of a view. Logical pixels.
struct CalloutRoom {
    QRectF view;                  ///< callouts outside of it are left out
    std::vector<QRectF> taken{};  ///< by other words: labels stay beside them
    /// Drawn: where there is a choice, labels lie beside them.
    std::vector<QPolygonF> lines{};
};

/// A ring at each place and beside it a label with its number and text; see `calloutBoxes`.
void paintCallouts(QPainter& painter, const RenderStyle& style, const CalloutRoom& room,
                   const std::vector<Callout>& callouts);

/// The labels of the callouts, one each: within the view and, where there is a way, neither on each
/// other nor on what is taken; of such places the nearest at which label and leader cross least.
/// Cost: linear in the points of the lines. Empty rectangles for callouts that are left out.
std::vector<QRectF> calloutBoxes(const QFont& font, const CalloutRoom& room,
                                 const std::vector<Callout>& callouts);

/// A ring around a place that a person has asked for: it reads on any cloth.
void paintSpotRing(QPainter& painter, const RenderStyle& style, const QPointF& at);

/// The worst spots of an overlay, as they were worked out.
struct FlaggedSpots {
    std::vector<WorstSpot> spots{};
    Overlay overlay = Overlay::None;  ///< whose values they are
};

/// Where a spot is in a view, logical pixels.
struct SpotPlace {
    QPointF at;
    bool behind = false;  ///< its cloth is seen from behind
};

/// Where a spot lies on the garment, on its way to sewn cloth: at 0, or where its place on that is
/// not known, as designed.
Eigen::Vector3d spotPoint(const WorstSpot& spot, double sewnWay);

/// None where it is behind the eye.
/// @param sewnWay  as for `GarmentRenderer::paint`
std::optional<SpotPlace> placeOfSpot(const WorstSpot& spot, const Camera3D& camera,
                                     double sewnWay = 0);
SpotPlace placeOfSpot(const WorstSpot& spot, const Camera2D& camera, const SheetPlaces& places);

/// Marks the spots, as far as they are of what the document shows and it wants them marked.
void paintSpotCallouts(QPainter& painter, const RenderStyle& style, const CalloutRoom& room,
                       const Document& document, const FlaggedSpots& flagged,
                       const std::function<std::optional<SpotPlace>(const WorstSpot&)>& place);

}  // namespace toile::app
