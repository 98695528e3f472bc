// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/linalg/block_matrix.h"

#include <Eigen/Core>
#include <gtest/gtest.h>

namespace toile {
namespace {

Eigen::MatrixXd dense(const linalg::SymmetricMatrix& matrix) {
    Eigen::MatrixXd full = Eigen::MatrixXd::Zero(matrix.size, matrix.size);
    for (int column = 0; column < matrix.size; ++column) {
        for (int k = matrix.columnStart[column]; k < matrix.columnStart[column + 1]; ++k) {
            full(matrix.row[k], column) = matrix.value[k];
            full(column, matrix.row[k]) = matrix.value[k];
        }
    }
    return full;
}

geometry::VertexPairs triangleWithTail() {
    geometry::VertexPairs edges(4, 2);
    edges << 0, 1, 0, 2, 1, 2, 2, 3;
    return edges;
}

TEST(BlockMatrix, PutsEveryBlockInItsPlace) {
    const geometry::VertexPairs edges = triangleWithTail();
    linalg::BlockMatrix blocks(edges, 4);
    Eigen::MatrixXd expected = Eigen::MatrixXd::Zero(8, 8);
    Eigen::Matrix2d block;
    for (int v = 0; v < 4; ++v) {
        block << v + 1, 0.5, 0.5, v + 2;
        blocks.addVertex(v, block);
        blocks.addVertex(v, block);  // values are summed
        expected.block<2, 2>(2 * v, 2 * v) += 2 * block;
    }
    for (int e = 0; e < 4; ++e) {
        block << 10 * e + 1, 10 * e + 2, 10 * e + 3, 10 * e + 4;
        blocks.addEdge(e, block);
        expected.block<2, 2>(2 * edges(e, 1), 2 * edges(e, 0)) += block;
        expected.block<2, 2>(2 * edges(e, 0), 2 * edges(e, 1)) += block.transpose();
    }
    EXPECT_EQ(dense(blocks.matrix()), expected);
    EXPECT_EQ(blocks.largestOnDiagonal(1), 6);
    blocks.scaleDiagonal(3);
    expected.diagonal() *= 3;
    EXPECT_EQ(dense(blocks.matrix()), expected);
    blocks.setZero();
    EXPECT_EQ(dense(blocks.matrix()), Eigen::MatrixXd::Zero(8, 8));
}

TEST(BlockMatrix, FindsEdgesFromEitherEnd) {
    const linalg::BlockMatrix blocks(triangleWithTail(), 4);
    EXPECT_EQ(blocks.findEdge(1, 2), 2);
    EXPECT_EQ(blocks.findEdge(2, 1), 2);
    EXPECT_EQ(blocks.findEdge(3, 2), 3);
    EXPECT_EQ(blocks.findEdge(0, 3), -1);
    EXPECT_EQ(blocks.findEdge(3, 1), -1);
}

TEST(BlockMatrix, ItsPatternIsWhatTheFactorisationWants) {
    linalg::BlockMatrix blocks(triangleWithTail(), 4);
    for (int round = 1; round <= 2; ++round) {
        blocks.setZero();
        for (int v = 0; v < 4; ++v) {
            blocks.addVertex(v, 4.0 * round * Eigen::Matrix2d::Identity());
        }
        for (int e = 0; e < 4; ++e) {
            blocks.addEdge(e, -Eigen::Matrix2d::Identity());
        }
        linalg::SparseCholesky cholesky;
        ASSERT_TRUE(cholesky.factorise(blocks.matrix()));
        ASSERT_TRUE(cholesky.refactorise(blocks.matrix()));
        const Eigen::VectorXd b = Eigen::VectorXd::LinSpaced(8, 1, 8);
        const auto x = cholesky.solve(b);
        ASSERT_TRUE(x);
        EXPECT_LE((dense(blocks.matrix()) * *x - b).lpNorm<Eigen::Infinity>(), 1e-13);
    }
}

/// Blocks as far from alike as a positive definite matrix lets them be.
linalg::BlockMatrix uneven() {
    linalg::BlockMatrix blocks(triangleWithTail(), 4);
    Eigen::Matrix2d block;
    for (int v = 0; v < 4; ++v) {
        block << 20 + v, 3 - v, 3 - v, 15 + 2 * v;
        blocks.addVertex(v, block);
    }
    for (int e = 0; e < 4; ++e) {
        block << e - 2, 1.5, -0.5 * e, 2.5 - e;
        blocks.addEdge(e, block);
    }
    return blocks;
}

linalg::BlockVector someVector() {
    linalg::BlockVector x(4, 2);
    x << 1, -2, 0.5, 3, -1, 0.25, 2, 7;
    return x;
}

Eigen::VectorXd flatten(const linalg::BlockVector& x) {
    return Eigen::Map<const Eigen::VectorXd>(x.data(), x.size());
}

/// Without the blocks above the diagonal.
Eigen::MatrixXd lowerBlocks(Eigen::MatrixXd full) {
    for (Eigen::Index v = 0; v < full.rows(); v += 2) {
        full.block(v, v + 2, 2, full.cols() - v - 2).setZero();
    }
    return full;
}

TEST(BlockMatrix, MultipliesAsTheDenseMatrixDoes) {
    const linalg::BlockMatrix blocks = uneven();
    const Eigen::MatrixXd full = dense(blocks.matrix());
    const linalg::BlockVector x = someVector();
    EXPECT_LE((flatten(blocks.product(x)) - full * flatten(x)).norm(), 1e-13);
    EXPECT_LE((flatten(blocks.upperProduct(x)) - (full - lowerBlocks(full)) * flatten(x)).norm(),
              1e-13);
}

TEST(BlockMatrix, SweepsSolveWithItsHalves) {
    const linalg::BlockMatrix blocks = uneven();
    const Eigen::MatrixXd lower = lowerBlocks(dense(blocks.matrix()));
    const Eigen::VectorXd right = flatten(someVector());
    linalg::BlockVector forth = someVector();
    blocks.sweepForth(forth);
    EXPECT_LE((lower * flatten(forth) - right).norm(), 1e-13);
    linalg::BlockVector back = someVector();
    blocks.sweepBack(back);
    EXPECT_LE((lower.transpose() * flatten(back) - right).norm(), 1e-13);
}

}  // namespace
}  // namespace toile
