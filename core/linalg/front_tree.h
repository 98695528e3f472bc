// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "core/base/result.h"
#include "core/geometry/buckets.h"
#include "core/linalg/sparse_cholesky.h"

namespace toile::linalg {

/// A dense matrix that is eliminated at a time: that of some unknowns in a row and of those later
/// ones that they act on.
struct Front {
    int first = 0;             ///< place of its first unknown in the order of elimination
    int columns = 0;           ///< unknowns that it eliminates
    int rows = 0;              ///< these and the later ones
    int parent = -1;           ///< front that takes up what is left; its number is larger
    std::size_t rowStart = 0;  ///< of its rows in `FrontTree::row` and `placeInParent`
    std::size_t start = 0;     ///< of its columns in the factor, each of `rows` numbers
    std::size_t kept = 0;      ///< where what it leaves to its parent is in the working memory

    int left() const { return rows - columns; }
};

/// Fronts that one thread does in a row, the last of which has all others below it.
struct FrontTask {
    int first = 0, last = 0;  ///< fronts
    int parent = -1;          ///< task that waits for it; its number is larger
    double way = 0;           ///< multiplications from here to the root
};

/// How a matrix is eliminated by fronts: which there are, what they hand on to each other, and
/// which can be done side by side. Follows from the pattern and the order alone.
struct FrontTree {
    std::vector<int> order;            ///< the unknowns in the order of their elimination
    std::vector<Front> fronts;         ///< children before their parents
    std::vector<int> row;              ///< of each front: its rows, by place in the order
    std::vector<int> placeInParent;    ///< of each row past a front's own columns: which of the
                                       ///< parent's rows it is
    geometry::Buckets<> children;      ///< of each front
    geometry::Buckets<> entries;       ///< of each front: the matrix's entries that it begins with
    std::vector<int> place;            ///< of each entry: where in its front's columns
    std::vector<FrontTask> tasks;      ///< children before their parents
    geometry::Buckets<> taskChildren;  ///< of each task
    std::size_t factorSize = 0;        ///< numbers in the factor
    std::size_t workSize = 0;          ///< numbers in working memory
};

/// Lays out the elimination.
/// @param order  of the unknowns; empty: minimum degree
/// Errors: OutOfMemory.
Result<FrontTree> frontTree(const SymmetricMatrix& pattern, const std::vector<int>& order);

}  // namespace toile::linalg
