// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

namespace toile {

/// A matrix that stands in a larger one.
using DenseBlock = Eigen::Map<Eigen::MatrixXd, 0, Eigen::OuterStride<>>;

/// U := U U^T in the upper triangle, for square upper triangular U; what stands below is neither
/// read nor changed. Cost: n^3 / 6 multiplications, by LAPACK.
void squareUpper(DenseBlock& U);

/// A := L with A = L L^T, in the lower triangle; what stands above is neither read nor changed.
/// @return false where A is not positive definite. Cost: n^3 / 6 multiplications, by LAPACK.
bool factoriseDense(Eigen::MatrixXd& A);

}  // namespace toile
