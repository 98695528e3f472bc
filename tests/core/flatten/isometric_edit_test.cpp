// SPDX-License-Identifier: GPL-3.0-or-later
// The isometric descent after a small edit: with what the one before left behind.
#include <chrono>
#include <cmath>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "core/flatten/flatten.h"
#include "core/flatten/interior/interior.h"
#include "core/flatten/isometric/coarsening.h"
#include "core/flatten/isometric/isometric.h"
#include "core/flatten/isometric/isometric_descent.h"
#include "core/flatten/isometric/isometric_start.h"
#include "core/flatten/isometric/kkt_solver.h"
#include "core/quality/measures.h"
#include "core/quality/piece_quality.h"
#include "tests/core/support/piece_edits.h"
#include "tests/core/support/shapes.h"
#include "tests/core/support/turned_triangles.h"

namespace toile {
namespace {

using PiecePointer = std::shared_ptr<const Piece>;

FlattenOptions byIsometric() {
    FlattenOptions options;
    options.method = Method::Isometric;
    return options;
}

/// Strained much: a dart lets it open.
PiecePointer head() {
    return test::originalPiece(test::sphericalCap(24, 90, 2.4));
}

/// Strained little; the two sides of a dart overlap in the plane.
PiecePointer waist() {
    return test::originalPiece(test::saddle(30, 200, 0.004));
}

PiecePointer withDart(const PiecePointer& piece, int start, int edges) {
    return test::opened(*piece, {test::dartAlongEdges(*piece, start, edges)});
}

PiecePointer withDragged(const PiecePointer& piece, int vertex, double far) {
    const Points3& V = piece->mesh.V;
    const double edge = (V.row(piece->mesh.F(0, 0)) - V.row(piece->mesh.F(0, 1))).norm();
    return test::dragged(*piece, vertex, far * edge * Eigen::RowVector3d(0.6, -0.3, 0.7));
}

/// As good as the cold way, exact and without flips.
void expectAsGood(const Piece& piece, const FlatPiece& again) {
    const auto cold = flatten(piece, byIsometric(), Progress());
    ASSERT_TRUE(cold);
    const PieceQuality expected = measure(piece, cold->Q);
    const PieceQuality found = measure(piece, again.Q);
    EXPECT_EQ(found.flippedTriangles, 0);
    EXPECT_LE(found.maxBoundaryLengthError, 1e-9);
    EXPECT_LE(found.outlineCrossings, expected.outlineCrossings);
    EXPECT_LE(*found.symmetricDirichlet - 1, 1.01 * (*expected.symmetricDirichlet - 1));
}

TEST(KeptModel, ServesDragAfterDrag) {
    for (PiecePointer piece : {head(), waist()}) {
        PieceFlattener flattener;
        ASSERT_TRUE(flattener.flatten(piece, byIsometric(), Progress()));
        const int inside = test::deepestVertex(*piece);
        for (int k = 0; k < 12; ++k) {
            SCOPED_TRACE("drag " + std::to_string(k));
            const int rim =
                piece->boundary[static_cast<std::size_t>(7 * k) % piece->boundary.size()];
            piece = withDragged(piece, k % 2 == 0 ? inside : rim, 0.15);
            const auto again = flattener.flatten(piece, byIsometric(), Progress());
            ASSERT_TRUE(again);
            expectAsGood(*piece, *again);
        }
    }
}

TEST(KeptModel, IsOfUseToManyAtATime) {
    const PiecePointer piece = head();
    PieceFlattener flattener;
    ASSERT_TRUE(flattener.flatten(piece, byIsometric(), Progress()));
    const PiecePointer moved = withDragged(piece, piece->boundary[5], 0.3);
    constexpr int kThreads = 4;
    std::vector<Points2> found(kThreads);
    std::vector<std::thread> threads;
    for (int k = 0; k < kThreads; ++k) {
        threads.emplace_back([&, k, mine = flattener]() mutable {
            found[k] = mine.flatten(moved, byIsometric(), Progress())->Q;
        });
    }
    for (std::thread& thread : threads) {
        thread.join();
    }
    for (const Points2& Q : found) {
        EXPECT_EQ(Q, found.front());
    }
}

TEST(KeptModel, ComesToTheSameEnd) {
    const PiecePointer piece = head();
    const Points2 start = *tutteOnCircle(*piece, Progress());
    isometric::DescentOptions options;
    options.tolerance = 1e-6;
    options.sharesModel = true;
    const auto descend = [&](const Points2& from) -> isometric::DescentResult {
        const auto end = isometric::lowerIsometricEnergy(piece->mesh, piece->table, piece->boundary,
                                                         from, options, Progress());
        EXPECT_TRUE(end);
        return *end;
    };
    const isometric::DescentResult first = descend(start);
    ASSERT_TRUE(first.model);
    EXPECT_GT(first.model->factor->bytes(), 0U);
    options.model = first.model;
    options.multipliers = first.multipliers;
    EXPECT_LE(descend(first.Q).iterations, 2);
    // From far away it is of no use, and does no harm.
    const isometric::DescentResult far = descend(start);
    EXPECT_TRUE(far.converged);
    EXPECT_NEAR(far.distortion, first.distortion, 1e-3 * (first.distortion - 1));
}

TEST(KeptModel, IsNotKeptOfLargePieces) {
    const PiecePointer piece = head();
    isometric::DescentOptions options;
    options.sharesModel = true;
    options.sizes.large = 100;
    const auto end =
        isometric::lowerIsometricEnergy(piece->mesh, piece->table, piece->boundary,
                                        *tutteOnCircle(*piece, Progress()), options, Progress());
    ASSERT_TRUE(end);
    EXPECT_FALSE(end->model);
}

TEST(KeptModel, TakesNoMoreThanExpected) {
    for (const PiecePointer& piece : {head(), waist()}) {
        PieceFlattener flattener;
        ASSERT_TRUE(flattener.flatten(piece, byIsometric(), Progress()));
        EXPECT_LE(flattener.keptBytes(), PieceFlattener::expectedBytes(*piece));
    }
}

TEST(WarmStart, OpensADartOfAStrainedPieceFromACoarseOne) {
    const PiecePointer before = head();
    PieceFlattener flattener;
    ASSERT_TRUE(flattener.flatten(before, byIsometric(), Progress()));
    for (const int start : {10, 16}) {
        const PiecePointer after = withDart(before, start, 12);
        const auto again = flattener.flatten(after, byIsometric(), Progress());
        ASSERT_TRUE(again);
        expectAsGood(*after, *again);
    }
}

TEST(WarmStart, SaysNothingWhereAllIsOtherwise) {
    const PiecePointer before = head();
    FlatteningMemory memory;
    memory.flattened = before;
    memory.Q = std::make_shared<const Points2>(*tutteOnCircle(*before, Progress()));
    memory.simple = memory.Q;
    memory.distortion = 2;
    memory.multipliers = std::make_shared<const Eigen::VectorXd>(
        Eigen::VectorXd::Ones(static_cast<Eigen::Index>(before->boundary.size())));
    const isometric::WarmStart same(*before, memory);
    EXPECT_EQ(same.multipliers(), *memory.multipliers);
    MeshArrays pulled = before->mesh;
    pulled.V.col(0) *= 3;
    const PiecePointer other = test::originalPiece(std::move(pulled));
    const isometric::WarmStart warm(*other, memory);
    EXPECT_FALSE(warm.positions(Progress()));
    EXPECT_FALSE(warm.fromCoarse(1e-4, Progress()));
    // A dart's own edges do not pull yet.
    const PiecePointer cut = withDart(before, 10, 6);
    const Eigen::VectorXd multipliers = isometric::WarmStart(*cut, memory).multipliers();
    EXPECT_EQ(multipliers.size(), static_cast<Eigen::Index>(cut->boundary.size()));
    EXPECT_EQ(multipliers.sum(), static_cast<double>(before->boundary.size()));
}

TEST(WarmStart, PartsTheSidesOfADartThatOverlap) {
    const PiecePointer before = waist();
    PieceFlattener flattener;
    ASSERT_TRUE(flattener.flatten(before, byIsometric(), Progress()));
    PiecePointer after = withDart(before, 15, 12);
    auto again = flattener.flatten(after, byIsometric(), Progress());
    ASSERT_TRUE(again);
    expectAsGood(*after, *again);
    // And when it is dragged, and closed again.
    after = withDragged(after, after->boundary[3], 0.1);
    again = flattener.flatten(after, byIsometric(), Progress());
    ASSERT_TRUE(again);
    expectAsGood(*after, *again);
    again = flattener.flatten(before, byIsometric(), Progress());
    ASSERT_TRUE(again);
    expectAsGood(*before, *again);
}

TEST(CutSides, ArePartedByTheGapAskedFor) {
    const PiecePointer cut = withDart(test::originalPiece(test::planeGrid(16, 16, 10)), 8, 6);
    const Points2 flat = cut->mesh.V.leftCols<2>();
    const auto n = static_cast<Eigen::Index>(cut->boundary.size());
    Points2 parted = flat;
    isometric::partCutSides(*cut, Eigen::VectorXd::Constant(n, 0.5), parted);
    int moved = 0;
    for (Eigen::Index v = 0; v < flat.rows(); ++v) {
        const double way = (parted.row(v) - flat.row(v)).norm();
        EXPECT_TRUE(way == 0 || std::abs(way - 0.25) < 1e-12);
        moved += way > 0 ? 1 : 0;
    }
    EXPECT_EQ(moved, 2 * 6);  // both sides but for the tip
    EXPECT_EQ(test::turnedTriangles(parted, cut->mesh.F), 0);
    // What is apart already stays.
    const Points2 once = parted;
    isometric::partCutSides(*cut, Eigen::VectorXd::Constant(n, 0.2), parted);
    EXPECT_EQ(parted, once);
}

TEST(Coarsening, CarriesDetailsAlongAffinely) {
    const PiecePointer piece = head();
    const Points2 before = *tutteOnCircle(*piece, Progress());
    const isometric::Coarsening coarse(piece->mesh, piece->table, piece->boundary, before,
                                       Progress());
    EXPECT_TRUE(coarse.savesWork());
    Eigen::Matrix2d turn;
    turn << 1.3, -0.4, 0.7, 0.9;
    const Points2 after = (before * turn).rowwise() + Eigen::RowVector2d(3, -2);
    const auto followed = coarse.followed(before, coarse.restricted(after));
    ASSERT_TRUE(followed);
    EXPECT_LE((*followed - after).lpNorm<Eigen::Infinity>(), 1e-6);
}

TEST(PieceFlattener, CanBeCancelledAtAnyTimeAfterAnEdit) {
    const PiecePointer before = waist();
    PieceFlattener flattener;
    ASSERT_TRUE(flattener.flatten(before, byIsometric(), Progress()));
    const std::size_t kept = flattener.keptBytes();
    const PiecePointer after = withDart(before, 15, 12);
    PieceFlattener undisturbed = flattener;
    const auto whole = undisturbed.flatten(after, byIsometric(), Progress());
    ASSERT_TRUE(whole);
    for (int k = 0; k < 12; ++k) {
        PieceFlattener mine = flattener;
        Progress progress;
        std::thread impatient([&progress, k]() {
            std::this_thread::sleep_for(std::chrono::microseconds(50 << k));
            progress.cancel();
        });
        const auto flat = mine.flatten(after, byIsometric(), progress);
        impatient.join();
        if (flat) {
            EXPECT_EQ(flat->Q, whole->Q);
            continue;
        }
        EXPECT_EQ(flat.error().code, ErrorCode::Cancelled);
        EXPECT_EQ(mine.keptBytes(), kept);
        const auto next = mine.flatten(after, byIsometric(), Progress());
        ASSERT_TRUE(next);
        EXPECT_EQ(next->Q, whole->Q);
    }
}

}  // namespace
}  // namespace toile
