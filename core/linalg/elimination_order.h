// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <Eigen/Core>

#include "core/linalg/sparse_cholesky.h"

namespace toile::linalg {

/// Where unknowns lie, # x 3.
using Places = Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor>;

/// Nested dissection [Geo73] of the matrix of a mesh: the unknowns of either side of a plane first,
/// what lies between them last, and each side so again. For half a million unknowns it is found in
/// a third of the time of a minimum degree order, and the factor takes less work.
/// @param places  of the unknowns
/// @return the unknowns in the order of their elimination; empty where planes meet the mesh in too
/// many vertices, as when it is rolled up. Pure. Cost: n log n.
std::vector<int> eliminationOrder(const SymmetricMatrix& pattern, const Places& places);

/// Nested dissection of any matrix, by METIS with minimum degree at its ends, as CHOLMOD has it. It
/// takes several times as long as minimum degree, and pays where a pattern is factorised often: of
/// cloth that is sewn the factor takes two thirds of the work or less.
/// @param together  so many unknowns in a row act on the same others, and stay in a row: 3 for
/// points in space
/// @return as above; empty where CHOLMOD was built without. Pure.
std::vector<int> dissectedOrder(const SymmetricMatrix& pattern, int together);

}  // namespace toile::linalg
