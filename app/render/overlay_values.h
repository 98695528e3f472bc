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

/// Limits of the fabric for a quantity, in percent; nullopt if it has none or is not chosen. Strain
/// without a direction uses the tightest limits of all directions.
struct OverlayLimits {
    double least = 0, most = 0;
};

std::optional<OverlayLimits> fabricLimits(Overlay overlay, const Fabric& fabric);

/// The ends of the colour bar: the fabric's limits if it has any, else the range of 98 % of the
/// garment's values. Cost: negligible.
/// @param sewn  needed by the overlays of sewn cloth; may be null
OverlayScale overlayScale(const Scene& scene, Overlay overlay, const Fabric& fabric,
                          const SewnCloth* sewn = nullptr);

/// The scale on one piece: with the limits of the piece's own fabric, or without limits if that has
/// none.
OverlayScale scaleOn(const SheetPlace& place, Overlay overlay, const OverlayScale& scale);

/// The data that a vertex or triangle of the mesh carries.
struct OverlaySample {
    float values[4];  ///< area change %, angle change degrees, largest and least edge strain %
    float metric[3];  ///< E, F, G
};

/// The overlay's value, in its unit; 0 for overlays without numbers and for sewn cloth
/// (`sewnValue`). If there are two values (edges, diagonals, principal strains), returns the one
/// with the larger severity. The formulas match those in resources/shaders/surface.glsl.
/// @param grain direction of the warp in the piece's coordinates, unit vector
double overlayValue(Overlay overlay, const OverlaySample& sample, const Eigen::Vector2d& grain,
                    const OverlayScale& scale);

/// The sample of a single vertex or triangle.
template <class Carrier>
OverlaySample sampleOf(const Carrier& carrier) {
    OverlaySample sample{};
    std::copy_n(carrier.values, 4, sample.values);
    std::copy_n(carrier.metric, 3, sample.metric);
    return sample;
}

/// The sample drawn at a place in a triangle.
/// @param face        index in Scene::pattern
/// @param perTriangle see ViewState::valuesPerTriangle
OverlaySample sampleOf(const Scene& scene, std::size_t face, const Eigen::Vector3d& barycentric,
                       bool perTriangle);

/// Direction of the warp as a unit vector.
Eigen::Vector2d grainVector(const SheetPlaces& places, int piece);

/// The value drawn at a place; nullopt if the piece is not flat, the overlay has no numbers or the
/// place is not on the piece. Cost: negligible.
/// @param scale       of the garment
/// @param perTriangle see ViewState::valuesPerTriangle
std::optional<double> valueAt(const Scene& scene, const SheetPlaces& places,
                              const SurfaceHit& place, Overlay overlay, const OverlayScale& scale,
                              bool perTriangle, const SewnCloth* sewn = nullptr);

/// Strain beyond the fabrics' limits, as shares of the garment's flat area. Counts triangles as the
/// histograms of warp, weft and bias do.
struct FabricFit {
    /// The piece with the largest share of strain beyond the limits in any direction.
    struct WorstPiece {
        int piece = -1;
        double share = 0;  ///< of its own flat area

        bool operator==(const WorstPiece&) const = default;
    };

    double warp = 0, weft = 0, bias = 0;
    double any = 0;                     ///< beyond in at least one direction
    std::optional<WorstPiece> worst{};  ///< nullopt if nothing is beyond the limits

    bool operator==(const FabricFit&) const = default;
};

/// All inputs of the fit.
struct FabricQuestion {
    std::shared_ptr<const Scene> scene{};  ///< may be null
    SheetPlaces places{};                  ///< for grain and materials' fabrics
    Fabric fabric{};                       ///< for pieces without their own
};

/// True if the answer is the same: placement does not matter, grain and fabric do.
bool isSameQuestion(const FabricQuestion& one, const FabricQuestion& other);

/// Nullopt without flat cloth. Pure, thread-safe. Cost: linear, some tenths of a second for a
/// million triangles.
std::optional<FabricFit> fabricFit(const FabricQuestion& question);

}  // namespace toile::app
