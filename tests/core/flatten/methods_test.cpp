// SPDX-License-Identifier: GPL-3.0-or-later
// What every method must do: be exact where exactness is possible, not depend on where and how
// large the piece is, and stop when asked.
#include <numbers>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "core/flatten/conformal/conformal_methods.h"
#include "core/flatten/flatten.h"
#include "core/flatten/reference/reference_methods.h"
#include "core/garment/garment.h"
#include "core/quality/measures.h"
#include "tests/core/support/shapes.h"

namespace toile {
namespace {

struct Way {
    const char* word;
    FlattenOptions options;
    Result<FlatPiece> (*run)(const Piece&, const FlattenOptions&, const Progress&);
};

/// A method that keeps lengths, those in 3D.
template <auto run>
Result<FlatPiece> in3d(const Piece& piece, const FlattenOptions& options,
                       const Progress& progress) {
    return run(piece, options, progress, {});
}

std::vector<Way> ways() {
    FlattenOptions spectral{Method::Natural};
    spectral.freeBoundary = FreeBoundary::Spectral;
    FlattenOptions mixed{Method::Curvature};
    mixed.authalic = 0.3;
    FlattenOptions stretch{Method::Stretch};
    stretch.stretchOutline = StretchOutline::Curvature;
    return {{"curvature", {Method::Curvature}, in3d<flattenCurvature>},
            {"mixed", mixed, in3d<flattenCurvature>},
            {"stretch", stretch, in3d<flattenStretch>},
            {"natural", {Method::Natural}, flattenNatural},
            {"spectral", spectral, flattenNatural},
            {"lscm", {Method::Lscm}, flattenLscm},
            {"abf", {Method::Abf}, flattenAbf},
            {"convex", {Method::Convex}, in3d<flattenConvex>}};
}

class EveryMethod : public testing::TestWithParam<Way> {
protected:
    Points2 flat(const MeshArrays& mesh) const {
        const auto piece = test::asPiece(mesh);
        Progress progress;
        const auto result = flatten(*piece, GetParam().options, progress);
        EXPECT_TRUE(result) << (result ? "" : sentence(result.error()));
        return result ? result->Q : Points2::Zero(mesh.V.rows(), 2).eval();
    }
};

TEST_P(EveryMethod, DevelopableShapesFlattenIsometrically) {
    if (GetParam().options.method == Method::Convex) {
        GTEST_SKIP() << "an outline on a circle is a sheet's outline by chance only";
    }
    for (const MeshArrays& mesh :
         {test::planeGrid(9, 7, 11), test::cylinderSector(40, 5, 60, std::numbers::pi, 90),
          test::coneSector(36, 6, 60, 260, 4.0, 0.7)}) {
        const Edges edges = buildEdgeTable(mesh.F, static_cast<int>(mesh.V.rows())).edges;
        EXPECT_LE(
            maxRelativeLengthError(edgeLengths3d(mesh.V, edges), edgeLengths2d(flat(mesh), edges)),
            1e-10);
    }
}

TEST_P(EveryMethod, MotionAndScaleChangeNothing) {
    const Eigen::Matrix3d R =
        Eigen::AngleAxisd(1.1, Eigen::Vector3d(1, 2, -1).normalized()).toRotationMatrix();
    for (const MeshArrays& mesh :
         {test::sphericalCap(9, 120, 1.1), test::saddle(12, 200, 0.8), test::cubeOpenedAlongH()}) {
        const Points2 a = flat(mesh);
        const double size = a.cwiseAbs().maxCoeff();
        MeshArrays moved = mesh;
        moved.V = (moved.V * R.transpose()).rowwise() + Eigen::RowVector3d(500, -900, 70);
        EXPECT_LE(test::distanceAfterRigidMotion(a, flat(moved)), 1e-8 * size);
        for (const double scale : {1e-6, 1e6}) {
            MeshArrays scaled = mesh;
            scaled.V *= scale;
            EXPECT_LE(test::distanceAfterRigidMotion(a, Points2(flat(scaled) / scale)),
                      1e-8 * size);
        }
    }
}

TEST_P(EveryMethod, StopsWhenAsked) {
    const auto cap = test::asPiece(test::sphericalCap(8, 90, 1));
    Progress progress;
    progress.cancel();
    const auto stopped = GetParam().run(*cap, GetParam().options, progress);
    ASSERT_FALSE(stopped);
    EXPECT_EQ(stopped.error().code, ErrorCode::Cancelled);
}

TEST_P(EveryMethod, GivesTheSameBytesAgain) {
    const MeshArrays mesh = test::sphericalCap(12, 90, 1.4);
    EXPECT_TRUE((flat(mesh).array() == flat(mesh).array()).all());
}

TEST_P(EveryMethod, TakesASingleTriangleAndAPairOfThem) {
    MeshArrays one{Points3(3, 3), Triangles(1, 3)};
    one.V << 0, 0, 0, 40, 0, 30, 0, 60, 0;
    one.F << 0, 1, 2;
    EXPECT_NEAR(triangleAreas2d(flat(one), one.F)[0], 1500, 1e-8);
    const MeshArrays two = test::planeGrid(1, 1, 10);
    EXPECT_NEAR(triangleAreas2d(flat(two), two.F).sum(), 100, 1e-9);
}

INSTANTIATE_TEST_SUITE_P(Methods, EveryMethod, testing::ValuesIn(ways()),
                         [](const auto& shown) { return std::string(shown.param.word); });

}  // namespace
}  // namespace toile
