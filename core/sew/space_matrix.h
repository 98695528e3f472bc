// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <utility>
#include <vector>

#include <Eigen/Core>

#include "core/linalg/sparse_cholesky.h"

namespace toile::sew {

/// A symmetric matrix of 3 x 3 blocks, one per vertex and one per pair of vertices that act on each
/// other: unknown 3 v + k is coordinate k of vertex v. The sparsity pattern is fixed; blocks can be
/// summed into it repeatedly, in the order of the calls.
class SpaceMatrix {
public:
    /// @param pairs  in any order and direction; may include duplicates
    SpaceMatrix(std::vector<std::pair<int, int>> pairs, int vertexCount);

    void setZero();
    /// Adds a block to the rows of v and the columns of w, and its transpose. If v = w the block
    /// must be symmetric. Precondition: the pair is in the pattern. Cost: a binary search. Several
    /// threads may add at once if their blocks' smaller vertices differ.
    void add(int v, int w, const Eigen::Matrix3d& block);
    void addToDiagonal(int v, double value);

    const linalg::SymmetricMatrix& matrix() const { return matrix_; }

private:
    /// Pairs whose smaller vertex is v: firstPair_[v] to firstPair_[v + 1].
    std::vector<int> firstPair_, larger_;
    linalg::SymmetricMatrix matrix_;
};

}  // namespace toile::sew
