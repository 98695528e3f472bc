// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tailor/leg_seams.h"

#include <algorithm>
#include <cmath>

namespace toile::tailor {
namespace {

/// Off the mirror plane by so many mm a line costs as much again as its length does anyhow.
constexpr double kOffCentre = 15, kCentreCost = 0.1;
/// Of a waist, the part near the plane where the centre line may end, as a part of its width.
constexpr double kWaistMiddle = 0.15;

template <class Keep>
std::vector<int> those(const std::vector<int>& vertices, const Keep& keep) {
    std::vector<int> kept;
    std::ranges::copy_if(vertices, std::back_inserter(kept), keep);
    return kept;
}

double widthOf(const BodyWays& ways, const std::vector<int>& rim) {
    const auto [least, most] =
        std::ranges::minmax(rim, {}, [&ways](int v) { return ways.across(v); });
    return ways.across(most) - ways.across(least);
}

}  // namespace

std::optional<LegSeams> legSeams(const BodyWays& ways, const SeamPull& pull) {
    const GarmentBody& body = ways.body();
    const BodyOpening* waist = body.find(OpeningKind::Waist);
    const auto ankles = body.pair(OpeningKind::Ankle);
    if (!waist || !ankles) {
        return std::nullopt;
    }
    const std::vector<int>& rim = waist->loop.vertices;
    const double reach = kWaistMiddle * widthOf(ways, rim);
    const auto middle = [&](bool isFront) {
        return those(rim, [&](int v) {
            const double ahead = body.forward.dot(ways.at(v) - waist->centre);
            return std::abs(ways.across(v)) < reach && (isFront ? ahead > 0 : ahead < 0);
        });
    };
    const auto plane = ways.costs([&](int v) {
        const double off = ways.across(v) / kOffCentre;
        return kCentreCost + off * off;
    });
    LegSeams seams;
    seams.centre = pull.pulled(ways.cheapest(plane, middle(true), middle(false)), plane,
                               middle(true), middle(false));
    if (seams.centre.size() < 3) {
        return std::nullopt;
    }
    const int crotch =
        *std::ranges::min_element(seams.centre, {}, [&ways](int v) { return ways.height(v); });
    for (int k = 0; k < 2; ++k) {
        const int side = k == 0 ? -1 : 1;
        const BodyOpening& ankle = *(*ankles)[k];
        const double centre = body.across(ankle.centre);
        const auto half = [&](const std::vector<int>& vertices, double x, bool isOuter) {
            return those(vertices, [&](int v) {
                const double outward = side * (ways.across(v) - x);
                return isOuter ? outward > 0 : outward < 0;
            });
        };
        const std::vector<int> inner = half(ankle.loop.vertices, centre, false);
        const std::vector<int> outer = half(ankle.loop.vertices, centre, true);
        const std::vector<int> top = half(rim, side * reach, true);
        const std::vector<double>& costs = ways.silhouette();
        seams.inseam[k] =
            pull.pulled(ways.cheapest(costs, {crotch}, inner), costs, {crotch}, inner);
        seams.side[k] = pull.pulled(ways.cheapest(costs, top, outer), costs, top, outer);
    }
    return seams;
}

std::array<std::vector<int>, 2> skirtSides(const BodyWays& ways, const SeamPull& pull) {
    const BodyOpening* waist = ways.body().find(OpeningKind::Waist);
    const BodyOpening* hem = ways.body().find(OpeningKind::Hem);
    std::array<std::vector<int>, 2> sides;
    if (!waist || !hem) {
        return sides;
    }
    const std::vector<double> costs = ways.envelope();
    for (int k = 0; k < 2; ++k) {
        const auto onSide = [&](int v) { return k == 0 ? ways.across(v) < 0 : ways.across(v) > 0; };
        const std::vector<int> from = those(waist->loop.vertices, onSide);
        const std::vector<int> to = those(hem->loop.vertices, onSide);
        sides[k] = pull.pulled(ways.cheapest(costs, from, to), costs, from, to);
    }
    return sides;
}

}  // namespace toile::tailor
