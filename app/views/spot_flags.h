// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPointF>
#include <functional>
#include <optional>
#include <vector>

#include "app/document/view_state.h"
#include "app/render/camera_2d.h"
#include "app/render/camera_3d.h"
#include "app/render/sheet_places.h"
#include "app/render/worst_spots.h"

class QPainter;

namespace toile {

class Document;
struct FlagRoom;
struct RenderStyle;

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

}  // namespace toile
