// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

namespace toile {

/// #V x 3 positions in 3D, in millimetres unless a name says otherwise.
using Points3 = Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor>;
/// #V x 2 positions in the pattern plane, in millimetres, y up.
using Points2 = Eigen::Matrix<double, Eigen::Dynamic, 2, Eigen::RowMajor>;
/// #F x 3 vertex indices, anti-clockwise seen from the fabric's right side.
using Triangles = Eigen::Matrix<int, Eigen::Dynamic, 3, Eigen::RowMajor>;
/// #E x 2 vertex indices, each undirected edge once, smaller index first, sorted.
using Edges = Eigen::Matrix<int, Eigen::Dynamic, 2, Eigen::RowMajor>;

/// The inner product of two fields of vectors.
inline double dot(const Points2& a, const Points2& b) {
    return a.cwiseProduct(b).sum();
}

/// A triangle mesh as plain arrays: what the measures and solvers work on.
struct MeshArrays {
    Points3 V;
    Triangles F;
};

}  // namespace toile
