// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <utility>
#include <vector>

#include "core/mesh/mesh_arrays.h"

namespace toile::sew {

/// Cloth cut by a pattern and sewn: flat triangles, and where they are in space. A pattern point is
/// a vertex of one piece; those that are sewn to each other are one vertex of the cloth. Vertices
/// are numbered by their first pattern point, triangles as they were given.
struct Cloth {
    Points2 Q;                 ///< pattern points at rest, mm: x along the weft, y along the warp
    Triangles patternF;        ///< of pattern points; a piece may lie mirrored
    std::vector<int> pieceOf;  ///< per triangle: whose it is
    /// Per pattern point; -1: it is in no triangle, as the tip of a piece whose two sides there are
    /// sewn to each other.
    std::vector<int> clothVertex;
    Points3 X;          ///< of the vertices, mm
    Triangles F;        ///< of vertices; the same triangles
    int collapsed = 0;  ///< triangles left out: two of their corners are sewn to each other, or
                        ///< they have no area

    /// The surface that it forms at X.
    MeshArrays surface() const { return {X, F}; }
};

/// Triangles by pattern points, and what is to be sewn.
struct CutCloth {
    Points2 Q;                              ///< pattern points, mm
    Points3 V;                              ///< where each is in space, mm
    Triangles F;                            ///< of pattern points
    std::vector<int> pieceOf;               ///< per triangle
    std::vector<std::pair<int, int>> sewn;  ///< pattern points that become one vertex
};

/// Sews; a vertex lies in the middle of its pattern points. Cost: linear. Pure.
Cloth sewTogether(const CutCloth& cut);

/// Per vertex: whether several pattern points are sewn to each other there. Linear. Pure.
std::vector<char> sewnVertices(const Cloth& cloth);

/// One more than the largest piece number. Linear. Pure.
std::size_t pieceCount(const Cloth& cloth);

/// Areas of the triangles at rest, mm². Linear. Pure.
Eigen::VectorXd restAreas(const Cloth& cloth);
/// A third of the area at rest of each vertex's triangles, mm². Linear. Pure.
Eigen::VectorXd vertexAreas(const Cloth& cloth);

/// The map of a triangle from rest to space is F = sum_k x_k b_k^T (3 x 2) with these b_k, 1/mm:
/// the derivatives of its three hat functions in the plane. Precondition: it has an area.
struct RestShape {
    double area;  ///< mm²
    Eigen::Vector2d b[3];
};

std::vector<RestShape> restShapes(const Cloth& cloth);

/// Columns: where warp's and weft's unit vectors go; the weft is the first.
inline Eigen::Matrix<double, 3, 2> deformation(const RestShape& rest, const Triangles& F,
                                               Eigen::Index f, const Points3& X) {
    Eigen::Matrix<double, 3, 2> sum = X.row(F(f, 0)).transpose() * rest.b[0].transpose();
    sum += X.row(F(f, 1)).transpose() * rest.b[1].transpose();
    return sum + X.row(F(f, 2)).transpose() * rest.b[2].transpose();
}

}  // namespace toile::sew
