// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <Eigen/SparseCore>

#include "core/base/result.h"

namespace toile::linalg {

/// X with A X = B for a sparse unsymmetric matrix whose entries lie symmetrically, as those of a
/// weighted Laplacian with different weights to and fro: an LU factorisation by UMFPACK, with
/// iterative refinement. Minimum-degree ordering of rows and columns alike; the diagonal is taken
/// as pivot unless it is far smaller than its column.
/// @param entries  of A, as many rows as B; entries at the same place are summed
/// Errors: FactorisationFailed (singular, or nearly so), OutOfMemory. Cost: one to four times a
/// Cholesky factorisation of the same pattern. Re-entrant.
Result<Eigen::MatrixXd> solveUnsymmetric(const std::vector<Eigen::Triplet<double>>& entries,
                                         const Eigen::MatrixXd& B);

}  // namespace toile::linalg
