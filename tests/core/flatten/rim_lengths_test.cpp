// SPDX-License-Identifier: GPL-3.0-or-later
// The rims of holes are as long in the flat piece as on the garment.
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "core/flatten/flatten.h"
#include "core/flatten/isometric/isometric_descent.h"
#include "core/garment/piece.h"
#include "core/quality/measures.h"
#include "core/quality/piece_quality.h"
#include "tests/core/support/shapes.h"

namespace toile {
namespace {

FlattenOptions by(Method method) {
    FlattenOptions options;
    options.method = method;
    return options;
}

/// With round holes about the places given, of this radius, seen along an axis.
std::shared_ptr<const Piece> withHoles(const MeshArrays& mesh, int axis, double radius,
                                       const std::vector<Eigen::RowVector2d>& places) {
    const int across = axis == 0 ? 1 : 0;
    const int up = axis == 2 ? 1 : 2;
    auto piece = test::asPiece(test::part(mesh, [&](const Eigen::RowVector3d& p) -> bool {
        return std::ranges::none_of(places, [&](const Eigen::RowVector2d& place) {
            return (Eigen::RowVector2d(p[across], p[up]) - place).norm() < radius;
        });
    }));
    EXPECT_FALSE(piece->defect) << sentence(*piece->defect);
    EXPECT_EQ(piece->holes.size(), places.size());
    return piece;
}

/// Cloth that is curved both ways, this way and that, about one hole and two.
std::vector<std::shared_ptr<const Piece>> curvedPieces() {
    return {withHoles(test::bentPanel(30), 2, 90, {{300, 300}}),
            withHoles(test::bentPanel(30), 2, 60, {{180, 250}, {420, 330}}),
            withHoles(test::sphericalCap(24, 100, 0.6), 1, 12, {{20, 10}}),
            withHoles(test::saddle(30, 100, 1.5), 2, 12, {{20, -15}})};
}

double worstError(const Piece& piece, const Points2& Q, const std::vector<int>& loop) {
    const Eigen::VectorXd on = boundaryLengths3d(piece.mesh.V, loop);
    return (boundaryLengths2d(Q, loop) - on).cwiseQuotient(on).lpNorm<Eigen::Infinity>();
}

double worstRim(const Piece& piece, const Points2& Q) {
    double worst = 0;
    for (const auto& rim : piece.holes) {
        worst = std::max(worst, worstError(piece, Q, rim));
    }
    return worst;
}

bool hasNote(const FlatPiece& flat, ErrorCode code) {
    return std::ranges::any_of(flat.notes, [&](const Error& e) { return e.code == code; });
}

TEST(RimLengths, EveryEdgeKeepsItsLength) {
    for (const auto& piece : curvedPieces()) {
        const auto flat = flatten(*piece, by(Method::Isometric), Progress());
        ASSERT_TRUE(flat) << sentence(flat.error());
        EXPECT_FALSE(hasNote(*flat, ErrorCode::RimsNotKept));
        EXPECT_FALSE(hasNote(*flat, ErrorCode::EndedEarly));
        EXPECT_LE(worstRim(*piece, flat->Q), 1e-11);
        EXPECT_LE(worstError(*piece, flat->Q, piece->boundary), 1e-11);
        EXPECT_EQ(flippedTriangles(triangleAreas2d(flat->Q, piece->mesh.F)), 0);
        // Without that they would not: a rim alone is off by some percent.
        const auto conformal = flatten(*piece, by(Method::Curvature), Progress());
        ASSERT_TRUE(conformal);
        EXPECT_GE(worstRim(*piece, conformal->Q), 0.01);
        EXPECT_LT(*measure(*piece, flat->Q).symmetricDirichlet,
                  *measure(*piece, conformal->Q).symmetricDirichlet);
    }
}

TEST(RimLengths, CostLittleDistortion) {
    for (const auto& piece : curvedPieces()) {
        const auto flat = flatten(*piece, by(Method::Isometric), Progress());
        ASSERT_TRUE(flat);
        // The least there is with the outline's lengths alone.
        const auto free = lowerIsometricEnergy(piece->mesh, piece->table, piece->boundary, flat->Q,
                                               {}, Progress());
        ASSERT_TRUE(free);
        const double least = free->distortion - 1;
        EXPECT_LE(*measure(*piece, flat->Q).symmetricDirichlet - 1, 1.5 * least);
    }
}

TEST(RimLengths, FlatClothStaysAsItIs) {
    for (const auto& piece :
         {withHoles(test::planeGrid(20, 12, 10), 2, 35, {{100, 60}}),
          withHoles(test::cylinderSector(20, 12, 60, 2.0, 120), 2, 25, {{0, 70}})}) {
        const auto flat = flatten(*piece, by(Method::Isometric), Progress());
        ASSERT_TRUE(flat);
        EXPECT_NEAR(*measure(*piece, flat->Q).symmetricDirichlet, 1, 1e-9);
        EXPECT_LE(worstRim(*piece, flat->Q), 1e-11);
    }
}

TEST(RimLengths, LargePiecesComeToTheSame) {
    for (const auto& piece : curvedPieces()) {
        const auto start = flatten(*piece, by(Method::Curvature), Progress());
        ASSERT_TRUE(start);
        std::vector<std::vector<int>> all{piece->boundary};
        all.insert(all.end(), piece->holes.begin(), piece->holes.end());
        const EdgeLoops loops(all);
        DescentOptions options;
        const auto direct =
            lowerIsometricEnergy(piece->mesh, piece->table, loops, start->Q, options, Progress());
        options.sizes.large = options.sizes.huge = 1;
        const auto lean =
            lowerIsometricEnergy(piece->mesh, piece->table, loops, start->Q, options, Progress());
        ASSERT_TRUE(direct && lean);
        EXPECT_TRUE(lean->converged);
        EXPECT_NEAR(lean->distortion, direct->distortion, 0.002 * (direct->distortion - 1));
        EXPECT_LE(worstRim(*piece, lean->Q), 1e-11);
    }
}

TEST(RimLengths, WhereNoneIsNearANoteSaysSo) {
    // A sheet with a finger on it, open at its end: the deeper, the longer the way to the rim.
    for (const double depth : {50.0, 200.0, 800.0}) {
        MeshArrays mesh = test::planeGrid(60, 60, 10);
        for (Eigen::Index v = 0; v < mesh.V.rows(); ++v) {
            const double r = (mesh.V.row(v).head<2>() - Eigen::RowVector2d(300, 300)).norm() / 100;
            mesh.V(v, 2) = depth * std::exp(-4 * r * r * r * r);
        }
        const auto piece = test::asPiece(test::part(mesh, [](const Eigen::RowVector3d& p) -> bool {
            return (p.head<2>() - Eigen::RowVector2d(300, 300)).norm() > 12;
        }));
        ASSERT_FALSE(piece->defect) << sentence(*piece->defect);
        ASSERT_EQ(piece->holes.size(), 1U);
        const auto flat = flatten(*piece, by(Method::Isometric), Progress());
        ASSERT_TRUE(flat) << sentence(flat.error());
        EXPECT_TRUE(flat->Q.allFinite());
        EXPECT_LE(worstError(*piece, flat->Q, piece->boundary), 1e-11);
        EXPECT_EQ(hasNote(*flat, ErrorCode::RimsNotKept), worstRim(*piece, flat->Q) > 1e-9);
    }
}

TEST(RimLengths, AreCancelledWithTheRest) {
    Progress progress;
    progress.cancel();
    const auto flat = flatten(*curvedPieces()[0], by(Method::Isometric), progress);
    ASSERT_FALSE(flat);
    EXPECT_EQ(flat.error().code, ErrorCode::Cancelled);
}

}  // namespace
}  // namespace toile
