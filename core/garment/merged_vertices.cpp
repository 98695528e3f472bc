// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/garment/merged_vertices.h"

namespace toile {

MergedVertices mergedVertices(const Points3& V, const std::vector<int>& sourceVertex,
                              geometry::DisjointSets& same) {
    MergedVertices merged{Points3(V.rows(), 3), std::vector<int>(V.rows()), {}};
    for (int v = 0; v < V.rows(); ++v) {
        const int ownSource = sourceVertex.empty() ? -1 : sourceVertex[v];
        const int root = same.root(v);  // the smallest: numbered already
        if (root == v) {
            merged.number[v] = static_cast<int>(merged.sourceVertex.size());
            merged.V.row(merged.number[v]) = V.row(v);
            merged.sourceVertex.push_back(ownSource);
        } else {
            merged.number[v] = merged.number[root];
            int& source = merged.sourceVertex[merged.number[v]];
            source = source < 0 ? ownSource : source;
        }
    }
    merged.V.conservativeResize(static_cast<Eigen::Index>(merged.sourceVertex.size()), 3);
    return merged;
}

}  // namespace toile
