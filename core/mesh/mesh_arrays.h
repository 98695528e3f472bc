// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "core/geometry/disjoint_sets.h"

namespace toile {

/// #V x 3 positions in 3D, in millimetres unless a name says otherwise.
using Points3 = Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor>;
/// #V x 2 positions in the pattern plane, in millimetres, y up.
using Points2 = Eigen::Matrix<double, Eigen::Dynamic, 2, Eigen::RowMajor>;
/// #F x 3 vertex indices, anti-clockwise seen from the fabric's right side.
using Triangles = Eigen::Matrix<int, Eigen::Dynamic, 3, Eigen::RowMajor>;
/// #E x 2 vertex indices, each undirected edge once, smaller index first, sorted.
using Edges = Eigen::Matrix<int, Eigen::Dynamic, 2, Eigen::RowMajor>;

/// The inner product of two vector fields.
inline double dot(const Points2& a, const Points2& b) {
    return a.cwiseProduct(b).sum();
}

/// A triangle mesh as plain arrays, for the measures and solvers.
struct MeshArrays {
    Points3 V;
    Triangles F;
};

/// The sides of triangles: side 3 * f + k runs from corner k of face f to the next.

inline int nextSide(int side) {
    return side % 3 == 2 ? side - 2 : side + 1;
}

inline int previousSide(int side) {
    return side % 3 == 0 ? side + 2 : side - 1;
}

inline int tailOf(const Triangles& F, int side) {
    return F.data()[side];
}

inline int headOf(const Triangles& F, int side) {
    return F.data()[nextSide(side)];
}

inline int apexOf(const Triangles& F, int side) {
    return F.data()[previousSide(side)];
}

/// Normal of a triangle, on the side from which it runs anti-clockwise, with a length of twice its
/// area.
inline Eigen::Vector3d doubleAreaNormal(const MeshArrays& mesh, Eigen::Index face) {
    const Eigen::Vector3d a = mesh.V.row(mesh.F(face, 0)).transpose();
    const Eigen::Vector3d b = mesh.V.row(mesh.F(face, 1)).transpose();
    const Eigen::Vector3d c = mesh.V.row(mesh.F(face, 2)).transpose();
    return (b - a).cross(c - a);
}

/// A boundary loop of vertices, surface on its left, starting at its smallest index.
struct RimLoop {
    std::vector<int> vertices;
    double perimeter = 0;
};

/// The fans of triangles around vertices, as sets of corners: side 3 * f + k begins at corner k.

/// Joins the corners at both ends of an edge into fans, for two triangles with a side there; their
/// windings may disagree.
inline void joinCorners(const Triangles& F, int side, int other, geometry::DisjointSets& fans) {
    const bool alike = tailOf(F, side) == tailOf(F, other);
    fans.join(side, alike ? other : nextSide(other));
    fans.join(nextSide(side), alike ? nextSide(other) : other);
}

/// Sum of the triangles' areas, in the mesh's unit squared. Cost: linear. Pure.
inline double surfaceArea(const MeshArrays& mesh) {
    double doubled = 0;
    for (Eigen::Index f = 0; f < mesh.F.rows(); ++f) {
        doubled += doubleAreaNormal(mesh, f).norm();
    }
    return doubled / 2;
}

}  // namespace toile
