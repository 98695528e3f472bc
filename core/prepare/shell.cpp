// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/prepare/shell.h"

#include <algorithm>
#include <utility>

#include "core/mesh/weld.h"
#include "core/prepare/shell_sides.h"

namespace toile {
namespace {

/// Minimum shares for a shell: of its area in the two surfaces, and of the two surfaces at one or
/// two thicknesses.
constexpr double kMinSides = 0.6;
constexpr double kMinConstant = 0.9;
/// Maximum thickness, relative to the root of the outer surface's area: thicker is a solid.
constexpr double kThickestOfSize = 0.05;

using ValueAndWeight = std::vector<std::pair<double, double>>;

/// The value below which this share of the weight lies. Precondition: sorted, not empty.
double areaQuantile(const ValueAndWeight& values, double share) {
    double all = 0;
    for (const auto& [value, weight] : values) {
        all += weight;
    }
    double sum = 0;
    for (const auto& [value, weight] : values) {
        sum += weight;
        if (sum >= share * all) {
            return value;
        }
    }
    return values.back().first;
}

}  // namespace

std::optional<Shell> findShell(const FileSurface& surface, const Progress& progress) {
    const MeshArrays& mesh = surface.mesh;
    if (mesh.F.rows() < 2) {
        return std::nullopt;
    }
    // Only if the file leaves surfaces open: closed panels stay separate.
    const std::vector<int> target = findWeld(mesh.F, mesh.V, {}).target;
    Triangles F = mesh.F;
    for (int& v : F.reshaped()) {
        v = target[v];
    }
    const shell::Surface welded = shell::surfaceWith({mesh.V, std::move(F)}, surface.face);
    std::optional<shell::Pairs> pairs = shell::findPairs(welded, progress);
    if (!pairs) {
        return std::nullopt;
    }
    shell::Sides sides = shell::findSides(welded, *pairs);

    Shell shell;
    shell.side = std::move(sides.side);
    shell.turned = std::move(sides.turned);
    const std::size_t count = shell.side.size();
    shell.thickness.assign(count, 0);
    ValueAndWeight thickness;
    double outer = 0, both = 0, paired = 0;
    for (std::size_t t = 0; t < count; ++t) {
        const double area = welded.area[static_cast<Eigen::Index>(t)];
        const bool isOuter = shell.side[t] == ShellSide::Outer;
        if (!shell::isSide(shell.side[t])) {
            continue;
        }
        both += area;
        outer += isOuter ? area : 0;
        if (pairs->opposite[t] >= 0) {
            paired += area;
            shell.thickness[t] = pairs->thickness[t];
            thickness.emplace_back(pairs->thickness[t], area);
        }
    }
    const double all = welded.area.sum();
    if (!(paired > 0 && both >= kMinSides * all &&
          shell::shareInTwoSpans(thickness) * paired >= kMinConstant * both)) {
        return std::nullopt;
    }
    shell.median = areaQuantile(thickness, 0.5);
    shell.thinnest = areaQuantile(thickness, 0.05);
    shell.thickest = areaQuantile(thickness, 0.95);
    shell.pairedShare = paired / all;
    if (shell.median > kThickestOfSize * std::sqrt(outer)) {
        return std::nullopt;
    }
    std::vector<char> isOnSide(target.size(), 0);
    for (std::size_t t = 0; t < count; ++t) {
        for (const int v : welded.mesh.F.row(static_cast<Eigen::Index>(t))) {
            isOnSide[v] |= shell::isSide(shell.side[t]) ? 1 : 0;
        }
    }
    shell.partner.assign(target.size(), -1);
    for (std::size_t v = 0; v < target.size(); ++v) {
        const int partner = pairs->partner[target[v]];
        if (partner >= 0 && isOnSide[target[v]] != 0 && isOnSide[partner] != 0) {
            shell.partner[v] = partner;
        }
    }
    return shell;
}

}  // namespace toile
