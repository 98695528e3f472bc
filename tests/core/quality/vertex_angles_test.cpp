// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "core/mesh/cotangents.h"
#include "core/quality/measures.h"
#include "tests/core/support/random_piece.h"
#include "tests/core/support/shapes.h"

namespace toile {
namespace {

using std::numbers::pi;

Eigen::VectorXd summedCorners(const MeshArrays& mesh) {
    Eigen::VectorXd sum = Eigen::VectorXd::Zero(mesh.V.rows());
    const Eigen::MatrixX3d corners = cornerAngles3d(mesh);
    for (int f = 0; f < mesh.F.rows(); ++f) {
        for (int k = 0; k < 3; ++k) {
            sum[mesh.F(f, k)] += corners(f, k);
        }
    }
    return sum;
}

/// Triangles of a given angle around the origin, each standing on the one before: a cone wound up
/// any number of times.
MeshArrays fan(int triangles, double angle, double longer = 1) {
    MeshArrays mesh;
    mesh.V.resize(triangles + 2, 3);
    mesh.F.resize(triangles, 3);
    mesh.V.row(0).setZero();
    for (int k = 0; k <= triangles; ++k) {
        const double length = k % 2 == 0 ? 1 : longer;
        mesh.V.row(k + 1) << length * std::cos(angle * k), length * std::sin(angle * k), 0;
        if (k < triangles) {
            mesh.F.row(k) << 0, k + 1, k + 2;
        }
    }
    return mesh;
}

TEST(VertexAngles, AreTheSumsOfTheCorners) {
    for (unsigned seed = 0; seed < 50; ++seed) {
        const MeshArrays mesh = test::randomPiece(seed);
        EXPECT_LT((vertexAngles3d(mesh) - summedCorners(mesh)).cwiseAbs().maxCoeff(), 1e-12);
    }
}

TEST(VertexAngles, CountTurns) {
    for (const double angle : {1e-9, 1e-3, 0.1, 1.0, pi / 2, 2.0, 3.1, pi - 1e-9}) {
        for (const int triangles : {1, 2, 3, 4, 7, 50, 2000}) {
            EXPECT_NEAR(vertexAngles3d(fan(triangles, angle))[0], triangles * angle,
                        1e-12 * triangles)
                << angle;
        }
    }
}

TEST(VertexAngles, StayExactAtWholeTurns) {
    for (const int n : {3, 4, 6, 8, 12}) {  // rounding falls on either side of 2 pi
        EXPECT_NEAR(vertexAngles3d(fan(5 * n, 2 * pi / n))[0], 10 * pi, 1e-12);
    }
}

TEST(VertexAngles, BearSidesOfAnySize) {
    for (const double longer : {1e-8, 1e-3, 1e3, 1e8}) {
        EXPECT_NEAR(vertexAngles3d(fan(3000, 1, longer))[0], 3000, 1e-9) << longer;
    }
    for (const double scale : {1e-30, 1e30}) {
        MeshArrays mesh = test::sphericalCap(4, 1, 1);
        const Eigen::VectorXd angles = vertexAngles3d(mesh);
        mesh.V *= scale;
        EXPECT_LT((vertexAngles3d(mesh) - angles).cwiseAbs().maxCoeff(), 1e-12);
    }
}

TEST(VertexAngles, AreZeroWithoutTriangles) {
    EXPECT_EQ(vertexAngles3d({Points3::Zero(2, 3), Triangles(0, 3)}), Eigen::VectorXd::Zero(2));
}

/// At each turn of the corners, as the code takes them one by one.
TEST(Cotangents, KeepTheirDigitsInNeedles) {
    for (const double thin : {1e-2, 1e-5, 1e-9}) {
        for (int turn = 0; turn < 3; ++turn) {
            // Sides thin, about 1 and about 1; the angle at the short side's first end is 2.
            const Eigen::RowVector3d points[3] = {
                {0, 0, 0}, {thin, 0, 0}, {std::cos(2.0), std::sin(2.0), 0}};
            MeshArrays mesh{Points3(3, 3), Triangles(1, 3)};
            mesh.F << 0, 1, 2;
            for (int k = 0; k < 3; ++k) {
                mesh.V.row(k) = points[(k + turn) % 3];
            }
            const EdgeTable table = buildEdgeTable(mesh.F, 3);
            const Eigen::VectorXd weights = cotangentWeights(mesh, table);
            const int opposite = (0 - turn + 3) % 3 + 1;  // side from the corner after points[0]
            EXPECT_NEAR(weights[table.faceEdges(0, opposite % 3)], 0.5 / std::tan(2.0), 1e-13)
                << thin << ' ' << turn;
        }
    }
}

}  // namespace
}  // namespace toile
