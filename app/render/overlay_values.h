// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>

#include "app/render/scene.h"
#include "app/render/sheet_places.h"

namespace toile {

struct Fabric;

/// What the fabric allows of a quantity; none where a fabric sets no limit to it. A strain that has
/// no direction is held to the tightest limits of all directions. In percent.
struct OverlayLimits {
    double least = 0, most = 0;
};

std::optional<OverlayLimits> fabricLimits(Overlay overlay, const Fabric& fabric);

/// The ends of the colour bar: the fabric's limits where it sets any, else the span that shows 98 %
/// of the garment's values. Cost: none to speak of.
OverlayScale overlayScale(const Scene& scene, Overlay overlay, const Fabric& fabric);

/// What the mesh knows of a place: what its vertices and triangles carry.
struct OverlaySample {
    float values[4];  ///< area change %, angle change degrees, largest and least edge strain %
    float metric[3];  ///< E, F, G
};

/// The number an overlay shows, in its unit; 0 for one that shows none. Of two numbers (the
/// edges, the diagonals, the principal strains) the one nearer to the end of its side. The same
/// formulas as in resources/shaders/surface.glsl.
/// @param grain direction of the warp in the piece's coordinates, a unit vector
double overlayValue(Overlay overlay, const OverlaySample& sample, const Eigen::Vector2d& grain,
                    const OverlayScale& scale);

/// Of a vertex, or of a triangle alone.
template <class Carrier>
OverlaySample sampleOf(const Carrier& carrier) {
    OverlaySample sample{};
    std::copy_n(carrier.values, 4, sample.values);
    std::copy_n(carrier.metric, 3, sample.metric);
    return sample;
}

/// What is drawn in the middle of a triangle, or elsewhere in it.
/// @param face        counted in Scene::pattern
/// @param perTriangle as ViewState::valuesPerTriangle
OverlaySample sampleOf(const Scene& scene, std::size_t face, const Eigen::Vector3d& barycentric,
                       bool perTriangle);

/// Direction of the warp as a vector.
Eigen::Vector2d grainVector(const SheetPlaces& places, int piece);

/// A place on a piece.
struct SurfacePlace {
    int piece = -1;
    std::uint32_t face = 0;  ///< within the piece
    Eigen::Vector3d barycentric = Eigen::Vector3d::Constant(1.0 / 3);
};

/// What is drawn at a place, as a number; none where the piece is not flat, the overlay shows no
/// number or the place is not on the piece. Cost: none to speak of.
/// @param perTriangle as ViewState::valuesPerTriangle
std::optional<double> valueAt(const Scene& scene, const SheetPlaces& places,
                              const SurfacePlace& place, Overlay overlay, const OverlayScale& scale,
                              bool perTriangle);

}  // namespace toile
