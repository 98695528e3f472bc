// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <utility>
#include <vector>

#include "core/mesh/mesh_arrays.h"

namespace toile::sew {

/// Sewn cloth of a pattern: flat triangles, and their positions in space. A pattern point is a
/// vertex of one piece; points that are sewn to each other are one vertex of the cloth. Vertices
/// are numbered by their first pattern point, triangles keep their order.
struct Cloth {
    Points2 Q;                 ///< pattern points at rest, mm: x along the weft, y along the warp
    Triangles patternF;        ///< of pattern points; pieces may be mirrored
    std::vector<int> pieceOf;  ///< per triangle: its piece
    /// Per pattern point; -1: in no triangle, like the tip of a piece whose two sides there are
    /// sewn to each other.
    std::vector<int> clothVertex;
    Points3 X;          ///< of the vertices, mm
    Triangles F;        ///< of vertices; the same triangles
    int collapsed = 0;  ///< triangles left out: two of their corners are sewn to each other, or
                        ///< they have no area

    /// The surface at X.
    MeshArrays surface() const { return {X, F}; }
};

/// Triangles by pattern points, and the pairs to sew.
struct CutCloth {
    Points2 Q;                              ///< pattern points, mm
    Points3 V;                              ///< position of each in space, mm
    Triangles F;                            ///< of pattern points
    std::vector<int> pieceOf;               ///< per triangle
    std::vector<std::pair<int, int>> sewn;  ///< pattern points that become one vertex
};

/// Sews the cloth; a vertex is at the mean of its pattern points. Cost: linear. Pure.
Cloth sewTogether(const CutCloth& cut);

/// Per vertex: whether several pattern points are sewn together there. Linear. Pure.
std::vector<char> sewnVertices(const Cloth& cloth);

/// One more than the largest piece number. Linear. Pure.
std::size_t pieceCount(const Cloth& cloth);

/// Areas of the triangles at rest, mm². Linear. Pure.
Eigen::VectorXd restAreas(const Cloth& cloth);
/// A third of the area at rest of each vertex's triangles, mm². Linear. Pure.
Eigen::VectorXd vertexAreas(const Cloth& cloth);

/// The map of a triangle from rest to space is F = sum_k x_k b_k^T (3 x 2) with these b_k, 1/mm:
/// the gradients of its three hat functions in the plane. Precondition: its area is not zero.
struct RestShape {
    double area;  ///< mm²
    Eigen::Vector2d b[3];
};

std::vector<RestShape> restShapes(const Cloth& cloth);

/// Columns: images of the unit vectors of weft and warp, in this order.
inline Eigen::Matrix<double, 3, 2> deformation(const RestShape& rest, const Triangles& F,
                                               Eigen::Index f, const Points3& X) {
    Eigen::Matrix<double, 3, 2> sum = X.row(F(f, 0)).transpose() * rest.b[0].transpose();
    sum += X.row(F(f, 1)).transpose() * rest.b[1].transpose();
    return sum + X.row(F(f, 2)).transpose() * rest.b[2].transpose();
}

}  // namespace toile::sew
