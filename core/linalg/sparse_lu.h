// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <Eigen/SparseCore>

#include "core/base/result.h"

namespace toile::linalg {

/// Solves A X = B for a sparse matrix with unsymmetric values at symmetric positions, such as a
/// weighted Laplacian with a different weight per direction: an LU factorisation by UMFPACK, with
/// iterative refinement. Minimum-degree ordering of rows and columns alike; the diagonal is the
/// pivot unless it is far smaller than its column.
/// @param entries  of A, as many rows as B; entries at the same position are summed
/// Errors: FactorisationFailed (singular, or nearly so), OutOfMemory. Cost: one to four times a
/// Cholesky factorisation of the same pattern. Re-entrant.
Result<Eigen::MatrixXd> solveUnsymmetric(const std::vector<Eigen::Triplet<double>>& entries,
                                         const Eigen::MatrixXd& B);

}  // namespace toile::linalg
