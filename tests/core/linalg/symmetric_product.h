// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include "core/linalg/sparse_cholesky.h"

namespace toile::test {

/// A X, one column after the other, from the lower triangle that A stores.
inline Eigen::MatrixXd times(const linalg::SymmetricMatrix& A, const Eigen::MatrixXd& X) {
    Eigen::MatrixXd result = Eigen::MatrixXd::Zero(X.rows(), X.cols());
    for (int j = 0; j < A.size; ++j) {
        for (int k = A.columnStart[j]; k < A.columnStart[j + 1]; ++k) {
            result.row(A.row[k]) += A.value[k] * X.row(j);
            if (A.row[k] != j) {
                result.row(j) += A.value[k] * X.row(A.row[k]);
            }
        }
    }
    return result;
}

}  // namespace toile::test
