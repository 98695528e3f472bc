// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tailor/middle_seams.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <limits>

namespace toile::tailor {
namespace {

/// A line this far off its plane or height, mm, costs as much again; what its length costs anyhow.
constexpr double kOffPlane = 15, kLength = 0.1;
constexpr double kOtherHalf = 1e4;
/// A waist is where the garment is narrower than this part of its greatest width.
constexpr double kNarrow = 0.9;
constexpr int kHeights = 40;
/// How far from there, mm, a likely line of the mesh may be the waist's.
constexpr double kWaistReach = 50;
/// Nor is there one where a cut crosses both sides so near to it, mm.
constexpr double kCutAround = 120;

/// Costs in one half of the garment: near a value of `off` of 0.
std::vector<double> costsNear(const BodyWays& ways, bool isFront,
                              const std::function<double(int)>& off) {
    return ways.costs([&](int v) {
        const double facing = isFront ? ways.facing(v) : -ways.facing(v);
        const double far = off(v) / kOffPlane;
        return facing < 0 ? kOtherHalf : kLength + far * far;
    });
}

/// The place of a way at some height: across, and which vertex.
int vertexAt(const BodyWays& ways, const std::vector<int>& way, double height) {
    return *std::ranges::min_element(way, {},
                                     [&](int v) { return std::abs(ways.height(v) - height); });
}

/// Vertices of a way that are near a height, the nearest among them.
std::vector<int> nearHeight(const BodyWays& ways, const std::vector<int>& way, double height,
                            std::vector<int> nearest) {
    std::ranges::copy_if(way, std::back_inserter(nearest), [&](int v) {
        return std::abs(ways.height(v) - height) < kWaistReach && v != nearest.front();
    });
    return nearest;
}

}  // namespace

std::vector<int> centreLine(const BodyWays& ways, const SeamPull& pull,
                            const std::vector<int>& from, const std::vector<int>& to) {
    std::vector<int> best;
    double likeliest = -1;
    for (const bool isFront : {false, true}) {
        const auto costs = costsNear(ways, isFront, [&](int v) { return ways.across(v); });
        const std::vector<int> way = pull.pulled(ways.cheapest(costs, from, to), costs, from, to);
        const double likeliness = pull.along(way);
        if (!way.empty() && likeliness > likeliest) {
            likeliest = likeliness;
            best = way;
        }
    }
    return best;
}

std::vector<int> waistLine(const BodyWays& ways, const SeamPull& pull,
                           const std::array<std::vector<int>, 2>& sides) {
    double least = -std::numeric_limits<double>::infinity(), most = -least;
    for (const std::vector<int>& side : sides) {
        least = std::max(least, ways.height(side.back()));
        most = std::min(most, ways.height(side.front()));
    }
    double widest = 0, narrowest = std::numeric_limits<double>::infinity(), at = 0;
    for (int k = 1; k < kHeights; ++k) {
        const double height = least + k * (most - least) / kHeights;
        const double width = ways.across(vertexAt(ways, sides[1], height)) -
                             ways.across(vertexAt(ways, sides[0], height));
        widest = std::max(widest, width);
        if (width < narrowest) {
            narrowest = width;
            at = height;
        }
    }
    const auto isCutAround = [&](const std::vector<int>& side) {
        return std::ranges::any_of(side, [&](int v) {
            return pull.isAtSure(v) && std::abs(ways.height(v) - at) < kCutAround;
        });
    };
    if (least >= most || narrowest > kNarrow * widest || std::ranges::all_of(sides, isCutAround)) {
        return {};
    }
    std::vector<int> left{vertexAt(ways, sides[0], at)}, right{vertexAt(ways, sides[1], at)};
    std::vector<int> around;
    for (const bool isFront : {true, false}) {
        const auto costs = costsNear(ways, isFront, [&](int v) { return ways.height(v) - at; });
        std::vector<int> half = ways.cheapest(costs, left, right);
        // The first half says where a line of the mesh begins and ends, the second closes it.
        std::vector<int> led = isFront
                                   ? pull.pulled(half, costs, nearHeight(ways, sides[0], at, left),
                                                 nearHeight(ways, sides[1], at, right))
                                   : pull.pulled(half, costs, left, right);
        if (!isFront || pull.along(led) > MeshLines::kLikely) {
            half = std::move(led);
        }
        if (half.empty()) {
            return {};
        }
        left = {half.front()};
        right = {half.back()};
        if (!isFront) {
            std::ranges::reverse(half);
        }
        around.insert(around.end(), half.begin() + (isFront ? 0 : 1), half.end());
    }
    return around;
}

}  // namespace toile::tailor
