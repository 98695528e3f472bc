// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/render/overlay_figures.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace toile::app {

namespace {

/// Calls visit(face of the pattern, value, the piece's scale) with the overlay's value of every
/// flat triangle.
template <class Visit>
void forEachValue(const Scene& scene, const SheetPlaces& places, Overlay overlay,
                  const OverlayScale& scale, const SewnCloth* sewn, const Visit& visit) {
    for (std::size_t i = 0; i < scene.pieces.size(); ++i) {
        const Eigen::Vector2d grain = grainVector(places, static_cast<int>(i));
        const OverlayScale own = scaleOn(placeOf(places, static_cast<int>(i)), overlay, scale);
        const std::size_t first = scene.pieces[i].patternRun.first;
        for (std::size_t face = first; face < first + scene.pieces[i].patternRun.count; ++face) {
            if (isOfProof(overlay)) {
                const Eigen::Vector3d middle = Eigen::Vector3d::Constant(1.0 / 3);
                if (const auto value =
                        sewn ? sewnValue(*sewn, overlay, face, middle) : std::nullopt) {
                    visit(face, *value, own);
                }
                continue;
            }
            visit(face, overlayValue(overlay, sampleOf(scene.faces[face]), grain, own), own);
        }
    }
}

/// @param own  scale of the piece
void count(Histogram& histogram, const OverlayScale& scale, const OverlayScale& own, double value,
           double area) {
    // If the ends are limits, cloth without limits is never beyond them.
    if (own.isBeyond(value) && (own.limited || !scale.limited)) {
        (value < own.low ? histogram.below : histogram.above) += area;
        return;
    }
    const int bin = static_cast<int>(std::floor(scale.position(value) * kHistogramBins));
    histogram.bins[static_cast<std::size_t>(std::clamp(bin, 0, kHistogramBins - 1))] += area;
}

/// Share of the scale's end below which a value is no worst spot.
constexpr float kMinSeverity = 0.25F;
/// Minimum distance of spots on a piece: a share of its box's diagonal, and mm.
constexpr double kApartShare = 0.15, kApart = 10;
/// Ignore differences below this, so that rounding makes no peaks.
constexpr float kSame = 1e-4F;

/// Per vertex the worst triangle around it, by severity.
struct Field {
    std::vector<float> severity, value;
    std::vector<std::uint32_t> face;  ///< the triangle with that value
};

Field fieldOf(const Scene& scene, const SheetPlaces& places, Overlay overlay,
              const OverlayScale& scale, const SewnCloth* sewn) {
    Field field;
    const auto& triangles = scene.pattern.triangles;
    field.severity.assign(scene.vertices.size(), -1.0F);
    field.value.assign(field.severity.size(), 0.0F);
    field.face.assign(field.severity.size(), 0);
    const auto add = [&](std::size_t face, double value, const OverlayScale& own) {
        const auto severity = static_cast<float>(own.severity(value));
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint32_t v = triangles[3 * face + k];
            if (severity > field.severity[v]) {
                field.severity[v] = severity;
                field.value[v] = static_cast<float>(value);
                field.face[v] = static_cast<std::uint32_t>(face);
            }
        }
    };
    forEachValue(scene, places, overlay, scale, sewn, add);
    return field;
}

/// Local maxima that have a lower neighbour, and the global maximum.
std::vector<std::uint32_t> peaks(const Scene& scene, const Field& field) {
    enum : char { kLower = 1, kHigher = 2 };
    std::vector<char> neighbours(field.severity.size(), 0);
    const auto& edges = scene.pattern.edges;
    for (std::size_t e = 0; e + 1 < edges.size(); e += 2) {
        const float difference = field.severity[edges[e]] - field.severity[edges[e + 1]];
        if (difference > kSame) {
            neighbours[edges[e]] |= kLower;
            neighbours[edges[e + 1]] |= kHigher;
        } else if (difference < -kSame) {
            neighbours[edges[e]] |= kHigher;
            neighbours[edges[e + 1]] |= kLower;
        }
    }
    std::vector<std::uint32_t> found;
    const auto highest = std::ranges::max_element(field.severity) - field.severity.begin();
    for (std::size_t v = 0; v < field.severity.size(); ++v) {
        const bool isPeak = neighbours[v] == kLower || static_cast<std::ptrdiff_t>(v) == highest;
        if (isPeak && field.severity[v] >= kMinSeverity) {
            found.push_back(static_cast<std::uint32_t>(v));
        }
    }
    return found;
}

WorstSpot spotAt(const Scene& scene, const Field& field, std::uint32_t at, const SewnCloth* sewn) {
    const auto& triangles = scene.pattern.triangles;
    WorstSpot spot;
    spot.piece = static_cast<int>(scene.vertices[at].piece);
    spot.value = static_cast<double>(field.value[at]);
    constexpr double share = 1.0 / 3;
    const std::size_t first = 3 * std::size_t{field.face[at]};
    spot.sewn = sewn ? std::optional(Eigen::Vector3d(Eigen::Vector3d::Zero())) : std::nullopt;
    for (std::size_t k = first; k < first + 3; ++k) {
        if (sewn) {
            *spot.sewn += share * wornPoint(sewn->vertices[triangles[k]]);
        }
        const ClothVertex& corner = scene.vertices[triangles[k]];
        spot.flat += share * flatPoint(corner);
        spot.position += share * wornPoint(corner);
        spot.normal += share * Eigen::Map<const Eigen::Vector3f>(corner.normal).cast<double>();
    }
    return spot;
}

bool isApart(const Scene& scene, const WorstSpot& spot, const std::vector<WorstSpot>& others) {
    const auto& box = scene.pieces[static_cast<std::size_t>(spot.piece)].flatBox;
    const double apart = std::max(kApart, kApartShare * box.diagonal().norm());
    return std::ranges::none_of(others, [&](const WorstSpot& other) -> bool {
        return other.piece == spot.piece && (other.flat - spot.flat).norm() < apart;
    });
}

}  // namespace

double Histogram::tallest() const {
    return *std::ranges::max_element(bins);
}

Histogram overlayHistogram(const Scene& scene, const SheetPlaces& places, Overlay overlay,
                           const OverlayScale& scale, const SewnCloth* sewn) {
    Histogram histogram;
    double total = 0;
    const auto add = [&](std::size_t face, double value, const OverlayScale& own) {
        const auto area = static_cast<double>(scene.faces[face].flatArea);
        total += area;
        count(histogram, scale, own, value, area);
    };
    forEachValue(scene, places, overlay, scale, sewn, add);
    if (total > 0) {
        histogram.below /= total;
        histogram.above /= total;
        for (double& bin : histogram.bins) {
            bin /= total;
        }
    }
    return histogram;
}

std::vector<WorstSpot> worstSpots(const Scene& scene, const SheetPlaces& places, Overlay overlay,
                                  const OverlayScale& scale, const SewnCloth* sewn) {
    if (!isMeasured(overlay) || scene.faces.empty()) {
        return {};
    }
    const Field field = fieldOf(scene, places, overlay, scale, sewn);
    std::vector<std::uint32_t> candidates = peaks(scene, field);
    std::ranges::stable_sort(candidates, [&field](std::uint32_t a, std::uint32_t b) -> bool {
        return field.severity[a] > field.severity[b];
    });
    std::vector<WorstSpot> spots;
    for (const std::uint32_t at : candidates) {
        const WorstSpot spot = spotAt(scene, field, at, isOfProof(overlay) ? sewn : nullptr);
        if (isApart(scene, spot, spots)) {
            spots.push_back(spot);
        }
        if (spots.size() == kMaxWorstSpots) {
            break;
        }
    }
    return spots;
}

bool isSameQuestion(const OverlayQuestion& one, const OverlayQuestion& other) {
    if (clothOf(one.scene) != clothOf(other.scene) || one.overlay != other.overlay ||
        !(one.fabric == other.fabric) || one.sewn != other.sewn) {
        return false;
    }
    const auto isSameCloth = [&](const SheetPlace& a, const SheetPlace& b) -> bool {
        return (a.grain == b.grain || !traits(one.overlay).usesGrain) && a.fabric == b.fabric;
    };
    return std::ranges::equal(one.places, other.places, isSameCloth);
}

OverlayFigures firstFigures(const OverlayQuestion& question) {
    OverlayFigures figures;
    figures.scene = question.scene;
    figures.overlay = question.overlay;
    figures.sewn = question.sewn;
    if (question.scene) {
        figures.scale =
            overlayScale(*question.scene, question.overlay, question.fabric, question.sewn.get());
    }
    return figures;
}

OverlayFigures overlayFigures(const OverlayQuestion& question) {
    OverlayFigures figures = firstFigures(question);
    if (question.scene && isMeasured(question.overlay)) {
        figures.histogram = overlayHistogram(*question.scene, question.places, question.overlay,
                                             figures.scale, question.sewn.get());
        figures.spots = worstSpots(*question.scene, question.places, question.overlay,
                                   figures.scale, question.sewn.get());
    }
    return figures;
}

}  // namespace toile::app
