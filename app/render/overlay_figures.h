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

/// How much of the flat cloth has which value, as parts of its area; all together 1, or 0 where
/// there is no flat cloth.
struct Histogram {
    std::array<double, kHistogramBins> bins{};  ///< even steps from the scale's low to its high end
    double below = 0, above = 0;                ///< beyond the ends

    double beyond() const { return below + above; }
    double tallest() const;
    /// True where there was no cloth to count, as before anything is flat.
    bool isEmpty() const { return !(beyond() > 0 || tallest() > 0); }

    bool operator==(const Histogram&) const = default;
};

/// Of every triangle by itself, whether it is drawn so or smoothed: what lies beyond an end is
/// never averaged away, and is counted by the limits of its piece's own fabric. Pure, thread-safe.
/// Cost: linear, about a tenth of a second at a million triangles.
/// @param sewn  for the overlays that are of it
Histogram overlayHistogram(const Scene& scene, const SheetPlaces& places, Overlay overlay,
                           const OverlayScale& scale, const SewnCloth* sewn = nullptr);

/// A place where an overlay's value is worse than all around it.
struct WorstSpot {
    int piece = 0;
    Eigen::Vector2d flat = Eigen::Vector2d::Zero();      ///< mm, the piece's own coordinates
    Eigen::Vector3d position = Eigen::Vector3d::Zero();  ///< mm, relative to Scene::origin
    Eigen::Vector3d normal = Eigen::Vector3d::Zero();    ///< towards the fabric's right side, unit
    double value = 0;                                    ///< in the overlay's unit
    std::optional<Eigen::Vector3d> sewn{};  ///< where it lies sewn, of an overlay of sewn cloth
};

/// Up to this many are worth a person's look at once.
inline constexpr int kMaxWorstSpots = 5;

/// The worst places, the worst first by OverlayScale::severity, on the same piece well apart from
/// each other. Places that are far from the end of their side are left out, however few remain.
/// Values are those of single triangles, in the middle of which a spot lies.
/// Pure, thread-safe. Cost: linear, a tenth of a second at a million triangles.
std::vector<WorstSpot> worstSpots(const Scene& scene, const SheetPlaces& places, Overlay overlay,
                                  const OverlayScale& scale, const SewnCloth* sewn = nullptr);

/// What an overlay says of the whole garment depends on this and on nothing else.
struct OverlayQuestion {
    std::shared_ptr<const Scene> scene{};  ///< may be null
    SheetPlaces places{};                  ///< for the grain and the materials' fabrics
    Fabric fabric{};
    Overlay overlay = Overlay::None;
    std::shared_ptr<const SewnCloth> sewn{};  ///< of the scene; null: nothing is sewn
};

/// True where the answers are the same: places on the sheet do not matter, nor the grain to an
/// overlay that does not follow it.
bool isSameQuestion(const OverlayQuestion& one, const OverlayQuestion& other);

/// The answer: the ends of the colours, who has which value, and where it is worst.
struct OverlayFigures {
    std::shared_ptr<const Scene> scene{};
    Overlay overlay = Overlay::None;
    std::shared_ptr<const SewnCloth> sewn{};  ///< of an overlay that is of it alone
    OverlayScale scale{};
    std::optional<Histogram> histogram{};  ///< none where there are no numbers
    std::vector<WorstSpot> spots{};
};

/// What is known at once: the ends of the colours, without histogram and spots. Cost: none to speak
/// of.
OverlayFigures firstFigures(const OverlayQuestion& question);

/// Pure; cost as `overlayHistogram` and `worstSpots`.
OverlayFigures overlayFigures(const OverlayQuestion& question);

}  // namespace toile::app
