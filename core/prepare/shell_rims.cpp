// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/prepare/shell_rims.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

#include "core/geometry/disjoint_sets.h"

namespace toile::shell {
namespace {

/// Where more than two meet, as at a seam of panels that are thick each, none goes on smoothly.
constexpr double kManyMeet = 2;
/// Triangles at one edge that are all taken for neighbours; of more, those next in the file.
constexpr std::size_t kMostAtEdge = 8;

/// Of the length of a shell's edges: how much may lead from one surface to the other without a rim,
/// and how much may be open where others have rims. Cloth that is folded flat does both.
constexpr double kMostContact = 0.1;
constexpr double kMostMixed = 0.15;
/// How many times as wide as the cloth is thick a rim may be.
constexpr double kWidestRim = 4;

/// The edges of one shell's surfaces, by what lies beyond; lengths.
struct Edging {
    double open = 0, rim = 0, contact = 0;

    bool isShells() const {
        const double all = open + rim + contact;
        const double lesser = std::min(open, rim + contact);
        return contact <= kMostContact * all && lesser <= kMostMixed * all;
    }
};

}  // namespace

std::vector<Neighbours> neighboursOf(const Surface& surface, const EdgeTable& table) {
    const MeshArrays& mesh = surface.mesh;
    std::vector<Neighbours> all;
    all.reserve(static_cast<std::size_t>(table.edges.rows()));
    for (Eigen::Index e = 0; e < table.edges.rows(); ++e) {
        const auto uses = table.usesOf(e);
        const double length =
            (mesh.V.row(table.edges(e, 0)) - mesh.V.row(table.edges(e, 1))).norm();
        for (std::size_t i = 0; i < uses.size(); ++i) {
            const std::size_t last = uses.size() > kMostAtEdge ? i + 2 : uses.size();
            for (std::size_t j = i + 1; j < std::min(last, uses.size()); ++j) {
                const int a = uses[i] / 3, b = uses[j] / 3;
                const double sign = tailOf(mesh.F, uses[i]) == tailOf(mesh.F, uses[j]) ? -1 : 1;
                const double cosine = sign * surface.normal.row(a).dot(surface.normal.row(b));
                all.push_back({a, b, uses.size() == 2 ? 1 - cosine : kManyMeet, length});
            }
        }
    }
    return all;
}

void fillIn(const Surface& surface, const Pairs& pairs, const std::vector<Neighbours>& neighbours,
            double thickness, TwoSided& sets, Sides& sides) {
    const int count = static_cast<int>(sides.side.size());
    const auto isOpen = [&](int t) { return sides.side[t] == ShellSide::Single; };
    geometry::DisjointSets patches(count);
    for (const Neighbours& pair : neighbours) {
        if (isOpen(pair.a) && isOpen(pair.b) && pairs.isRim[pair.a] == pairs.isRim[pair.b] &&
            pair.bend <= kSmooth) {
            patches.join(pair.a, pair.b);
        }
    }
    struct Patch {
        double area = 0, length = 0;
        std::array<double, 2> smooth{}, around{};  ///< lengths along the outer and inner surface
        std::array<int, 2> like{};                 ///< one triangle there
    };
    std::vector<Patch> all(static_cast<std::size_t>(count));
    for (int t = 0; t < count; ++t) {
        if (isOpen(t)) {
            all[patches.root(t)].area += surface.area[t];
        }
    }
    for (const Neighbours& pair : neighbours) {
        if (isOpen(pair.a) == isOpen(pair.b)) {
            continue;
        }
        const auto [open, done] =
            isOpen(pair.a) ? std::pair(pair.a, pair.b) : std::pair(pair.b, pair.a);
        Patch& patch = all[patches.root(open)];
        const std::size_t side = sides.side[done] == ShellSide::Outer ? 0 : 1;
        patch.length += pair.length;
        patch.around[side] += pair.length;
        patch.smooth[side] += pair.bend <= kSmooth ? pair.length : 0;
        patch.like[side] = done;
    }
    for (int t = 0; t < count; ++t) {
        if (!isOpen(t)) {
            continue;
        }
        const Patch& patch = all[patches.root(t)];
        const bool isSmooth = patch.smooth[0] + patch.smooth[1] > 0;
        const auto& lengths = isSmooth ? patch.smooth : patch.around;
        if (patch.length > 0 && (pairs.isRim[t] != 0 || (lengths[0] > 0 && lengths[1] > 0))) {
            const bool isNarrow = patch.area <= kWidestRim / 2 * thickness * patch.length;
            sides.side[t] = isNarrow ? ShellSide::Rim : ShellSide::Single;
            if (isNarrow) {
                sets.join(t, patch.like[patch.around[0] > 0 ? 0 : 1], false);
            }
        } else if (lengths[0] + lengths[1] > 0) {
            const std::size_t side = lengths[0] > 0 ? 0 : 1;
            sides.side[t] = side == 0 ? ShellSide::Outer : ShellSide::Inner;
            sides.turned[t] = sides.turned[patch.like[side]];
            sets.join(t, patch.like[side], false);
        }
    }
}

void dropFolded(const Surface& surface, const EdgeTable& table, TwoSided& sets, Sides& sides) {
    const int count = static_cast<int>(sides.side.size());
    const auto isSide = [&](int t) {
        return sides.side[t] == ShellSide::Outer || sides.side[t] == ShellSide::Inner;
    };
    std::vector<Edging> edgings(static_cast<std::size_t>(count));
    for (Eigen::Index e = 0; e < table.edges.rows(); ++e) {
        const auto uses = table.usesOf(e);
        const double length =
            (surface.mesh.V.row(table.edges(e, 0)) - surface.mesh.V.row(table.edges(e, 1))).norm();
        std::array<bool, 4> has{};
        for (const int use : uses) {
            has[static_cast<std::size_t>(sides.side[use / 3])] = true;
        }
        for (const int use : uses) {
            if (!isSide(use / 3)) {
                continue;
            }
            Edging& edging = edgings[sets.find(use / 3).root];
            edging.open += uses.size() == 1 ? length : 0;
            const bool isRim = has[static_cast<std::size_t>(ShellSide::Rim)];
            edging.rim += isRim ? length : 0;
            edging.contact += !isRim && has[static_cast<std::size_t>(ShellSide::Outer)] &&
                                      has[static_cast<std::size_t>(ShellSide::Inner)]
                                  ? length
                                  : 0;
        }
    }
    for (int t = 0; t < count; ++t) {
        if (!edgings[sets.find(t).root].isShells()) {
            sides.side[t] = ShellSide::Single;
            sides.turned[t] = 0;
        }
    }
}

}  // namespace toile::shell
