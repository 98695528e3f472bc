// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/base/progress.h"
#include "core/mesh/edge_table.h"
#include "core/mesh/mesh_arrays.h"

namespace toile {

/// Where the isometric descent of a piece may begin.
struct IsometricStart {
    Points2 Q;
    Eigen::VectorXd multipliers{};  ///< of the boundary lengths; empty where none are known
};

/// A start near the end for a piece that is strained much: the descent of a piece with a tenth of
/// its inner vertices (coarsening.h), which itself begins with one of a tenth, and so on, and then
/// the way back. The long way down is gone on small pieces. The boundary keeps all its vertices and
/// its exact lengths.
/// @param mesh, table, boundary  a disk without degenerate triangles
/// @param Q  exact lengths, no flipped triangle
/// @param tolerance  of the coarse descents (DescentOptions)
/// @return no flipped triangle, exact lengths, energy at most that of Q; Q itself where it is
///         strained little, the piece small, or no way back is found. Once cancelled unspecified,
///         but of that kind.
/// Cost: a fifth of a factorisation of size 2 #V, about.
IsometricStart coarseToFine(const MeshArrays& mesh, const EdgeTable& table,
                            const std::vector<int>& boundary, const Points2& Q, double tolerance,
                            const Progress& progress);

}  // namespace toile
