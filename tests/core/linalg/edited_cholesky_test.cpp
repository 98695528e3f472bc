// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/linalg/edited_cholesky.h"

#include <array>
#include <memory>
#include <random>
#include <set>
#include <utility>
#include <vector>

#include <Eigen/Cholesky>
#include <gtest/gtest.h>

#include "tests/core/linalg/symmetric_product.h"

namespace toile {
namespace {

using test::times;

/// The Laplacian of a grid with random weights, some of them negative, and a little on the
/// diagonal. Large grids get a supernodal factor, small ones a simplicial one.
SymmetricMatrix gridMatrix(int side, std::mt19937& random) {
    SymmetricBuilder builder(side * side);
    std::uniform_real_distribution<double> weight(-0.1, 2);
    const auto join = [&](int a, int b) {
        const double w = weight(random);
        builder.add(a, b, -w);
        builder.add(a, a, w + 0.2);
        builder.add(b, b, w + 0.2);
    };
    for (int y = 0; y < side; ++y) {
        for (int x = 0; x < side; ++x) {
            if (x + 1 < side) {
                join(y * side + x, y * side + x + 1);
            }
            if (y + 1 < side) {
                join(y * side + x, (y + 1) * side + x);
            }
        }
    }
    return builder.build();
}

int randomBelow(int bound, std::mt19937& random) {
    return std::uniform_int_distribution<int>(0, bound - 1)(random);
}

/// `count` different numbers below `bound`.
std::vector<int> randomSet(int count, int bound, std::mt19937& random) {
    std::set<int> chosen;
    while (static_cast<int>(chosen.size()) < count) {
        chosen.insert(randomBelow(bound, random));
    }
    return {chosen.begin(), chosen.end()};
}

struct Edited {
    MatrixEdit edit;
    SymmetricMatrix matrix;  ///< of all unknowns; dropped ones have a row of the identity
};

/// An edit of every kind: some unknowns go, some come, some entries change.
Edited randomEdit(const SymmetricMatrix& old, int dropped, int changed, int added,
                  std::mt19937& random) {
    Edited made;
    made.edit.dropped = randomSet(dropped, old.size, random);
    const std::set<int> gone(made.edit.dropped.begin(), made.edit.dropped.end());
    SymmetricBuilder builder(old.size + added);
    for (int j = 0; j < old.size; ++j) {
        for (int k = old.columnStart[j]; k < old.columnStart[j + 1]; ++k) {
            if (!gone.contains(j) && !gone.contains(old.row[k])) {
                builder.add(old.row[k], j, old.value[k]);
            }
        }
    }
    for (const int unknown : gone) {
        builder.add(unknown, unknown, 1);
    }
    std::uniform_real_distribution<double> weight(0, 3);
    const auto join = [&](auto& list, int a, int b, double w) {
        list.push_back({a, b, w});
        return w;
    };
    for (int c = 0; c < changed; ++c) {
        const int a = randomBelow(old.size, random);
        const int b = randomBelow(old.size, random);
        if (a == b || gone.contains(a) || gone.contains(b)) {
            continue;
        }
        const double w = weight(random);
        builder.add(a, b, join(made.edit.changed, a, b, -w));
        builder.add(a, a, join(made.edit.changed, a, a, w));
        builder.add(b, b, join(made.edit.changed, b, b, w + 0.1));
    }
    made.edit.addedCount = added;
    for (int c = 0; c < added; ++c) {
        builder.add(old.size + c, old.size + c, join(made.edit.amongAdded, c, c, 20));
        if (c > 0) {
            builder.add(old.size + c, old.size + c - 1,
                        join(made.edit.amongAdded, c - 1, c, -weight(random)));
        }
        for (int k = 0; k < 4; ++k) {
            const int a = randomBelow(old.size, random);
            if (!gone.contains(a)) {
                builder.add(old.size + c, a, join(made.edit.coupled, a, c, -0.3));
            }
        }
    }
    made.matrix = builder.build();
    return made;
}

TEST(EditedCholesky, SolvesWithWhateverWasDroppedChangedAndAdded) {
    std::mt19937 random(7);
    for (const int side : {2, 5, 20, 150}) {
        const SymmetricMatrix A = gridMatrix(side, random);
        const auto factor = std::make_shared<SparseCholesky>();
        ASSERT_TRUE(factor->factorise(A));
        const int few = std::min(side, side > 100 ? 8 : 30);
        for (const auto& [dropped, changed, added] : std::vector<std::array<int, 3>>{
                 {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {few, 0, 0}, {few, few, few}}) {
            SCOPED_TRACE(testing::Message()
                         << side << ": " << dropped << ' ' << changed << ' ' << added);
            const Edited made = randomEdit(A, dropped, changed, added, random);
            const auto edited = EditedCholesky::make(factor, made.edit);
            ASSERT_TRUE(edited);
            for (const int columns : {1, 2, 3, 5}) {
                Eigen::MatrixXd X = Eigen::MatrixXd::Random(A.size + added, columns);
                for (const int unknown : made.edit.dropped) {
                    X.row(unknown).setZero();
                }
                Eigen::MatrixXd right = times(made.matrix, X);
                for (const int unknown : made.edit.dropped) {
                    right.row(unknown).setConstant(1e3);  // is not looked at
                }
                EXPECT_LE((edited->solve(right) - X).cwiseAbs().maxCoeff(), 1e-10);
            }
        }
    }
}

TEST(EditedCholesky, SolvesWithManyAddedThatNothingOldIsCoupledTo) {
    std::mt19937 random(11);
    const SymmetricMatrix A = gridMatrix(3, random);
    const auto factor = std::make_shared<SparseCholesky>();
    ASSERT_TRUE(factor->factorise(A));
    constexpr int kAdded = 200;
    MatrixEdit edit;
    edit.addedCount = kAdded;
    for (int a = 0; a < kAdded; ++a) {
        edit.amongAdded.push_back({a, a, 2.0});
    }
    const auto edited = EditedCholesky::make(factor, edit);
    ASSERT_TRUE(edited);
    const Eigen::MatrixXd right = Eigen::MatrixXd::Random(A.size + kAdded, 2);
    const Eigen::MatrixXd X = edited->solve(right);
    EXPECT_LE((2 * X.bottomRows(kAdded) - right.bottomRows(kAdded)).cwiseAbs().maxCoeff(), 1e-12);
    EXPECT_LE((X.topRows(A.size) - *factor->solve(right.topRows(A.size))).cwiseAbs().maxCoeff(),
              1e-12);
}

TEST(EditedCholesky, LeavesTheFactorAlone) {
    std::mt19937 random(8);
    const SymmetricMatrix A = gridMatrix(30, random);
    const auto factor = std::make_shared<SparseCholesky>();
    ASSERT_TRUE(factor->factorise(A));
    const Eigen::MatrixXd b = Eigen::MatrixXd::Random(A.size, 2);
    const Eigen::MatrixXd before = *factor->solve(b);
    const auto edited = EditedCholesky::make(factor, randomEdit(A, 9, 9, 9, random).edit);
    ASSERT_TRUE(edited);
    edited->solve(Eigen::MatrixXd::Random(A.size + 9, 2));
    EXPECT_TRUE((factor->solve(b)->array() == before.array()).all());
}

TEST(EditedCholesky, GivesTheSameBytesEveryTime) {
    std::mt19937 random(9);
    const SymmetricMatrix A = gridMatrix(40, random);
    const auto factor = std::make_shared<SparseCholesky>();
    ASSERT_TRUE(factor->factorise(A));
    const MatrixEdit edit = randomEdit(A, 12, 12, 12, random).edit;
    const Eigen::MatrixXd b = Eigen::MatrixXd::Random(A.size + 12, 3);
    const Eigen::MatrixXd first = EditedCholesky::make(factor, edit)->solve(b);
    EXPECT_TRUE((EditedCholesky::make(factor, edit)->solve(b).array() == first.array()).all());
}

TEST(EditedCholesky, RefusesAnEditThatIsNoSmallOne) {
    std::mt19937 random(10);
    const SymmetricMatrix A = gridMatrix(60, random);
    const auto factor = std::make_shared<SparseCholesky>();
    ASSERT_TRUE(factor->factorise(A));
    const auto edited = EditedCholesky::make(
        factor, randomEdit(A, EditedCholesky::kMostColumns + 1, 0, 0, random).edit);
    ASSERT_FALSE(edited);
    EXPECT_EQ(edited.error().code, ErrorCode::FactorisationFailed);
}

}  // namespace
}  // namespace toile
