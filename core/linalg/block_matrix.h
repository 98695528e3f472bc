// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <Eigen/Core>

#include "core/geometry/shortest_paths.h"
#include "core/linalg/sparse_cholesky.h"

namespace toile::linalg {

/// Two numbers for each vertex, #V x 2.
using BlockVector = Eigen::Matrix<double, Eigen::Dynamic, 2, Eigen::RowMajor>;

/// A symmetric matrix of 2 x 2 blocks, one per vertex and one per edge of a graph: unknowns 2 v and
/// 2 v + 1 are x and y of vertex v. The pattern is built once; values can be summed into it
/// repeatedly, each in constant time.
class BlockMatrix {
public:
    /// @param edges  pairs (smaller, larger), sorted, each once
    BlockMatrix(const geometry::VertexPairs& edges, int vertexCount);

    void setZero();
    /// Multiplies the diagonal entries.
    void scaleDiagonal(double factor);
    /// The larger of a vertex's two diagonal entries.
    double largestOnDiagonal(int v) const;
    /// Symmetric block on the diagonal.
    void addVertex(int v, const Eigen::Matrix2d& block);
    /// Block at the rows of the edge's larger vertex and the columns of its smaller one.
    void addEdge(int e, const Eigen::Matrix2d& block);
    /// Index of the edge between two vertices, -1 if there is none. Cost: a binary search.
    int findEdge(int v, int w) const;

    /// The matrix times x.
    BlockVector product(const BlockVector& x) const;
    /// The blocks above the diagonal times x.
    BlockVector upperProduct(const BlockVector& x) const;
    /// Gauss-Seidel sweep from the first vertex to the last: solves with the diagonal blocks and
    /// those below. Precondition: the diagonal blocks are positive definite.
    /// @param x  the right side, then the solution
    void sweepForth(BlockVector& x) const;
    /// The backward sweep, its transpose: solves with the diagonal blocks and those above.
    void sweepBack(BlockVector& x) const;

    const SymmetricMatrix& matrix() const { return matrix_; }

private:
    const double* column(int c) const { return &matrix_.value[matrix_.columnStart[c]]; }
    double* column(int c) { return &matrix_.value[matrix_.columnStart[c]]; }
    Eigen::RowVector2d above(int v, const BlockVector& x) const;
    void addBelow(int v, const Eigen::RowVector2d& x, BlockVector& y) const;
    Eigen::RowVector2d solveVertex(int v, const Eigen::RowVector2d& right) const;

    geometry::VertexPairs edges_;
    std::vector<int> firstEdge_;  ///< #V + 1: edges whose smaller vertex is v
    SymmetricMatrix matrix_;
};

}  // namespace toile::linalg
