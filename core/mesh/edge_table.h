// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include <Eigen/Core>

#include "core/mesh/mesh_arrays.h"

namespace toile {

/// The edges of a triangle mesh and how triangles use them. Works on any triangles, manifold or
/// not. Because edges are sorted by (smaller, larger) vertex, they are also the rows of a symmetric
/// sparse matrix on the vertices.
struct EdgeTable {
    Edges edges;                ///< #E x 2, sorted
    Triangles faceEdges;        ///< #F x 3: edge from corner k to corner k+1
    std::vector<int> useStart;  ///< #E + 1: where the uses of an edge begin, see `usesOf`
    std::vector<int> use;       ///< 3 * face + k, edge by edge, in face order

    /// The sides of triangles on an edge; one on the border.
    std::span<const int> usesOf(Eigen::Index e) const {
        return {use.data() + useStart[e], use.data() + useStart[e + 1]};
    }
    bool isBorder(Eigen::Index e) const { return usesOf(e).size() == 1; }
};

/// @param vertexCount  all indices of F lie in [0, vertexCount)
/// Cost: linear (buckets by vertex, tiny sorts inside). Pure.
EdgeTable buildEdgeTable(const Triangles& F, int vertexCount);

/// The edge between two vertices, -1 if there is none. Logarithmic. Pure.
int findEdge(const Edges& edges, int a, int b);

/// The rims of a surface, each starting at its smallest vertex, ordered by these vertices. Rims of
/// an oriented manifold (`isValidSurface`) never meet. On other triangles walls (`buildTriMesh`)
/// count as rims, in any order. Cost: linear; builds a half-edge mesh. Pure.
std::vector<RimLoop> rimsOf(const MeshArrays& mesh, const EdgeTable& table);

/// Label of the connected component (by shared vertices) of each face, numbered by first face.
std::vector<int> faceComponents(const Triangles& F, int vertexCount);

/// A graph on the vertices of a mesh, with a symmetric weight per edge.
struct WeightedEdges {
    Edges edges;              ///< #E x 2, sorted as in EdgeTable
    Eigen::VectorXd weights;  ///< #E
};

}  // namespace toile
