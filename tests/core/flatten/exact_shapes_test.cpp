// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <numbers>
#include <vector>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "core/flatten/flatten.h"
#include "core/quality/measures.h"
#include "tests/core/support/shapes.h"

namespace toile {
namespace {

struct NamedShape {
    const char* name;
    MeshArrays mesh;
};

std::vector<NamedShape> developables() {
    return {{"plane", test::planeGrid(9, 7, 11)},
            {"cylinder", test::cylinderSector(24, 9, 80, 2.5, 150)},
            {"half turn", test::cylinderSector(40, 5, 60, std::numbers::pi, 90)},
            {"cone", test::coneSector(20, 8, 120, 300, 2.2, 0.5)},
            {"wide cone", test::coneSector(36, 6, 60, 260, 4.0, 0.7)}};
}

std::vector<NamedShape> curved() {
    return {{"cap", test::sphericalCap(9, 120, 1.1)},
            {"saddle", test::saddle(12, 200, 0.8)},
            {"cube", test::cubeOpenedAlongH()}};
}

FlatPiece flatOfWay(const Piece& piece, const FlattenOptions& options = {}) {
    Progress progress;
    auto flat = flatten(piece, options, progress);
    EXPECT_TRUE(flat) << (flat ? "" : sentence(flat.error()));
    FlatPiece nothing;
    nothing.Q = Points2::Zero(piece.mesh.V.rows(), 2);
    return flat ? *flat : nothing;
}

/// Angle defect of the interior vertices: zero where a mesh is developable.
double largestInteriorCurvature(const Piece& piece) {
    Eigen::VectorXd sum = Eigen::VectorXd::Zero(piece.mesh.V.rows());
    const Eigen::MatrixX3d angles = cornerAngles3d(piece.mesh);
    for (int f = 0; f < piece.mesh.F.rows(); ++f) {
        for (int k = 0; k < 3; ++k) {
            sum[piece.mesh.F(f, k)] += angles(f, k);
        }
    }
    for (const int v : piece.boundary) {
        sum[v] = 2 * std::numbers::pi;
    }
    return (sum.array() - 2 * std::numbers::pi).abs().maxCoeff();
}

class EveryWay : public testing::TestWithParam<FlattenOptions> {};

/// The natural boundary depends a little on the pair of vertices pinned, so on the numbering.
class KeepingLengths : public EveryWay {};

TEST_P(EveryWay, DevelopableShapesFlattenIsometrically) {
    for (const NamedShape& shape : developables()) {
        SCOPED_TRACE(shape.name);
        const auto piece = test::asPiece(shape.mesh);
        ASSERT_FALSE(piece->defect);
        ASSERT_LT(largestInteriorCurvature(*piece), 1e-13);
        const FlatPiece flat = flatOfWay(*piece, GetParam());
        EXPECT_LE(maxRelativeLengthError(edgeLengths3d(piece->mesh.V, piece->table.edges),
                                         edgeLengths2d(flat.Q, piece->table.edges)),
                  1e-9);
    }
}

TEST_P(EveryWay, RigidMotionChangesNothing) {
    const Eigen::Matrix3d R =
        Eigen::AngleAxisd(1.1, Eigen::Vector3d(1, 2, -1).normalized()).toRotationMatrix();
    for (const NamedShape& shape : curved()) {
        SCOPED_TRACE(shape.name);
        const auto piece = test::asPiece(shape.mesh);
        MeshArrays moved = shape.mesh;
        moved.V = (moved.V * R.transpose()).rowwise() + Eigen::RowVector3d(500, -900, 70);
        const FlatPiece a = flatOfWay(*piece, GetParam());
        const FlatPiece b = flatOfWay(*test::asPiece(moved), GetParam());
        const double size = a.Q.cwiseAbs().maxCoeff();
        EXPECT_LE(test::distanceAfterRigidMotion(a.Q, b.Q), 1e-9 * size);
    }
}

TEST_P(KeepingLengths, RenumberingChangesNothing) {
    for (const NamedShape& shape : curved()) {
        SCOPED_TRACE(shape.name);
        const test::Renumbered other = test::renumber(shape.mesh, 17);
        const FlatPiece a = flatOfWay(*test::asPiece(shape.mesh), GetParam());
        const FlatPiece b = flatOfWay(*test::asPiece(other.mesh), GetParam());
        const Points2 inOldOrder = b.Q(other.newIndex, Eigen::all);
        const double size = a.Q.cwiseAbs().maxCoeff();
        EXPECT_LE(test::distanceAfterRigidMotion(a.Q, inOldOrder), 1e-9 * size);
    }
}

TEST_P(EveryWay, ScalingScales) {
    for (const NamedShape& shape : curved()) {
        SCOPED_TRACE(shape.name);
        const FlatPiece a = flatOfWay(*test::asPiece(shape.mesh), GetParam());
        const double size = a.Q.cwiseAbs().maxCoeff();
        for (const double scale : {1e-7, 1e6}) {
            MeshArrays scaled = shape.mesh;
            scaled.V *= scale;
            const FlatPiece b = flatOfWay(*test::asPiece(scaled), GetParam());
            EXPECT_LE(test::distanceAfterRigidMotion(a.Q, Points2(b.Q / scale)), 1e-9 * size);
        }
    }
}

std::string wordsOf(const testing::TestParamInfo<FlattenOptions>& shown) {
    return std::string(name(shown.param.method)) + "_" +
           std::string(name(shown.param.boundarySolver));
}

constexpr FlattenOptions kNewton{Method::Wang2005, BoundarySolver::Newton};
constexpr FlattenOptions kSlcp{Method::Wang2005, BoundarySolver::Slcp};
constexpr FlattenOptions kNatural{Method::Natural, BoundarySolver::Newton};

INSTANTIATE_TEST_SUITE_P(Methods, EveryWay, testing::Values(kNewton, kSlcp, kNatural), wordsOf);
INSTANTIATE_TEST_SUITE_P(Methods, KeepingLengths, testing::Values(kNewton, kSlcp), wordsOf);

}  // namespace
}  // namespace toile
