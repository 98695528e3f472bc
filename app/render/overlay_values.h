// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstdint>
#include <memory>
#include <optional>

#include "app/render/picking.h"
#include "app/render/scene.h"
#include "app/render/sewn_cloth.h"
#include "core/garment/fabric.h"

namespace toile {
struct Fabric;
}  // namespace toile

namespace toile::app {

/// What the fabric allows of a quantity; none where it sets no limit to it or is not stated. A
/// strain that has no direction is held to the tightest limits of all directions. In percent.
struct OverlayLimits {
    double least = 0, most = 0;
};

std::optional<OverlayLimits> fabricLimits(Overlay overlay, const Fabric& fabric);

/// The ends of the colour bar: the fabric's limits where it sets any, else the span that shows 98 %
/// of the garment's values. Cost: none to speak of.
/// @param sewn  for the overlays that are of it; null: there is none
OverlayScale overlayScale(const Scene& scene, Overlay overlay, const Fabric& fabric,
                          const SewnCloth* sewn = nullptr);

/// The same on one piece: of one that is cut from another fabric than the garment, with the limits
/// of that, or without any where that is not stated.
OverlayScale scaleOn(const SheetPlace& place, Overlay overlay, const OverlayScale& scale);

/// What the mesh knows of a place: what its vertices and triangles carry.
struct OverlaySample {
    float values[4];  ///< area change %, angle change degrees, largest and least edge strain %
    float metric[3];  ///< E, F, G
};

/// The number an overlay shows, in its unit; 0 for one that shows none, or that of sewn cloth
/// (`sewnValue`). Of two numbers (the
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

/// What is drawn at a place, as a number; none where the piece is not flat, the overlay shows no
/// number or the place is not on the piece. Cost: none to speak of.
/// @param scale       of the garment
/// @param perTriangle as ViewState::valuesPerTriangle
std::optional<double> valueAt(const Scene& scene, const SheetPlaces& places,
                              const SurfaceHit& place, Overlay overlay, const OverlayScale& scale,
                              bool perTriangle, const SewnCloth* sewn = nullptr);

/// How much of a garment its fabrics cannot do, as parts of its flat area. What counts as beyond is
/// every triangle that the overlays' histograms of warp, weft and bias count so.
struct FabricFit {
    /// The piece of which the largest part is strained beyond the fabric, in any direction.
    struct WorstPiece {
        int piece = -1;
        double share = 0;  ///< of its own flat area

        bool operator==(const WorstPiece&) const = default;
    };

    double warp = 0, weft = 0, bias = 0;
    double any = 0;                     ///< beyond in one of the directions at least
    std::optional<WorstPiece> worst{};  ///< none where nothing is beyond

    bool operator==(const FabricFit&) const = default;
};

/// All that the fit depends on.
struct FabricQuestion {
    std::shared_ptr<const Scene> scene{};  ///< may be null
    SheetPlaces places{};                  ///< for the grain and the materials' fabrics
    Fabric fabric{};                       ///< of the other pieces
};

/// True where the answer is the same: places on the sheet do not matter, grain and fabric do.
bool isSameQuestion(const FabricQuestion& one, const FabricQuestion& other);

/// None where there is no flat cloth. Pure, thread-safe. Cost: linear, some tenths of a second at a
/// million triangles.
std::optional<FabricFit> fabricFit(const FabricQuestion& question);

}  // namespace toile::app
