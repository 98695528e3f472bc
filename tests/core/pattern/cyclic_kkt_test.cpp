// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <numbers>

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <gtest/gtest.h>

#include "core/pattern/fair_solver.h"
#include "tests/core/support/generator.h"

namespace toile::fairing {
namespace {

using Eigen::MatrixXd;
using Eigen::Vector2d;
using Eigen::VectorXd;

struct Programme {
    std::vector<KktStep> steps;
    std::vector<KktRight> right;
};

/// Around a circle, with uneven steps; every fourth node held where there are held ones, and the
/// bends beside it left out, as at a corner.
Programme around(int count, bool corners, bool compressed) {
    test::Generator random(7);
    Programme made;
    made.steps.resize(static_cast<std::size_t>(count));
    made.right.resize(made.steps.size());
    for (int j = 0; j < count; ++j) {
        const double phi = 2 * std::numbers::pi * j / count;
        const double length = random.between(0.1, 0.2);
        const Vector2d d(random.between(-1, 1), random.between(-1, 1));
        KktStep& step = made.steps[j];
        step.lever = length * Vector2d(-std::sin(phi), std::cos(phi));
        step.held = corners && (j + 1) % 4 == 0;
        step.bend = corners && (j % 4 == 0 || step.held) ? 0 : 2 / length;
        step.spacing = random.between(0.1, 0.2);
        step.tension = random.between(compressed ? -2e-3 : 0, 0.1);
        step.hold = 0.3 * (Eigen::Matrix2d::Identity() + 4 * d * d.transpose());
        KktRight& right = made.right[j];
        right.force << random.between(-1, 1), random.between(-1, 1);
        right.slope = random.between(-1, 1);
        right.gap << random.between(-0.01, 0.01), random.between(-0.01, 0.01);
        right.given = step.held ? random.between(-1, 1) : 0;
    }
    return made;
}

/// The same programme as one dense system in (p, phi, kappa) and the multipliers of its rows.
struct Dense {
    MatrixXd H, A;
    VectorXd g, b;

    explicit Dense(const Programme& of) {
        const int n = static_cast<int>(of.steps.size());
        H = MatrixXd::Zero(4 * n, 4 * n);
        g = VectorXd::Zero(4 * n);
        A = MatrixXd::Zero(4 * n, 4 * n);
        b = VectorXd::Zero(4 * n);
        int rows = 3 * n;
        for (int j = 0; j < n; ++j) {
            const KktStep& step = of.steps[j];
            const KktRight& right = of.right[j];
            const int p = 2 * j, phi = 2 * n + j, kappa = 3 * n + j;  // kappa at node j + 1
            const int after = (j + 1) % n, before = 3 * n + (j + n - 1) % n;
            H.block<2, 2>(p, p) += step.hold;
            H(phi, phi) += step.tension;
            H(kappa, kappa) += step.bend;
            H(before, before) += step.bend;
            H(kappa, before) -= step.bend;
            H(before, kappa) -= step.bend;
            g.segment<2>(p) += right.force;
            g[kappa] += step.bend * right.slope;
            g[before] -= step.bend * right.slope;
            for (int axis = 0; axis < 2; ++axis) {
                A(p + axis, 2 * after + axis) += 1;
                A(p + axis, p + axis) -= 1;
                A(p + axis, phi) = -step.lever[axis];
                b[p + axis] = right.gap[axis];
            }
            A(phi, 2 * n + after) += 1;
            A(phi, phi) -= 1;
            A(phi, kappa) = -step.spacing;
            if (step.held) {
                A(rows, kappa) = 1;
                b[rows++] = right.given;
            }
        }
        A.conservativeResize(rows, 4 * n);
        b.conservativeResize(rows);
    }

    VectorXd solution() const {
        const Eigen::Index n = H.rows(), m = A.rows();
        MatrixXd K = MatrixXd::Zero(n + m, n + m);
        K << H, A.transpose(), A, MatrixXd::Zero(m, m);
        VectorXd right(n + m);
        right << -g, b;
        return K.fullPivLu().solve(right);
    }

    /// By the inertia of H on the null space of A.
    bool isConvex() const {
        const MatrixXd Z = A.fullPivLu().kernel();
        const Eigen::SelfAdjointEigenSolver<MatrixXd> reduced(Z.transpose() * H * Z);
        return reduced.eigenvalues().minCoeff() > 0;
    }
};

void expectDenseSolution(const Programme& of) {
    const Dense dense(of);
    const VectorXd expected = dense.solution();
    CyclicKkt kkt;
    kkt.factorise(of.steps);
    std::vector<KktMove> moves;
    kkt.solve(of.right, moves);
    const int n = static_cast<int>(of.steps.size());
    const double size = 1 + expected.head(4 * n).lpNorm<Eigen::Infinity>();
    const double force = size + expected.tail(expected.size() - 4 * n).lpNorm<Eigen::Infinity>();
    int row = 7 * n;
    for (int j = 0; j < n; ++j) {
        EXPECT_LT((moves[j].p - expected.segment<2>(2 * j)).norm(), 1e-9 * size);
        EXPECT_NEAR(moves[j].phi, expected[2 * n + j], 1e-9 * size);
        EXPECT_NEAR(moves[j].kappa, expected[3 * n + j], 1e-9 * size);
        // The dense system's multipliers have the other sign: they push back.
        EXPECT_LT((moves[j].pull + expected.segment<2>(4 * n + 2 * j)).norm(), 1e-9 * force);
        if (of.steps[j].held) {
            EXPECT_NEAR(moves[j].torque, -expected[row++], 1e-9 * force);
        }
    }
    EXPECT_EQ(kkt.isConvex(), dense.isConvex());
    const VectorXd x = expected.head(4 * n);
    EXPECT_NEAR(kkt.curvature(moves), x.dot(dense.H * x), 1e-9 * size * size);
}

TEST(CyclicKkt, SolvesTheDenseSystem) {
    for (const int count : {3, 4, 9, 32, 64}) {
        SCOPED_TRACE(count);
        expectDenseSolution(around(count, false, false));
    }
}

TEST(CyclicKkt, SolvesTheDenseSystemWithCorners) {
    for (const int count : {8, 16, 64}) {
        SCOPED_TRACE(count);
        expectDenseSolution(around(count, true, false));
    }
}

TEST(CyclicKkt, SolvesTheDenseSystemUnderSomeCompression) {
    expectDenseSolution(around(64, false, true));
    expectDenseSolution(around(64, true, true));
}

TEST(CyclicKkt, KnowsWhereThereIsNoMinimum) {
    for (const int count : {9, 32}) {
        Programme buckling = around(count, false, false);
        for (KktStep& step : buckling.steps) {
            step.tension = -30;
        }
        CyclicKkt kkt;
        kkt.factorise(buckling.steps);
        EXPECT_FALSE(kkt.isConvex());
        EXPECT_FALSE(Dense(buckling).isConvex());
    }
}

TEST(CyclicKkt, TakesALineWhoseTurnsAreAllGiven) {
    Programme rigid = around(12, false, false);
    for (std::size_t j = 0; j < rigid.steps.size(); ++j) {
        rigid.steps[j].held = true;
        rigid.right[j].gap.setZero();
        rigid.right[j].given = 0;
    }
    CyclicKkt kkt;
    kkt.factorise(rigid.steps);
    std::vector<KktMove> moves;
    kkt.solve(rigid.right, moves);
    for (const KktMove& move : moves) {
        EXPECT_TRUE(move.p.allFinite());
        EXPECT_EQ(move.kappa, 0);
    }
}

}  // namespace
}  // namespace toile::fairing
