// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/prepare/recognise.h"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "core/mesh/edge_table.h"
#include "core/prepare/debris.h"
#include "core/prepare/shell_rays.h"

namespace toile {
namespace {

/// So many fragments are those of a scan.
constexpr int kFewestFragments = 5;
/// Of a solid's area, what must belong to closed surfaces.
constexpr double kClosedShare = 0.95;
/// How far layers lie from each other at most, mm, and which share of the smaller one must lie on
/// the other; which share of the file's area either must have.
constexpr double kLayersApart = 30, kLayerShare = 0.8, kLayerArea = 0.1;
/// Triangles that are looked at of one layer.
constexpr int kLooks = 400;

constexpr const char* kOneThickness = translatable("two surfaces %1 mm apart");
constexpr const char* kThicknesses = translatable("two surfaces %1 to %2 mm apart");
constexpr const char* kWithoutRims = translatable("%1, which no rim joins");

Wording evidenceOf(const Shell& shell) {
    const bool isEven = shell.thickest - shell.thinnest < 0.1 * shell.median;
    return isEven ? worded(kOneThickness, {figure(shell.median, 1)})
                  : worded(kThicknesses, {figure(shell.thinnest, 1), figure(shell.thickest, 1)});
}

/// Without the faces that lie on others, as those of meshes that are to be seen from both sides.
FileSurface withoutDoubles(const FileSurface& file) {
    std::vector<std::pair<std::array<int, 3>, int>> corners;
    for (int f = 0; f < file.mesh.F.rows(); ++f) {
        std::array<int, 3> own{file.mesh.F(f, 0), file.mesh.F(f, 1), file.mesh.F(f, 2)};
        std::ranges::sort(own);
        corners.emplace_back(own, f);
    }
    std::ranges::sort(corners);
    std::vector<int> kept;
    for (std::size_t k = 0; k < corners.size(); ++k) {
        if (k == 0 || corners[k].first != corners[k - 1].first) {
            kept.push_back(corners[k].second);
        }
    }
    std::ranges::sort(kept);
    FileSurface single{{file.mesh.V, file.mesh.F(kept, Eigen::all)}, {}};
    for (const int f : kept) {
        single.face.push_back(file.face[f]);
    }
    return single;
}

/// The file's connected parts.
struct Parts {
    std::vector<int> of;  ///< per triangle
    std::vector<double> area;
    std::vector<char> isClosed;
    double total = 0;
};

Parts partsOf(const MeshArrays& mesh) {
    Parts parts;
    const auto vertices = static_cast<int>(mesh.V.rows());
    parts.of = faceComponents(mesh.F, vertices);
    const int count = parts.of.empty() ? 0 : *std::ranges::max_element(parts.of) + 1;
    parts.area.assign(static_cast<std::size_t>(count), 0);
    parts.isClosed.assign(static_cast<std::size_t>(count), 1);
    for (int f = 0; f < mesh.F.rows(); ++f) {
        parts.area[parts.of[f]] += doubleAreaNormal(mesh, f).norm() / 2;
    }
    const EdgeTable table = buildEdgeTable(mesh.F, vertices);
    for (Eigen::Index e = 0; e < table.edges.rows(); ++e) {
        if (table.isBorder(e)) {
            parts.isClosed[parts.of[table.usesOf(e).front() / 3]] = 0;
        }
    }
    for (const double area : parts.area) {
        parts.total += area;
    }
    return parts;
}

double closedShare(const Parts& parts) {
    double closed = 0;
    for (std::size_t p = 0; p < parts.area.size(); ++p) {
        closed += parts.isClosed[p] ? parts.area[p] : 0;
    }
    return parts.total > 0 ? closed / parts.total : 0;
}

/// How far the large parts that lie on each other are apart; none where no two do.
std::optional<double> layersApart(const FileSurface& file, const Parts& parts,
                                  const Progress& progress) {
    std::vector<std::vector<int>> members(parts.area.size());
    std::size_t large = 0;
    for (std::size_t p = 0; p < parts.area.size(); ++p) {
        large += parts.area[p] >= kLayerArea * parts.total ? 1U : 0U;
    }
    if (large < 2) {
        return std::nullopt;
    }
    for (std::size_t f = 0; f < parts.of.size(); ++f) {
        members[parts.of[f]].push_back(static_cast<int>(f));
    }
    const shell::Surface surface = shell::surfaceWith(file.mesh, file.face);
    const shell::Rays rays(surface);
    for (std::size_t p = 0; p < members.size() && !progress.isCancelled(); ++p) {
        if (parts.area[p] < kLayerArea * parts.total) {
            continue;
        }
        std::vector<double> met(members.size(), 0);
        std::vector<double> distances;
        double looked = 0;
        const std::size_t step = std::max<std::size_t>(1, members[p].size() / std::size_t{kLooks});
        for (std::size_t i = 0; i < members[p].size(); i += step) {
            const int f = members[p][i];
            looked += surface.area(f);
            for (const auto facing :
                 {shell::Facing::Alike, shell::Facing::Apart, shell::Facing::Towards}) {
                const shell::Meeting meeting = rays.opposite(f, facing, kLayersApart);
                if (meeting.triangle >= 0 && parts.of[meeting.triangle] != static_cast<int>(p)) {
                    met[parts.of[meeting.triangle]] += surface.area(f);
                    distances.push_back(meeting.way.norm());
                    break;
                }
            }
        }
        const auto other = static_cast<std::size_t>(std::ranges::max_element(met) - met.begin());
        if (looked > 0 && met[other] >= kLayerShare * looked &&
            parts.area[other] >= parts.area[p]) {
            const auto middle = distances.begin() + std::ssize(distances) / 2;
            std::nth_element(distances.begin(), middle, distances.end());
            return *middle;
        }
    }
    return std::nullopt;
}

}  // namespace

Recognition recognise(const FileSurface& surface, const Progress& progress) {
    if (auto shell = findShell(surface, progress)) {
        // Two panels behind each other look like that too: nothing of them may go by itself.
        const bool hasRims = std::ranges::find(shell->side, ShellSide::Rim) != shell->side.end();
        const Wording evidence =
            hasRims ? evidenceOf(*shell) : worded(kWithoutRims, {evidenceOf(*shell)});
        return {hasRims ? FileKind::Shell : FileKind::Layers, evidence, std::move(shell)};
    }
    if (const Debris debris = findDebris(surface.mesh); debris.fragments >= kFewestFragments) {
        return {FileKind::Scan,
                worded("%1 beside one large surface", {countWording(debris.fragments, "fragment")}),
                {}};
    }
    const FileSurface single = withoutDoubles(surface);
    const Parts parts = partsOf(single.mesh);
    if (closedShare(parts) >= kClosedShare) {
        return {FileKind::Solid, worded("a closed surface, with nothing inside it"), {}};
    }
    if (const auto apart = layersApart(single, parts, progress)) {
        return {FileKind::Layers,
                worded("surfaces that lie on each other, %1 mm apart", {figure(*apart, 1)}),
                {}};
    }
    return {};
}

}  // namespace toile
