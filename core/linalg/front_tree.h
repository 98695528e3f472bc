// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "core/base/result.h"
#include "core/geometry/buckets.h"
#include "core/linalg/sparse_cholesky.h"

namespace toile::linalg {

/// A dense matrix that is eliminated in one step: consecutive unknowns and the later ones that they
/// are coupled to.
struct Front {
    int first = 0;             ///< position of its first unknown in the elimination order
    int columns = 0;           ///< number of unknowns that it eliminates
    int rows = 0;              ///< these and the later ones
    int parent = -1;           ///< front that receives the remainder; a larger index
    std::size_t rowStart = 0;  ///< of its rows in `FrontTree::row` and `placeInParent`
    std::size_t start = 0;     ///< of its columns in the factor, each of `rows` numbers
    std::size_t kept = 0;      ///< position of the remainder for its parent in working memory

    int left() const { return rows - columns; }
};

/// Consecutive fronts for one thread, the last of which is above all others.
struct FrontTask {
    int first = 0, last = 0;  ///< fronts
    int parent = -1;          ///< task that waits for it; a larger index
    double way = 0;           ///< multiplications from here to the root
};

/// How a matrix is eliminated by fronts: the fronts, the data they pass on, and which can
/// run in parallel. Follows from the pattern and the order alone.
struct FrontTree {
    std::vector<int> order;            ///< the unknowns in elimination order
    std::vector<Front> fronts;         ///< children before their parents
    std::vector<int> row;              ///< of each front: its rows, as positions in the order
    std::vector<int> placeInParent;    ///< of each row past a front's own columns: its index
                                       ///< among the parent's rows
    geometry::Buckets<> children;      ///< of each front
    geometry::Buckets<> entries;       ///< of each front: the matrix's entries that it starts with
    std::vector<int> place;            ///< of each entry: position in its front's columns
    std::vector<FrontTask> tasks;      ///< children before their parents
    geometry::Buckets<> taskChildren;  ///< of each task
    std::size_t factorSize = 0;        ///< numbers in the factor
    std::size_t workSize = 0;          ///< numbers in working memory
};

/// Builds the elimination tree.
/// @param order  of the unknowns; empty: minimum degree
/// Errors: OutOfMemory.
Result<FrontTree> frontTree(const SymmetricMatrix& pattern, const std::vector<int>& order);

enum class FrontSense {
    Upwards,   ///< a task runs after all its children
    Downwards  ///< a task runs before its children
};

enum class FrontsDone { All, Refused, NoRoom };

/// Runs every task of a tree once, independent ones in parallel; within a `BlasCall`, on as many of
/// the threads as there is memory for.
/// @param work  runs a task. False: it failed, and the others need not run. Its exceptions are
///              rethrown on the calling thread after the others have ended
/// @return NoRoom: there is no memory even for the calling thread
FrontsDone doFronts(const FrontTree& tree, FrontSense sense, int threads,
                    const std::function<bool(int)>& work);

}  // namespace toile::linalg
