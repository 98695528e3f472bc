// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/prepare/debris.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "core/geometry/disjoint_sets.h"
#include "core/mesh/edge_table.h"

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

}  // namespace toile
