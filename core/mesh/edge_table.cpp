// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/edge_table.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <utility>

#include "core/geometry/buckets.h"
#include "core/geometry/disjoint_sets.h"
#include "core/mesh/mesh_arrays.h"
#include "core/mesh/tri_mesh.h"

namespace toile {
namespace {

/// A triangle's side, in the bucket of its smaller vertex: larger vertex and use (3 * face + k) in
/// one number that sorts by both.
using Side = std::uint64_t;

Side makeSide(int larger, int use) {
    return static_cast<Side>(larger) << 32 | static_cast<Side>(use);
}

int largerOf(Side side) {
    return static_cast<int>(side >> 32);
}

int useOf(Side side) {
    return static_cast<int>(side & 0xFFFFFFFFu);
}

}  // namespace

EdgeTable buildEdgeTable(const Triangles& F, int vertexCount) {
    const int sideCount = static_cast<int>(F.size());
    geometry::Buckets<Side> sides(vertexCount, [&F, sideCount](auto add) {
        for (int use = 0; use < sideCount; ++use) {
            const int a = tailOf(F, use), b = headOf(F, use);
            add(std::min(a, b), makeSide(std::max(a, b), use));
        }
    });
    EdgeTable table;
    table.edges.resize(sideCount, 2);  // an upper bound
    table.faceEdges.resize(F.rows(), 3);
    table.use.reserve(static_cast<std::size_t>(sideCount));
    for (int v = 0; v < vertexCount; ++v) {
        std::ranges::sort(sides[v]);
        int last = -1;
        for (const Side side : sides[v]) {
            if (std::exchange(last, largerOf(side)) != largerOf(side)) {
                table.edges.row(std::ssize(table.useStart)) << v, largerOf(side);
                table.useStart.push_back(static_cast<int>(table.use.size()));
            }
            table.use.push_back(useOf(side));
            table.faceEdges.data()[useOf(side)] = static_cast<int>(table.useStart.size()) - 1;
        }
    }
    table.edges.conservativeResize(std::ssize(table.useStart), 2);
    table.useStart.push_back(sideCount);
    return table;
}

std::vector<RimLoop> rimsOf(const MeshArrays& mesh, const EdgeTable& table) {
    const auto surface = buildTriMesh(mesh, table);
    std::vector<char> isSeen(surface->n_halfedges(), 0);
    std::vector<RimLoop> loops;
    for (const auto found : surface->halfedges()) {
        if (!found.is_boundary() || isSeen[found.idx()] != 0) {
            continue;
        }
        RimLoop& loop = loops.emplace_back();
        // Edges are sorted, so this one begins or ends at the smallest vertex. The half-edges of a
        // border have the surface on their right.
        auto at = found.from().idx() < found.to().idx() ? found : found.next();
        while (std::exchange(isSeen[at.idx()], 1) == 0) {
            const int v = at.from().idx();
            at = at.prev();
            loop.vertices.push_back(v);
            loop.perimeter += (mesh.V.row(at.from().idx()) - mesh.V.row(v)).norm();
        }
    }
    return loops;
}

std::vector<int> faceComponents(const Triangles& F, int vertexCount) {
    geometry::DisjointSets sets(vertexCount);
    for (int f = 0; f < F.rows(); ++f) {
        sets.join(F(f, 0), F(f, 1));
        sets.join(F(f, 0), F(f, 2));
    }
    std::vector<int> labelOfRoot(vertexCount, -1);
    std::vector<int> label(F.rows());
    int count = 0;
    for (int f = 0; f < F.rows(); ++f) {
        int& known = labelOfRoot[sets.root(F(f, 0))];
        if (known < 0) {
            known = count++;
        }
        label[f] = known;
    }
    return label;
}

int findEdge(const Edges& edges, int a, int b) {
    const std::pair<int, int> wanted = std::minmax(a, b);
    int low = 0, high = static_cast<int>(edges.rows());
    while (low < high) {
        const int middle = std::midpoint(low, high);
        const std::pair<int, int> ends(edges(middle, 0), edges(middle, 1));
        if (ends == wanted) {
            return middle;
        }
        (ends < wanted ? low : high) = ends < wanted ? middle + 1 : middle;
    }
    return -1;
}

}  // namespace toile
