// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/views/spot_flags.h"

#include "app/document/document.h"
#include "app/render/scene.h"
#include "app/text/overlay_text.h"
#include "app/views/flags.h"

namespace toile {

std::optional<SpotPlace> placeOfSpot(const WorstSpot& spot, const Camera3D& camera) {
    if (!camera.isBefore(spot.position)) {
        return std::nullopt;
    }
    const Eigen::Vector2d at = camera.project(spot.position);
    const Eigen::Vector3d toEye = camera.isOrthographic()
                                      ? Eigen::Vector3d(camera.axes().col(2))
                                      : Eigen::Vector3d(camera.eye() - spot.position);
    return SpotPlace{{at.x(), at.y()}, spot.normal.dot(toEye) < 0};
}

SpotPlace placeOfSpot(const WorstSpot& spot, const Camera2D& camera, const SheetPlaces& places) {
    const Eigen::Vector2d at =
        camera.toScreen(placeOf(places, spot.piece).placement.applied(spot.flat));
    return {{at.x(), at.y()}, false};
}

void paintSpotFlags(QPainter& painter, const RenderStyle& style, const FlagRoom& room,
                    const Document& document, const FlaggedSpots& flagged,
                    const std::function<std::optional<SpotPlace>(const WorstSpot&)>& place) {
    const Scene* scene = document.scene().get();
    if (!document.view().worstSpots || flagged.overlay != document.view().overlay || !scene) {
        return;
    }
    std::vector<Flag> flags;
    for (std::size_t i = 0; i < flagged.spots.size(); ++i) {
        // They may be of the scene before, for a moment.
        const WorstSpot& spot = flagged.spots[i];
        const auto piece = static_cast<std::size_t>(spot.piece);
        if (piece < scene->pieces.size() && scene->pieces[piece].flat) {
            if (const auto seen = place(spot)) {
                flags.push_back({seen->at, static_cast<int>(i) + 1,
                                 overlayValueText(flagged.overlay, spot.value), seen->behind});
            }
        }
    }
    paintFlags(painter, style, {room.view.adjusted(4, 4, -4, -4), room.taken}, flags);
}

}  // namespace toile
