// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/render/overlay_values.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "app/render/piece_values.h"
#include "core/garment/fabric.h"
#include "core/quality/metric_tensor.h"

namespace toile::app {

namespace {

constexpr double kPercent = 100;
/// Minimum size of a limit, in percent: 0 would leave no colours on its side.
constexpr double kMinLimit = 0.01;

MetricTensor metricOf(const OverlaySample& sample) {
    return {static_cast<double>(sample.metric[0]), static_cast<double>(sample.metric[1]),
            static_cast<double>(sample.metric[2])};
}

double worse(double one, double other, const OverlayScale& scale) {
    return scale.severity(one) >= scale.severity(other) ? one : other;
}

StrainLimits tightest(const Fabric& fabric) {
    return {std::max({fabric.warp.least, fabric.weft.least, fabric.bias.least}),
            std::min({fabric.warp.most, fabric.weft.most, fabric.bias.most})};
}

double unbounded(Overlay overlay, const OverlaySample& sample, const Eigen::Vector2d& grain,
                 const OverlayScale& scale) {
    const Eigen::Vector2d across(-grain.y(), grain.x());
    switch (overlay) {
        case Overlay::None:
        case Overlay::Checker:
        case Overlay::Normal:
        case Overlay::Gap:
        case Overlay::WornStrain:
            return 0;
        case Overlay::Area:
            return static_cast<double>(sample.values[0]);
        case Overlay::Angle:
            return static_cast<double>(sample.values[1]);
        case Overlay::Strain:
            return worse(static_cast<double>(sample.values[2]),
                         static_cast<double>(sample.values[3]), scale);
        case Overlay::Warp:
            return kPercent * strainAlong(metricOf(sample), grain);
        case Overlay::Weft:
            return kPercent * strainAlong(metricOf(sample), across);
        case Overlay::Bias: {
            const MetricTensor metric = metricOf(sample);
            return worse(kPercent * strainAlong(metric, (grain + across) * std::sqrt(0.5)),
                         kPercent * strainAlong(metric, (grain - across) * std::sqrt(0.5)), scale);
        }
        case Overlay::Principal: {
            const PrincipalStretch stretch = principalStretch(metricOf(sample));
            return worse(kPercent * (stretch.largest - 1), kPercent * (stretch.least - 1), scale);
        }
        case Overlay::Dirichlet:
            return kPercent * (symmetricDirichlet(metricOf(sample)) - 1);
    }
    return 0;
}

/// Weighted mean of the triangle's vertices.
OverlaySample blended(const Scene& scene, std::size_t face, const Eigen::Vector3d& weights) {
    OverlaySample sum{};
    for (int k = 0; k < 3; ++k) {
        const ClothVertex& vertex =
            scene.vertices[scene.pattern.triangles[3 * face + static_cast<std::size_t>(k)]];
        const auto weight = static_cast<float>(weights[k]);
        for (int i = 0; i < 4; ++i) {
            sum.values[i] += weight * vertex.values[i];
        }
        for (int i = 0; i < 3; ++i) {
            sum.metric[i] += weight * vertex.metric[i];
        }
    }
    return sum;
}

constexpr std::array kDirections{Overlay::Warp, Overlay::Weft, Overlay::Bias};

/// Areas, mm2.
struct StrainedAreas {
    double all = 0, any = 0;
    std::array<double, kDirections.size()> beyond{};

    void add(const StrainedAreas& other) {
        all += other.all;
        any += other.any;
        for (std::size_t k = 0; k < beyond.size(); ++k) {
            beyond[k] += other.beyond[k];
        }
    }
};

using Scales = std::array<OverlayScale, kDirections.size()>;

StrainedAreas strainedAreas(const FabricQuestion& question, const Scales& scales, int piece) {
    const Scene& scene = *question.scene;
    const TriangleRun& run = scene.pieces[static_cast<std::size_t>(piece)].patternRun;
    const Eigen::Vector2d grain = grainVector(question.places, piece);
    const SheetPlace& place = placeOf(question.places, piece);
    Scales own;
    for (std::size_t k = 0; k < own.size(); ++k) {
        own[k] = scaleOn(place, kDirections[k], scales[k]);
    }
    StrainedAreas areas;
    const std::size_t first = run.first, end = first + run.count;
    for (std::size_t face = first; face < end; ++face) {
        const double area = static_cast<double>(scene.faces[face].flatArea);
        const OverlaySample sample = sampleOf(scene.faces[face]);
        bool isAny = false;
        for (std::size_t k = 0; k < kDirections.size(); ++k) {
            if (own[k].limited &&
                own[k].isBeyond(overlayValue(kDirections[k], sample, grain, own[k]))) {
                areas.beyond[k] += area;
                isAny = true;
            }
        }
        areas.all += area;
        areas.any += isAny ? area : 0;
    }
    return areas;
}

}  // namespace

std::optional<OverlayLimits> fabricLimits(Overlay overlay, const Fabric& fabric) {
    const auto inPercent = [](const StrainLimits& limits) -> OverlayLimits {
        return {std::min(kPercent * limits.least, -kMinLimit),
                std::max(kPercent * limits.most, kMinLimit)};
    };
    if (!hasLimits(fabric)) {
        return std::nullopt;
    }
    switch (traits(overlay).limit) {
        case LimitedBy::Nothing:
            break;
        case LimitedBy::Warp:
            return inPercent(fabric.warp);
        case LimitedBy::Weft:
            return inPercent(fabric.weft);
        case LimitedBy::Bias:
            return inPercent(fabric.bias);
        case LimitedBy::Tightest:
            return inPercent(tightest(fabric));
    }
    return std::nullopt;
}

OverlayScale overlayScale(const Scene& scene, Overlay overlay, const Fabric& fabric,
                          const SewnCloth* sewn) {
    if (const auto limits = fabricLimits(overlay, fabric)) {
        return {limits->least, limits->most, false, false, true};
    }
    if (isOfProof(overlay)) {
        return sewn ? sewn->scale(overlay) : OverlayScale{-1, 1};
    }
    return scene.scale(overlay);
}

OverlayScale scaleOn(const SheetPlace& place, Overlay overlay, const OverlayScale& scale) {
    if (!place.fabric) {
        return scale;
    }
    if (const auto limits = fabricLimits(overlay, *place.fabric)) {
        return {limits->least, limits->most, false, false, true};
    }
    OverlayScale own = scale;
    own.limited = false;
    return own;
}

double overlayValue(Overlay overlay, const OverlaySample& sample, const Eigen::Vector2d& grain,
                    const OverlayScale& scale) {
    return std::clamp(unbounded(overlay, sample, grain, scale), -kLargestValue, kLargestValue);
}

Eigen::Vector2d grainVector(const SheetPlaces& places, int piece) {
    const double grain = placeOf(places, piece).grain;
    return {std::cos(grain), std::sin(grain)};
}

OverlaySample sampleOf(const Scene& scene, std::size_t face, const Eigen::Vector3d& barycentric,
                       bool perTriangle) {
    return perTriangle ? sampleOf(scene.faces[face]) : blended(scene, face, barycentric);
}

std::optional<double> valueAt(const Scene& scene, const SheetPlaces& places,
                              const SurfaceHit& place, Overlay overlay, const OverlayScale& scale,
                              bool perTriangle, const SewnCloth* sewn) {
    if (!isMeasured(overlay) || place.piece < 0 ||
        place.piece >= static_cast<int>(scene.pieces.size())) {
        return std::nullopt;
    }
    const PieceScene& piece = scene.pieces[static_cast<std::size_t>(place.piece)];
    if (!piece.flat || place.face < 0 || place.face >= static_cast<int>(piece.patternRun.count)) {
        return std::nullopt;
    }
    const std::size_t face = piece.patternRun.first + static_cast<std::size_t>(place.face);
    if (isOfProof(overlay)) {
        return sewn ? sewnValue(*sewn, overlay, face, place.barycentric) : std::nullopt;
    }
    return overlayValue(overlay, sampleOf(scene, face, place.barycentric, perTriangle),
                        grainVector(places, place.piece),
                        scaleOn(placeOf(places, place.piece), overlay, scale));
}

bool isSameQuestion(const FabricQuestion& one, const FabricQuestion& other) {
    const auto isSameCloth = [](const SheetPlace& a, const SheetPlace& b) -> bool {
        return a.grain == b.grain && a.fabric == b.fabric;
    };
    return clothOf(one.scene) == clothOf(other.scene) && one.fabric == other.fabric &&
           std::ranges::equal(one.places, other.places, isSameCloth);
}

std::optional<FabricFit> fabricFit(const FabricQuestion& question) {
    if (!question.scene) {
        return std::nullopt;
    }
    const Scene& scene = *question.scene;
    Scales scales;
    std::ranges::transform(kDirections, scales.begin(), [&](Overlay direction) -> OverlayScale {
        return overlayScale(scene, direction, question.fabric);
    });
    FabricFit fit;
    StrainedAreas garment;
    for (int piece = 0; piece < static_cast<int>(scene.pieces.size()); ++piece) {
        const StrainedAreas areas = strainedAreas(question, scales, piece);
        garment.add(areas);
        const double share = areas.all > 0 ? areas.any / areas.all : 0;
        if (share > (fit.worst ? fit.worst->share : 0)) {
            fit.worst = {piece, share};
        }
    }
    if (garment.all <= 0) {
        return std::nullopt;
    }
    fit.warp = garment.beyond[0] / garment.all;
    fit.weft = garment.beyond[1] / garment.all;
    fit.bias = garment.beyond[2] / garment.all;
    fit.any = garment.any / garment.all;
    return fit;
}

}  // namespace toile::app
