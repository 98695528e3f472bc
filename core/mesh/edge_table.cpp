// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/edge_table.h"

#include <algorithm>
#include <numeric>

#include "core/mesh/disjoint_sets.h"

namespace toile {
namespace {

/// A triangle's side, kept in the bucket of its smaller vertex.
struct Side {
    int larger;  ///< the other vertex
    int use;     ///< 3 * face + k
};

}  // namespace

EdgeTable buildEdgeTable(const Triangles& F, int vertexCount) {
    const int sideCount = static_cast<int>(F.size());
    std::vector<int> bucket(static_cast<std::size_t>(vertexCount) + 1, 0);
    const auto ends = [&F](int use) {
        const int f = use / 3;
        const int k = use % 3;
        return std::minmax({F(f, k), F(f, (k + 1) % 3)});
    };
    for (int use = 0; use < sideCount; ++use) {
        ++bucket[ends(use).first + 1];
    }
    std::partial_sum(bucket.begin(), bucket.end(), bucket.begin());
    std::vector<Side> sides(sideCount);
    std::vector<int> next(bucket.begin(), bucket.end() - 1);
    for (int use = 0; use < sideCount; ++use) {
        const auto [smaller, larger] = ends(use);
        sides[next[smaller]++] = {larger, use};
    }

    EdgeTable table;
    table.faceEdges.resize(F.rows(), 3);
    table.use.resize(sideCount);
    std::vector<int> ofEdge;
    ofEdge.reserve(sideCount);
    table.useStart.reserve(sideCount / 2 + 2);
    for (int v = 0; v < vertexCount; ++v) {
        std::sort(sides.begin() + bucket[v], sides.begin() + bucket[v + 1],
                  [](const Side& a, const Side& b) {
                      return a.larger != b.larger ? a.larger < b.larger : a.use < b.use;
                  });
        for (int s = bucket[v]; s < bucket[v + 1]; ++s) {
            if (s == bucket[v] || sides[s].larger != sides[s - 1].larger) {
                table.useStart.push_back(s);
                ofEdge.push_back(v);
                ofEdge.push_back(sides[s].larger);
            }
            table.use[s] = sides[s].use;
            table.faceEdges(sides[s].use / 3, sides[s].use % 3) =
                static_cast<int>(table.useStart.size()) - 1;
        }
    }
    table.useStart.push_back(sideCount);
    table.edges = Eigen::Map<const Edges>(ofEdge.data(), static_cast<int>(ofEdge.size()) / 2, 2);
    return table;
}

std::vector<int> faceComponents(const Triangles& F, int vertexCount) {
    DisjointSets sets(vertexCount);
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

}  // namespace toile
