// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/render/fabric_fit.h"

#include <algorithm>
#include <array>

#include "app/render/overlay_values.h"

namespace toile {

namespace {

constexpr std::array kDirections{Overlay::Warp, Overlay::Weft, Overlay::Bias};

/// Areas, mm2.
struct Tally {
    double all = 0, any = 0;
    std::array<double, kDirections.size()> beyond{};

    void add(const Tally& other) {
        all += other.all;
        any += other.any;
        for (std::size_t k = 0; k < beyond.size(); ++k) {
            beyond[k] += other.beyond[k];
        }
    }
};

using Scales = std::array<OverlayScale, kDirections.size()>;

Tally tallyOf(const FabricQuestion& question, const Scales& scales, int piece) {
    const Scene& scene = *question.scene;
    const TriangleRun& run = scene.pieces[static_cast<std::size_t>(piece)].patternRun;
    const Eigen::Vector2d grain = grainVector(question.places, piece);
    Tally tally;
    const std::size_t first = run.first, end = first + run.count;
    for (std::size_t face = first; face < end; ++face) {
        const double area = static_cast<double>(scene.faces[face].flatArea);
        const OverlaySample sample = sampleOf(scene.faces[face]);
        bool isAny = false;
        for (std::size_t k = 0; k < kDirections.size(); ++k) {
            if (scales[k].isBeyond(overlayValue(kDirections[k], sample, grain, scales[k]))) {
                tally.beyond[k] += area;
                isAny = true;
            }
        }
        tally.all += area;
        tally.any += isAny ? area : 0;
    }
    return tally;
}

}  // namespace

bool isSameQuestion(const FabricQuestion& one, const FabricQuestion& other) {
    const auto sameGrain = [](const SheetPlace& a, const SheetPlace& b) -> bool {
        return a.grain == b.grain;
    };
    return one.scene == other.scene && one.fabric == other.fabric &&
           std::ranges::equal(one.places, other.places, sameGrain);
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
    Tally garment;
    for (int piece = 0; piece < static_cast<int>(scene.pieces.size()); ++piece) {
        const Tally tally = tallyOf(question, scales, piece);
        garment.add(tally);
        const double share = tally.all > 0 ? tally.any / tally.all : 0;
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

}  // namespace toile
