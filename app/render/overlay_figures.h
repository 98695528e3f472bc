// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "app/render/overlay_values.h"
#include "core/garment/fabric.h"

namespace toile::app {

inline constexpr int kHistogramBins = 48;

/// Distribution of a value over the flat cloth, as shares of its area. The sum is 1, or 0 without
/// flat cloth.
struct Histogram {
    std::array<double, kHistogramBins> bins{};  ///< even steps between the scale's ends
    double below = 0, above = 0;                ///< beyond the ends

    double beyond() const { return below + above; }
    double tallest() const;
    /// True if no cloth was counted, for instance before flattening.
    bool isEmpty() const { return !(beyond() > 0 || tallest() > 0); }

    bool operator==(const Histogram&) const = default;
};

/// Counts each triangle's own value, even if the display is smoothed, so that no value beyond an
/// end is averaged away. Uses the limits of each piece's own fabric. Pure, thread-safe.
/// Cost: linear, about a tenth of a second for a million triangles.
/// @param sewn  needed by the overlays of sewn cloth
Histogram overlayHistogram(const Scene& scene, const SheetPlaces& places, Overlay overlay,
                           const OverlayScale& scale, const SewnCloth* sewn = nullptr);

/// A local maximum of an overlay's severity.
struct WorstSpot {
    int piece = 0;
    Eigen::Vector2d flat = Eigen::Vector2d::Zero();      ///< mm, the piece's own coordinates
    Eigen::Vector3d position = Eigen::Vector3d::Zero();  ///< mm, relative to Scene::origin
    Eigen::Vector3d normal = Eigen::Vector3d::Zero();    ///< towards the fabric's right side, unit
    double value = 0;                                    ///< in the overlay's unit
    std::optional<Eigen::Vector3d> sewn{};  ///< sewn position, for overlays of sewn cloth
};

/// As many as a user can check at a glance.
inline constexpr int kMaxWorstSpots = 5;

/// The worst spots by OverlayScale::severity, worst first, well separated on each piece. Leaves out
/// harmless values, even if few spots remain. Values are those of single triangles, and spots are
/// at their centres.
/// Pure, thread-safe. Cost: linear, a tenth of a second for a million triangles.
std::vector<WorstSpot> worstSpots(const Scene& scene, const SheetPlaces& places, Overlay overlay,
                                  const OverlayScale& scale, const SewnCloth* sewn = nullptr);

/// All inputs of an overlay's figures for the whole garment.
struct OverlayQuestion {
    std::shared_ptr<const Scene> scene{};  ///< may be null
    SheetPlaces places{};                  ///< for grain and materials' fabrics
    Fabric fabric{};
    Overlay overlay = Overlay::None;
    std::shared_ptr<const SewnCloth> sewn{};  ///< of the scene; null if nothing is sewn
};

/// True if the answers are the same: placement on the sheet does not matter, nor does grain for an
/// overlay that ignores it.
bool isSameQuestion(const OverlayQuestion& one, const OverlayQuestion& other);

/// The answer: colour scale, distribution and worst spots.
struct OverlayFigures {
    std::shared_ptr<const Scene> scene{};
    Overlay overlay = Overlay::None;
    std::shared_ptr<const SewnCloth> sewn{};  ///< of an overlay of sewn cloth only
    OverlayScale scale{};
    std::optional<Histogram> histogram{};  ///< nullopt for overlays without numbers
    std::vector<WorstSpot> spots{};
};

/// The figures that need no computation: the colour scale, without histogram and spots. Cost:
/// negligible.
OverlayFigures firstFigures(const OverlayQuestion& question);

/// Pure. Cost: see `overlayHistogram` and `worstSpots`.
OverlayFigures overlayFigures(const OverlayQuestion& question);

}  // namespace toile::app
