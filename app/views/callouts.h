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

/// A numbered mark at a place that needs attention.
struct Callout {
    QPointF at;          ///< logical pixels
    int number = 1;      ///< the same in every view
    QString text;        ///< "+12.4 %"
    bool faint = false;  ///< on the far side of the cloth
};

/// The part of a view that callouts can use. Logical pixels.
struct CalloutRoom {
    QRectF view;                  ///< callouts outside it are left out
    std::vector<QRectF> taken{};  ///< areas of other words, which labels avoid
    /// Drawn lines, which labels avoid if they can.
    std::vector<QPolygonF> lines{};
};

/// Draws a ring at each place, with a label of number and text; see `calloutBoxes`.
void paintCallouts(QPainter& painter, const RenderStyle& style, const CalloutRoom& room,
                   const std::vector<Callout>& callouts);

/// Returns one label box per callout: inside the view and, if possible, clear of other labels and
/// of taken areas. Among free places, picks the nearest with the fewest crossings of label and
/// leader. Returns empty rectangles for omitted callouts. Cost: linear in the points of the lines.
std::vector<QRectF> calloutBoxes(const QFont& font, const CalloutRoom& room,
                                 const std::vector<Callout>& callouts);

/// Draws a ring that is visible on any cloth around a place the user asked to see.
void paintSpotRing(QPainter& painter, const RenderStyle& style, const QPointF& at);

/// The computed worst spots of an overlay.
struct FlaggedSpots {
    std::vector<WorstSpot> spots{};
    Overlay overlay = Overlay::None;  ///< the overlay of the values
};

/// Position of a spot in a view, logical pixels.
struct SpotPlace {
    QPointF at;
    bool behind = false;  ///< its cloth is seen from the back
};

/// Position of a spot between the designed (0) and the sewn cloth (1). Stays as designed if the
/// sewn position is unknown.
Eigen::Vector3d spotPoint(const WorstSpot& spot, double sewnWay);

/// Returns nullopt if the spot is behind the eye.
/// @param sewnWay  as for `GarmentRenderer::paint`
std::optional<SpotPlace> placeOfSpot(const WorstSpot& spot, const Camera3D& camera,
                                     double sewnWay = 0);
SpotPlace placeOfSpot(const WorstSpot& spot, const Camera2D& camera, const SheetPlaces& places);

/// Marks those spots that the document shows, if it has marking turned on.
void paintSpotCallouts(QPainter& painter, const RenderStyle& style, const CalloutRoom& room,
                       const Document& document, const FlaggedSpots& flagged,
                       const std::function<std::optional<SpotPlace>(const WorstSpot&)>& place);

}  // namespace toile::app
