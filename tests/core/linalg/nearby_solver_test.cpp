// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/linalg/nearby_solver.h"

#include <algorithm>
#include <memory>
#include <random>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "core/linalg/sparse_cholesky.h"

namespace toile {
namespace {

using Eigen::MatrixXd;

/// The Laplacian of a grid of side x side unknowns, and a little on the diagonal.
MatrixXd gridMatrix(int side) {
    const int count = side * side;
    MatrixXd A = 0.2 * MatrixXd::Identity(count, count);
    const auto join = [&A](int a, int b) {
        A(a, a) += 1;
        A(b, b) += 1;
        A(a, b) = A(b, a) = -1;
    };
    for (int i = 0; i < count; ++i) {
        if (i % side + 1 < side) {
            join(i, i + 1);
        }
        if (i + side < count) {
            join(i, i + side);
        }
    }
    return A;
}

std::shared_ptr<SparseCholesky> factorOf(const MatrixXd& A) {
    SymmetricBuilder builder(static_cast<int>(A.rows()));
    for (int j = 0; j < A.cols(); ++j) {
        for (int i = j; i < A.rows(); ++i) {
            if (A(i, j) != 0) {
                builder.add(i, j, A(i, j));
            }
        }
    }
    auto factor = std::make_shared<SparseCholesky>();
    EXPECT_TRUE(factor->factorise(builder.build()));
    return factor;
}

struct Case {
    std::shared_ptr<const EditedCholesky> edited;
    MatrixXd B;  ///< dropped unknowns have a row of the identity
    std::vector<int> kept;
};

/// Drops two unknowns, adds two, changes an entry; or does nothing.
Case edited(int side, bool isEdited) {
    const MatrixXd A = gridMatrix(side);
    const auto count = static_cast<int>(A.rows());
    MatrixEdit edit;
    MatrixXd B = A;
    if (isEdited) {
        edit.dropped = {3, count / 2};
        edit.changed = {{1, 1, 0.7}, {2, 2, 0.7}, {1, 2, -0.5}};
        edit.addedCount = 2;
        edit.coupled = {{0, 0, -0.4}, {5, 0, -0.3}, {7, 1, -0.9}};
        edit.amongAdded = {{0, 0, 3}, {1, 1, 4}, {0, 1, -1}};
        B = MatrixXd::Zero(count + 2, count + 2);
        B.topLeftCorner(count, count) = A;
        for (const int unknown : edit.dropped) {
            B.row(unknown).setZero();
            B.col(unknown).setZero();
            B(unknown, unknown) = 1;
        }
        const auto add = [&B](int i, int j, double value) {
            B(i, j) += value;
            B(j, i) += i == j ? 0 : value;
        };
        for (const auto& entry : edit.changed) {
            add(entry.row, entry.column, entry.value);
        }
        for (const auto& entry : edit.coupled) {
            add(entry.row, count + entry.column, entry.value);
        }
        for (const auto& entry : edit.amongAdded) {
            add(count + entry.row, count + entry.column, entry.value);
        }
    }
    auto made = EditedCholesky::make(factorOf(A), edit);
    EXPECT_TRUE(made);
    Case result{std::make_shared<const EditedCholesky>(std::move(*made)), B, {}};
    for (int i = 0; i < B.rows(); ++i) {
        if (!isEdited || (i != 3 && i != count / 2)) {
            result.kept.push_back(i);
        }
    }
    return result;
}

std::vector<MatrixEdit::Entry> entriesOf(const MatrixXd& change) {
    std::vector<MatrixEdit::Entry> entries;
    for (int i = 0; i < change.rows(); ++i) {
        for (int j = 0; j <= i; ++j) {
            if (change(i, j) != 0) {
                entries.push_back({i, j, change(i, j)});
            }
        }
    }
    return entries;
}

/// A sum of squares of so many random sparse vectors.
MatrixXd randomSquare(const Case& of, int rank, std::mt19937& random) {
    MatrixXd square = MatrixXd::Zero(of.B.rows(), of.B.rows());
    for (int k = 0; k < rank; ++k) {
        Eigen::VectorXd v = Eigen::VectorXd::Zero(of.B.rows());
        for (int c = 0; c < 4; ++c) {
            v[of.kept[random() % of.kept.size()]] += 1.0 + 0.1 * c;
        }
        square += v * v.transpose();
    }
    return square;
}

TEST(NearbySolver, SolvesOnTopOfAnEdit) {
    std::mt19937 random(3);
    for (const int side : {4, 12, 25}) {
        for (const bool isEdited : {false, true}) {
            const Case of = edited(side, isEdited);
            for (const int rank : {0, 1, 3, 12}) {
                for (const double sign : {1.0, -0.002}) {
                    SCOPED_TRACE(testing::Message()
                                 << side << ' ' << isEdited << ' ' << rank << ' ' << sign);
                    const MatrixXd change = sign * randomSquare(of, rank, random);
                    const auto solver = NearbySolver::make(of.edited, entriesOf(change));
                    ASSERT_TRUE(solver) << sentence(solver.error());
                    MatrixXd X = MatrixXd::Random(of.B.rows(), 3);
                    for (int i = 0; i < X.rows(); ++i) {
                        X.row(i) *= std::ranges::count(of.kept, i) > 0 ? 1 : 0;
                    }
                    const MatrixXd right = (of.B + change) * X;
                    EXPECT_LE((solver->solve(right) - X).cwiseAbs().maxCoeff(), 1e-11);
                    // C y = (C - B) x, the rest of which is not looked at.
                    MatrixXd asked = change * X;
                    for (int i = 0; i < asked.rows(); ++i) {
                        if (change.row(i).isZero(0)) {
                            asked.row(i).setConstant(7);
                        }
                    }
                    const MatrixXd expected = solver->solve(change * X);
                    EXPECT_LE((solver->solveChange(asked) - expected).cwiseAbs().maxCoeff(), 1e-11);
                }
            }
        }
    }
}

TEST(NearbySolver, RefusesAChangeThatItCannotTakeApart) {
    const Case of = edited(6, false);
    const auto solver = NearbySolver::make(of.edited, {{0, 1, 1}});
    ASSERT_FALSE(solver);
    EXPECT_EQ(solver.error().code, ErrorCode::FactorisationFailed);
}

}  // namespace
}  // namespace toile
