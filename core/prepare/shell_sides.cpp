// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/prepare/shell_sides.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "core/prepare/shell_rims.h"
#include "core/prepare/two_sided.h"

namespace toile::shell {
namespace {

/// Maximum share of a shell's area that is opposite itself.
constexpr double kMaxConflicts = 0.05;
/// Minimum ratio of the areas of the two surfaces.
constexpr double kMinBalance = 0.6;
/// Maximum thickness, relative to the root of one surface's area. Buttons are thicker.
constexpr double kThickestPart = 0.15;

/// A relation between triangles; the most certain ones come first.
struct Link {
    double doubt;
    int a, b;
    bool areApart;
};

TwoSided twoSidesOf(const Pairs& pairs, const std::vector<Neighbours>& neighbours) {
    std::vector<Link> links;
    for (const Neighbours& pair : neighbours) {
        if (pairs.opposite[pair.a] >= 0 && pairs.opposite[pair.b] >= 0) {
            links.push_back({pair.bend, pair.a, pair.b, false});
        }
    }
    const int count = static_cast<int>(pairs.opposite.size());
    for (int t = 0; t < count; ++t) {
        if (pairs.opposite[t] >= 0 && pairs.opposite[pairs.opposite[t]] >= 0) {
            links.push_back({kSmooth, t, pairs.opposite[t], true});
        }
    }
    std::stable_sort(links.begin(), links.end(),
                     [](const Link& a, const Link& b) { return a.doubt < b.doubt; });
    TwoSided sides(count);
    for (const Link& link : links) {
        sides.join(link.a, link.b, link.areApart);
    }
    return sides;
}

/// Sums over one shell that decide about it.
struct Sums {
    std::array<double, 2> area{}, facing{};
    double outwards = 0;  ///< positive if its first side is the outer one
    double volume = 0;    ///< of the cloth, from both sides: twice the true volume
    double conflicts = 0;

    bool isShell() const {
        const auto [least, most] = std::minmax(area[0], area[1]);
        const double both = area[0] + area[1];
        return least > 0 && least >= kMinBalance * most && conflicts <= kMaxConflicts * both &&
               volume <= kThickestPart * std::sqrt(most) * both;
    }
};

Eigen::Vector3d middleOf(const MeshArrays& mesh, int triangle) {
    return (mesh.V.row(mesh.F(triangle, 0)) + mesh.V.row(mesh.F(triangle, 1)) +
            mesh.V.row(mesh.F(triangle, 2)))
               .transpose() /
           3;
}

}  // namespace

Sides findSides(const Surface& surface, const Pairs& pairs) {
    const int count = static_cast<int>(pairs.opposite.size());
    const EdgeTable table = buildEdgeTable(surface.mesh.F, static_cast<int>(surface.mesh.V.rows()));
    const std::vector<Neighbours> neighbours = neighboursOf(surface, table);
    TwoSided sets = twoSidesOf(pairs, neighbours);
    Eigen::Vector3d centre = Eigen::Vector3d::Zero();
    for (int t = 0; t < count; ++t) {
        centre += surface.area[t] * middleOf(surface.mesh, t);
    }
    centre /= surface.area.sum();

    std::vector<Sums> sums(static_cast<std::size_t>(count));
    for (int t = 0; t < count; ++t) {
        if (pairs.opposite[t] < 0) {
            continue;
        }
        const auto [root, isFlipped] = sets.find(t);
        const auto opposite = sets.find(pairs.opposite[t]);
        const std::size_t side = isFlipped ? 1 : 0;
        const double area = surface.area[t];
        const Eigen::Vector3d across = pairs.across.row(t).normalized();
        Sums& shell = sums[root];
        shell.area[side] += area;
        shell.volume += area * pairs.thickness[t];
        shell.facing[side] += area * across.dot(surface.normal.row(t));
        shell.outwards -=
            (side == 0 ? 1 : -1) * area * across.dot(middleOf(surface.mesh, t) - centre);
        shell.conflicts += opposite.root == root && opposite.isFlipped == isFlipped ? area : 0;
    }
    Sides sides{std::vector(static_cast<std::size_t>(count), ShellSide::Single),
                std::vector<char>(static_cast<std::size_t>(count), 0)};
    double volume = 0, area = 0;
    for (int t = 0; t < count; ++t) {
        const auto [root, isFlipped] = sets.find(t);
        const Sums& shell = sums[root];
        if (pairs.opposite[t] < 0 || !shell.isShell()) {
            continue;
        }
        const bool isOuter = (shell.outwards >= 0) == !isFlipped;
        const double facing = shell.facing[isFlipped ? 1 : 0];
        sides.side[t] = isOuter ? ShellSide::Outer : ShellSide::Inner;
        sides.turned[t] = (isOuter ? facing > 0 : facing < 0) ? 1 : 0;
        area += surface.area[t];
        volume += surface.area[t] * pairs.thickness[t];
    }
    fillIn(surface, pairs, neighbours, area > 0 ? volume / area : 0, sets, sides);
    dropFolded(surface, table, sets, sides);
    return sides;
}

}  // namespace toile::shell
