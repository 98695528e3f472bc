// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/prepare/recognise.h"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "core/geometry/disjoint_sets.h"
#include "core/mesh/edge_table.h"
#include "core/prepare/file_surface.h"

namespace toile {
namespace {

constexpr double kLargestArea = 1e-3;   // of a fragment, relative to the largest part
constexpr double kLargestSize = 0.2;    // the same, by diagonals of boxes
constexpr double kMaxOfAllArea = 0.05;  // beyond this the fragments are cloth
constexpr int kFacesOfKind = 8;         // fewer can be alike by chance
constexpr double kSameKind = 0.01;      // largest difference of area and size within a kind

struct Fragment {
    int faces = 0;
    double area = 0;
    Eigen::AlignedBox3d box{};
    bool isDebris = false;

    double size() const { return box.isEmpty() ? 0 : box.diagonal().norm(); }
};

/// Labels faces by the parts connected by shared edges, numbered by first face: parts that touch
/// only at a vertex are separate.
std::vector<int> edgeComponents(const MeshArrays& mesh) {
    const EdgeTable table = buildEdgeTable(mesh.F, static_cast<int>(mesh.V.rows()));
    geometry::DisjointSets sets(static_cast<int>(mesh.F.rows()));
    for (int e = 0; e < table.edges.rows(); ++e) {
        for (const int side : table.usesOf(e)) {
            sets.join(table.usesOf(e).front() / 3, side / 3);
        }
    }
    std::vector<int> label(static_cast<std::size_t>(mesh.F.rows()));
    int count = 0;
    for (int f = 0; f < mesh.F.rows(); ++f) {  // the root is the first face
        label[f] = sets.root(f) == f ? count++ : label[sets.root(f)];
    }
    return label;
}

std::vector<Fragment> measured(const MeshArrays& mesh, const std::vector<int>& component) {
    std::vector<Fragment> fragments;
    for (int f = 0; f < mesh.F.rows(); ++f) {
        if (component[f] >= static_cast<int>(fragments.size())) {
            fragments.emplace_back();  // they are numbered by first face
        }
        Fragment& fragment = fragments[component[f]];
        ++fragment.faces;
        fragment.area += doubleAreaNormal(mesh, f).norm() / 2;
        for (int k = 0; k < 3; ++k) {
            fragment.box.extend(mesh.V.row(mesh.F(f, k)).transpose());
        }
    }
    return fragments;
}

bool ofAKind(const Fragment& a, const Fragment& b) {
    return a.faces == b.faces && a.faces >= kFacesOfKind &&
           std::abs(a.area - b.area) <= kSameKind * std::max(a.area, b.area) &&
           std::abs(a.size() - b.size()) <= kSameKind * std::max(a.size(), b.size());
}

/// Removes fragments that come as several of a kind from the debris.
void keepKinds(std::vector<Fragment*>& small) {
    std::ranges::sort(small, [](const Fragment* a, const Fragment* b) {
        return std::tuple(a->faces, a->area, a->size()) < std::tuple(b->faces, b->area, b->size());
    });
    for (std::size_t i = 1; i < small.size(); ++i) {
        if (ofAKind(*small[i - 1], *small[i])) {
            small[i - 1]->isDebris = small[i]->isDebris = false;
        }
    }
}

}  // namespace

Debris findDebris(const MeshArrays& mesh) {
    const std::vector<int> component = edgeComponents(mesh);
    std::vector<Fragment> fragments = measured(mesh, component);
    if (fragments.size() < 2) {
        return {};
    }
    const Fragment largest = *std::ranges::max_element(fragments, {}, &Fragment::area);
    double allArea = 0, smallArea = 0;
    std::vector<Fragment*> small;
    for (Fragment& fragment : fragments) {
        allArea += fragment.area;
        fragment.isDebris = fragment.area < kLargestArea * largest.area &&
                            fragment.size() < kLargestSize * largest.size();
        if (fragment.isDebris) {
            small.push_back(&fragment);
            smallArea += fragment.area;
        }
    }
    if (smallArea > kMaxOfAllArea * allArea) {
        return {};
    }
    keepKinds(small);
    Debris debris;
    for (const Fragment& fragment : fragments) {
        debris.fragments += fragment.isDebris ? 1 : 0;
        debris.area += fragment.isDebris ? fragment.area : 0;
    }
    for (int f = 0; f < mesh.F.rows(); ++f) {
        if (fragments[component[f]].isDebris) {
            debris.triangles.push_back(f);
        }
    }
    return debris;
}

namespace {

/// At least this many fragments indicate a scan.
constexpr int kFewestFragments = 5;
/// Minimum share of a solid's area in closed surfaces.
constexpr double kClosedShare = 0.95;
/// Up to this share of coinciding faces is only folded, as in the corners of a cushion.
constexpr double kFoldedShare = 0.02;

constexpr const char* kOneThickness = translatable("two surfaces %1 mm apart");
constexpr const char* kThicknesses = translatable("two surfaces %1 to %2 mm apart");
constexpr const char* kWithoutRims = translatable("%1, not joined by a rim");

Wording evidenceOf(const Shell& shell) {
    const bool isEven = shell.thickest - shell.thinnest < 0.1 * shell.median;
    return isEven ? worded(kOneThickness, {figure(shell.median, 1)})
                  : worded(kThicknesses, {figure(shell.thinnest, 1), figure(shell.thickest, 1)});
}

/// A double-sided mesh is not closed for that reason.
bool isClosed(const FileSurface& surface) {
    const FileSurface single = withoutDoubles(surface);
    const auto faces = static_cast<double>(surface.mesh.F.rows());
    const bool isFolded = static_cast<double>(single.mesh.F.rows()) >= (1 - kFoldedShare) * faces;
    return partsOf((isFolded ? surface : single).mesh).closedShare() >= kClosedShare;
}

}  // namespace

Recognition recognise(const FileSurface& surface, const Progress& progress) {
    if (auto shell = findShell(surface, progress)) {
        // Two panels behind each other look like this too: nothing may be removed automatically.
        const bool hasRims = std::ranges::find(shell->side, ShellSide::Rim) != shell->side.end();
        if (hasRims) {
            const Wording evidence = evidenceOf(*shell);
            return {FileKind::Shell, evidence, std::move(shell)};
        }
        auto layers = findLayers(surface, progress);
        const Wording evidence = layers && layers->isSure
                                     ? inWords(*layers)
                                     : worded(kWithoutRims, {evidenceOf(*shell)});
        return {FileKind::Layers, evidence, std::move(shell), std::move(layers)};
    }
    if (const Debris debris = findDebris(surface.mesh); debris.fragments >= kFewestFragments) {
        return {FileKind::Scan, worded("%1 beside one large surface",
                                       {countWording(debris.fragments, "fragment")})};
    }
    if (isClosed(surface)) {
        return {FileKind::Solid, worded("a closed surface, with nothing inside it")};
    }
    if (auto layers = findLayers(surface, progress); layers && layers->isSure) {
        const Wording evidence = inWords(*layers);
        return {FileKind::Layers, evidence, {}, std::move(layers)};
    }
    return {};
}

}  // namespace toile
