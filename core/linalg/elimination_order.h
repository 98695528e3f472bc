// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <Eigen/Core>

#include "core/linalg/sparse_cholesky.h"

namespace toile::linalg {

/// Positions of unknowns, # x 3.
using Places = Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor>;

/// Nested dissection [Geo73] of the matrix of a mesh: first the unknowns on either side of a plane,
/// then those between them, and each side likewise. For half a million unknowns it takes a third of
/// the time of a minimum degree order, and the factor takes less work.
/// @param places  of the unknowns
/// @return the unknowns in elimination order; empty if planes meet the mesh in too many vertices,
///         for example if it is rolled up. Pure. Cost: n log n.
std::vector<int> eliminationOrder(const SymmetricMatrix& pattern, const Places& places);

/// Nested dissection of any matrix, by METIS with minimum degree at its leaves, as in CHOLMOD. It
/// takes several times as long as minimum degree, and pays if a pattern is factorised often: for
/// sewn cloth the factor takes two thirds of the work or less.
/// @param together  number of consecutive unknowns that are coupled to the same others and stay
///                  together: 3 for points in space
/// @return as above; empty if CHOLMOD was built without METIS. Pure.
std::vector<int> dissectedOrder(const SymmetricMatrix& pattern, int together);

}  // namespace toile::linalg
