// SPDX-License-Identifier: GPL-3.0-or-later
// The rims of holes are as long in the flat piece as on the garment.
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "core/flatten/flatten.h"
#include "core/flatten/isometric/isometric.h"
#include "core/flatten/isometric/isometric_descent.h"
#include "core/garment/piece.h"
#include "core/quality/measures.h"
#include "core/quality/outline_crossings.h"
#include "core/quality/piece_quality.h"
#include "tests/core/support/piece_edits.h"
#include "tests/core/support/shapes.h"
#include "tests/core/support/turned_triangles.h"

namespace toile {
namespace {

FlattenOptions rimsBy(Method method) {
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
Pieces curvedPieces() {
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
        const auto flat = flatten(*piece, rimsBy(Method::Isometric), Progress());
        ASSERT_TRUE(flat) << sentence(flat.error());
        EXPECT_FALSE(hasNote(*flat, ErrorCode::RimsNotKept));
        EXPECT_FALSE(hasNote(*flat, ErrorCode::EndedEarly));
        EXPECT_LE(worstRim(*piece, flat->Q), 1e-11);
        EXPECT_LE(worstError(*piece, flat->Q, piece->boundary), 1e-11);
        EXPECT_EQ(test::turnedTriangles(flat->Q, piece->mesh.F), 0);
        // Without that they would not: a rim alone is off rimsBy some percent.
        const auto conformal = flatten(*piece, rimsBy(Method::Curvature), Progress());
        ASSERT_TRUE(conformal);
        EXPECT_GE(worstRim(*piece, conformal->Q), 0.01);
        EXPECT_LT(*measure(*piece, flat->Q).symmetricDirichlet,
                  *measure(*piece, conformal->Q).symmetricDirichlet);
    }
}

TEST(RimLengths, CostLittleDistortion) {
    for (const auto& piece : curvedPieces()) {
        const Piece filled = withHolesFilled(*piece);
        const auto kept = flatten(*piece, rimsBy(Method::Isometric), Progress());
        const auto free = flatten(filled, rimsBy(Method::Isometric), Progress());
        ASSERT_TRUE(kept && free);
        const double least =
            *measure(*piece, free->Q.topRows(piece->mesh.V.rows())).symmetricDirichlet - 1;
        EXPECT_LE(*measure(*piece, kept->Q).symmetricDirichlet - 1, 1.5 * least);
    }
}

TEST(RimLengths, FlatClothStaysAsItIs) {
    for (const auto& piece :
         {withHoles(test::planeGrid(20, 12, 10), 2, 35, {{100, 60}}),
          withHoles(test::cylinderSector(20, 12, 60, 2.0, 120), 2, 25, {{0, 70}})}) {
        const auto flat = flatten(*piece, rimsBy(Method::Isometric), Progress());
        ASSERT_TRUE(flat);
        EXPECT_NEAR(*measure(*piece, flat->Q).symmetricDirichlet, 1, 1e-9);
        EXPECT_LE(worstRim(*piece, flat->Q), 1e-11);
    }
}

TEST(RimLengths, LargePiecesComeToTheSame) {
    for (const auto& piece : curvedPieces()) {
        const auto start = flatten(*piece, rimsBy(Method::Curvature), Progress());
        ASSERT_TRUE(start);
        std::vector<std::vector<int>> all{piece->boundary};
        all.insert(all.end(), piece->holes.begin(), piece->holes.end());
        const EdgeLoops loops(all);
        isometric::DescentOptions options;
        const auto direct = isometric::lowerIsometricEnergy(piece->mesh, piece->table, loops,
                                                            start->Q, options, Progress());
        options.sizes.large = options.sizes.huge = 1;
        const auto lean = isometric::lowerIsometricEnergy(piece->mesh, piece->table, loops,
                                                          start->Q, options, Progress());
        ASSERT_TRUE(direct && lean);
        EXPECT_TRUE(direct->converged && lean->converged);
        EXPECT_LE(worstError(*piece, lean->Q, piece->boundary), 1e-11);
        EXPECT_NEAR(lean->distortion, direct->distortion, 0.002 * (direct->distortion - 1));
        EXPECT_LE(worstRim(*piece, lean->Q), 1e-11);
    }
}

TEST(RimLengths, OfSlitsTooThatLieShut) {
    // A grid, flat and bent, with a slit along its middle: the vertices there are doubled.
    constexpr int kColumns = 20, kRows = 12, kFirst = 6, kLast = 14;
    for (const double bend : {0.0, 0.002}) {
        MeshArrays mesh = test::planeGrid(kColumns, kRows, 10);
        for (auto vertex : mesh.V.rowwise()) {
            vertex.z() = bend * (vertex.x() - 100) * (vertex.x() - 100) +
                         bend * (vertex.y() - 60) * (vertex.y() - 60);
        }
        const auto onSlit = [](const Eigen::RowVector3d& p) -> bool {
            return std::abs(p.y() - 60) < 1e-9 && p.x() > 10 * kFirst + 1e-9 &&
                   p.x() < 10 * kLast - 1e-9;
        };
        std::vector<int> twin(static_cast<std::size_t>(mesh.V.rows()), -1);
        const Eigen::Index before = mesh.V.rows();
        mesh.V.conservativeResize(before + kLast - kFirst - 1, 3);
        int added = static_cast<int>(before);
        for (Eigen::Index v = 0; v < before; ++v) {
            if (onSlit(mesh.V.row(v))) {
                mesh.V.row(added) = mesh.V.row(v);
                twin[static_cast<std::size_t>(v)] = added++;
            }
        }
        ASSERT_EQ(added, mesh.V.rows());
        for (Eigen::Index f = 0; f < mesh.F.rows(); ++f) {
            double height = 0;
            for (int k = 0; k < 3; ++k) {
                height += mesh.V(mesh.F(f, k), 1) / 3;
            }
            for (int k = 0; k < 3 && height > 60; ++k) {
                const int other = twin[static_cast<std::size_t>(mesh.F(f, k))];
                mesh.F(f, k) = other >= 0 ? other : mesh.F(f, k);
            }
        }
        const auto piece = test::asPiece(mesh);
        ASSERT_FALSE(piece->defect) << sentence(*piece->defect);
        ASSERT_EQ(piece->holes.size(), 1U);
        const auto flat = flatten(*piece, rimsBy(Method::Isometric), Progress());
        ASSERT_TRUE(flat) << sentence(flat.error());
        for (const Error& note : flat->notes) {
            ADD_FAILURE() << bend << ": " << sentence(note);
        }
        EXPECT_LE(worstRim(*piece, flat->Q), 1e-11);
        EXPECT_EQ(test::turnedTriangles(flat->Q, piece->mesh.F), 0);
        if (bend == 0) {
            EXPECT_NEAR(*measure(*piece, flat->Q).symmetricDirichlet, 1, 1e-4);
        }
    }
}

TEST(RimLengths, OfThreeEdgesToo) {
    const MeshArrays panel = test::bentPanel(20);
    const auto piece = test::asPiece(test::part(panel, [&](const Eigen::RowVector3d& p) -> bool {
        return std::abs(p.x() - 300) > 15 || std::abs(p.y() - 300) > 15 || p.x() < p.y();
    }));
    ASSERT_EQ(piece->holes.size(), 1U);
    EXPECT_EQ(piece->holes[0].size(), 3U);
    const auto flat = flatten(*piece, rimsBy(Method::Isometric), Progress());
    ASSERT_TRUE(flat);
    EXPECT_LE(worstRim(*piece, flat->Q), 1e-11);
}

TEST(RimLengths, AreKeptAfterAnEditToo) {
    const auto piece = curvedPieces()[1];
    PieceFlattener flattener;
    ASSERT_TRUE(flattener.flatten(piece, rimsBy(Method::Isometric), Progress()));
    Piece edited = *piece;
    edited.mesh.V(test::deepestVertex(edited), 2) += 3;
    const auto after = std::make_shared<const Piece>(std::move(edited));
    const auto flat = flattener.flatten(after, rimsBy(Method::Isometric), Progress());
    ASSERT_TRUE(flat);
    EXPECT_LE(worstRim(*after, flat->Q), 1e-11);
    EXPECT_LE(worstError(*after, flat->Q, after->boundary), 1e-11);
}

/// A sheet with a finger on it, open at its end: the deeper, the longer the way to the rim.
std::shared_ptr<const Piece> openFinger(double depth) {
    MeshArrays mesh = test::planeGrid(60, 60, 10);
    const Eigen::RowVector2d middle(300, 300);
    for (auto vertex : mesh.V.rowwise()) {
        const double r = (vertex.head<2>() - middle).norm() / 100;
        vertex.z() = depth * std::exp(-4 * r * r * r * r);
    }
    return test::asPiece(test::part(mesh, [&](const Eigen::RowVector3d& p) -> bool {
        return (p.head<2>() - middle).norm() > 12;
    }));
}

TEST(RimLengths, OfDeepPiecesAreFoundToo) {
    for (const double depth : {20.0, 50.0, 200.0, 800.0}) {
        const auto piece = openFinger(depth);
        ASSERT_FALSE(piece->defect) << sentence(*piece->defect);
        ASSERT_EQ(piece->holes.size(), 1U);
        const auto flat = flatten(*piece, rimsBy(Method::Isometric), Progress());
        ASSERT_TRUE(flat) << sentence(flat.error());
        EXPECT_FALSE(hasNote(*flat, ErrorCode::RimsNotKept)) << depth;
        EXPECT_LE(worstRim(*piece, flat->Q), 1e-11);
        EXPECT_LE(worstError(*piece, flat->Q, piece->boundary), 1e-11);
        EXPECT_TRUE(outlineIsSimple(flat->Q, piece->holes[0]));
        EXPECT_EQ(test::turnedTriangles(flat->Q, piece->mesh.F), 0);
    }
}

TEST(RimLengths, OfCrumpledRimsToo) {
    // The rim goes up and down rimsBy so much from vertex to vertex.
    for (const double height : {0.5, 8.0, 60.0}) {
        Piece piece = *curvedPieces()[0];
        for (std::size_t i = 0; i < piece.holes[0].size(); ++i) {
            piece.mesh.V(piece.holes[0][i], 2) += i % 2 == 0 ? height : -height;
        }
        const auto flat = flatten(piece, rimsBy(Method::Isometric), Progress());
        ASSERT_TRUE(flat) << sentence(flat.error());
        EXPECT_EQ(hasNote(*flat, ErrorCode::RimsNotKept), worstRim(piece, flat->Q) > 1e-11);
        EXPECT_LE(worstError(piece, flat->Q, piece.boundary), 1e-11);
    }
}

TEST(RimLengths, WhereThereIsNoWayANoteSaysSoAndThePieceStays) {
    const auto piece = curvedPieces()[0];
    const auto conformal = flatten(*piece, rimsBy(Method::Curvature), Progress());
    ASSERT_TRUE(conformal);
    FlatPiece flat = *conformal;
    flat.Q.col(0) *= -1;  // all triangles flipped: no start for the descent
    const Points2 before = flat.Q;
    ASSERT_TRUE(keepRimLengths(*piece, FlattenOptions(), flat, Progress()));
    ASSERT_TRUE(hasNote(flat, ErrorCode::RimsNotKept));
    EXPECT_NE(flat.notes.back().detail.find("mm on the garment"), std::string::npos);
    EXPECT_EQ((flat.Q - before).cwiseAbs().maxCoeff(), 0);
}

TEST(RimLengths, AreCancelledWithTheRest) {
    const auto piece = curvedPieces()[0];
    const auto conformal = flatten(*piece, rimsBy(Method::Curvature), Progress());
    ASSERT_TRUE(conformal);
    FlatPiece flat = *conformal;
    Progress progress;
    progress.cancel();
    const auto kept = keepRimLengths(*piece, FlattenOptions(), flat, progress);
    ASSERT_FALSE(kept);
    EXPECT_EQ(kept.error().code, ErrorCode::Cancelled);
    EXPECT_EQ(flat.Q, conformal->Q);
}

}  // namespace
}  // namespace toile
