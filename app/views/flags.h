// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFont>
#include <QPointF>
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
struct Flag {
    QPointF at;          ///< logical pixels
    int number = 1;      ///< the same in every view
    QString text;        ///< "+12.4 %"
    bool faint = false;  ///< on the far side of the cloth
};

/// What flags may use of a view. Logical pixels.
struct FlagRoom {
    QRectF view;                  ///< flags outside of it are left out
    std::vector<QRectF> taken{};  ///< by other words: plates stay beside them
};

/// A ring at each place and beside it a plate with its number and text; see `flagPlates`.
void paintFlags(QPainter& painter, const RenderStyle& style, const FlagRoom& room,
                const std::vector<Flag>& flags);

/// The plates of the flags, one each: within the view and, where there is a way, neither on each
/// other nor on what is taken. Empty rectangles for flags that are left out.
std::vector<QRectF> flagPlates(const QFont& font, const FlagRoom& room,
                               const std::vector<Flag>& flags);

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

/// None where it is behind the eye.
std::optional<SpotPlace> placeOfSpot(const WorstSpot& spot, const Camera3D& camera);
SpotPlace placeOfSpot(const WorstSpot& spot, const Camera2D& camera, const SheetPlaces& places);

/// Flags the spots, as far as they are of what the document shows and it wants them flagged.
void paintSpotFlags(QPainter& painter, const RenderStyle& style, const FlagRoom& room,
                    const Document& document, const FlaggedSpots& flagged,
                    const std::function<std::optional<SpotPlace>(const WorstSpot&)>& place);

}  // namespace toile::app
