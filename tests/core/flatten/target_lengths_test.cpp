// SPDX-License-Identifier: GPL-3.0-or-later
// An outline has the lengths that are asked of it, where those are not the garment's.
#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "core/flatten/flatten.h"
#include "core/flatten/isometric/isometric_descent.h"
#include "core/quality/measures.h"
#include "core/quality/piece_quality.h"
#include "core/toile/pipeline.h"
#include "tests/core/support/piece_edits.h"
#include "tests/core/support/shapes.h"
#include "tests/core/support/shared_data.h"
#include "tests/core/support/turned_triangles.h"

namespace toile {
namespace {

constexpr double kExact = 1e-9;

FlattenOptions targetsBy(Method method) {
    FlattenOptions options;
    options.method = method;
    return options;
}

std::vector<Method> lengthKeepers() {
    std::vector<Method> keepers;
    for (const MethodTraits& of : allMethods()) {
        if (of.keepsLengths) {
            keepers.push_back(of.method);
        }
    }
    return keepers;
}

Eigen::VectorXd lengthsIn3d(const Piece& piece) {
    return boundaryLengths3d(piece.mesh.V, piece.boundary);
}

/// Those of the edges that lie where it says are longer by a factor.
OutlineTargets stretched(const Piece& piece, double factor,
                         bool (*isMeant)(const Eigen::RowVector3d& middle)) {
    OutlineTargets targets{lengthsIn3d(piece)};
    const auto n = static_cast<Eigen::Index>(piece.boundary.size());
    for (Eigen::Index i = 0; i < n; ++i) {
        const int v = piece.boundary[static_cast<std::size_t>(i)];
        const int w = piece.boundary[static_cast<std::size_t>((i + 1) % n)];
        if (isMeant(0.5 * (piece.mesh.V.row(v) + piece.mesh.V.row(w)))) {
            targets.lengths[i] *= factor;
        }
    }
    return targets;
}

double worstOf(const Piece& piece, const Points2& Q, const OutlineTargets& targets) {
    return maxRelativeLengthError(targets.lengths, boundaryLengths2d(Q, piece.boundary));
}

double strainOf(const Piece& piece, const Points2& Q) {
    return measure(piece, Q).symmetricDirichlet.value_or(std::numeric_limits<double>::infinity()) -
           1;
}

std::shared_ptr<const Piece> flatDisk() {
    MeshArrays mesh = test::sphericalCap(12, 100, 0.8);
    mesh.V.col(1).setZero();
    return test::asPiece(mesh);
}

TEST(TargetLengths, ThoseOfTheGarmentGiveWhatNoneGives) {
    for (const char* name : {"samples/bodice.obj", "samples/trousers.obj", "samples/cap.obj"}) {
        Progress progress;
        const auto garment = loadGarment({test::dataFile(name)}, {}, progress);
        ASSERT_TRUE(garment) << sentence(garment.error());
        for (const auto& piece : garment->pieces) {
            for (const MethodTraits& of : allMethods()) {
                const auto options = targetsBy(of.method);
                const auto none = flatten(*piece, options, Progress());
                const auto same = flatten(*piece, options, Progress(), {lengthsIn3d(*piece)});
                ASSERT_TRUE(none && same);
                EXPECT_EQ(none->Q, same->Q) << name << ' ' << piece->name << ' ' << of.name;
            }
        }
    }
}

TEST(TargetLengths, OneSideOfASquareGrows) {
    const auto piece = test::asPiece(test::planeGrid(12, 12, 10));
    const auto targets = stretched(*piece, 1.05, [](const auto& p) { return p.y() == 0; });
    for (const Method method : lengthKeepers()) {
        const auto flat = flatten(*piece, targetsBy(method), Progress(), targets);
        ASSERT_TRUE(flat) << sentence(flat.error());
        EXPECT_LE(worstOf(*piece, flat->Q, targets), kExact) << name(method);
        for (const Error& note : flat->notes) {
            ADD_FAILURE() << name(method) << ": " << sentence(note);
        }
    }
}

TEST(TargetLengths, OfCurvedClothAreKeptToo) {
    // The deep cap's descent begins with a coarse one, which has to know them as well.
    const Pieces pieces{test::asPiece(test::bentPanel(24)),
                        test::asPiece(test::sphericalCap(24, 100, 2.2)),
                        test::asPiece(test::saddle(20, 100, 1.2))};
    for (const auto& piece : pieces) {
        const auto targets = stretched(*piece, 0.93, [](const auto& p) { return p.x() > 30; });
        for (const Method method : lengthKeepers()) {
            const auto flat = flatten(*piece, targetsBy(method), Progress(), targets);
            ASSERT_TRUE(flat) << sentence(flat.error());
            EXPECT_LE(worstOf(*piece, flat->Q, targets), kExact) << name(method);
            if (method == Method::Isometric) {
                EXPECT_EQ(test::turnedTriangles(flat->Q, piece->mesh.F), 0);
            }
        }
    }
}

TEST(TargetLengths, AllScaledScaleAFlatDisk) {
    // A polygon on a circle: its area, and with it the energy, is stationary among its lengths.
    const auto piece = flatDisk();
    for (const double scale : {0.96, 1.04}) {
        const OutlineTargets targets{scale * lengthsIn3d(*piece)};
        for (const Method method : {Method::Isometric, Method::Curvature, Method::Wang2005}) {
            const auto flat = flatten(*piece, targetsBy(method), Progress(), targets);
            const auto plain = flatten(*piece, targetsBy(method), Progress());
            ASSERT_TRUE(flat && plain);
            EXPECT_LE(test::distanceAfterRigidMotion(flat->Q, scale * plain->Q), 1e-6)
                << name(method) << ' ' << scale;
        }
    }
}

TEST(TargetLengths, TwoSidesOfASeamBecomeEquallyLong) {
    // A panel in two parts; of the seam each part gets the lengths half way to the other's.
    const MeshArrays panel = test::bentPanel(20);
    const auto left = test::asPiece(test::part(panel, [](const auto& p) { return p.x() < 300; }));
    MeshArrays wider = test::part(panel, [](const auto& p) { return p.x() > 300; });
    wider.V.col(1) *= 1.04;
    const auto right = test::asPiece(wider);
    const auto onSeam = [](const Eigen::RowVector3d& p) { return std::abs(p.x() - 300) < 1e-6; };
    const auto leftTargets = stretched(*left, 1.02, onSeam);
    const auto rightTargets = stretched(*right, 1.02 / 1.04, onSeam);
    const auto options = targetsBy(Method::Isometric);
    const auto a = flatten(*left, options, Progress(), leftTargets);
    const auto b = flatten(*right, options, Progress(), rightTargets);
    ASSERT_TRUE(a && b);
    EXPECT_LE(worstOf(*left, a->Q, leftTargets), kExact);
    EXPECT_LE(worstOf(*right, b->Q, rightTargets), kExact);
}

TEST(TargetLengths, LeaveFreeOutlinesAsTheyAre) {
    const auto piece = test::asPiece(test::bentPanel(10));
    const OutlineTargets targets{1.1 * lengthsIn3d(*piece)};
    for (const Method method : {Method::Natural, Method::Lscm, Method::Abf}) {
        const auto plain = flatten(*piece, targetsBy(method), Progress());
        const auto flat = flatten(*piece, targetsBy(method), Progress(), targets);
        ASSERT_TRUE(plain && flat);
        EXPECT_EQ(plain->Q, flat->Q) << name(method);
    }
}

TEST(TargetLengths, RimsKeepTheirsBesides) {
    const auto piece =
        test::asPiece(test::part(test::bentPanel(30), [](const Eigen::RowVector3d& p) {
            return (p.head<2>() - Eigen::RowVector2d(300, 300)).norm() > 90;
        }));
    ASSERT_EQ(piece->holes.size(), 1U);
    const auto targets = stretched(*piece, 1.03, [](const auto& p) { return p.y() < 1; });
    const auto flat = flatten(*piece, targetsBy(Method::Isometric), Progress(), targets);
    ASSERT_TRUE(flat);
    EXPECT_LE(worstOf(*piece, flat->Q, targets), kExact);
    const auto& rim = piece->holes[0];
    EXPECT_LE(maxRelativeLengthError(boundaryLengths3d(piece->mesh.V, rim),
                                     boundaryLengths2d(flat->Q, rim)),
              kExact);
}

TEST(TargetLengths, AWarmStartFollowsThemAndBack) {
    const auto piece = test::originalPiece(test::bentPanel(24));
    const auto targets = stretched(*piece, 1.03, [](const auto& p) { return p.y() < 1; });
    const auto options = targetsBy(Method::Isometric);
    PieceFlattener flattener;
    ASSERT_TRUE(flattener.flatten(piece, options, Progress()));
    const OutlineTargets none{lengthsIn3d(*piece)};
    for (const OutlineTargets& wanted : {targets, none, targets, OutlineTargets{}}) {
        const auto warm = flattener.flatten(piece, options, Progress(), wanted);
        const auto cold = flatten(*piece, options, Progress(), wanted);
        ASSERT_TRUE(warm && cold);
        EXPECT_TRUE(warm->warm);
        EXPECT_LE(worstOf(*piece, warm->Q, wanted.lengths.size() > 0 ? wanted : none), kExact);
        EXPECT_NEAR(strainOf(*piece, warm->Q), strainOf(*piece, cold->Q),
                    0.01 * strainOf(*piece, cold->Q));
        EXPECT_LE(test::distanceAfterRigidMotion(warm->Q, cold->Q), 1);
    }
}

TEST(TargetLengths, AreKeptOnLargePiecesToo) {
    const auto piece = test::asPiece(test::bentPanel(30));
    const auto targets = stretched(*piece, 0.97, [](const auto& p) { return p.y() < 1; });
    const auto start = flatten(*piece, targetsBy(Method::Curvature), Progress(), targets);
    ASSERT_TRUE(start);
    const EdgeLoops loops = EdgeLoops(piece->boundary).withLengths(targets.lengths);
    isometric::DescentOptions options;
    const auto direct = isometric::lowerIsometricEnergy(piece->mesh, piece->table, loops, start->Q,
                                                        options, Progress());
    options.sizes.large = options.sizes.huge = 1;
    const auto lean = isometric::lowerIsometricEnergy(piece->mesh, piece->table, loops, start->Q,
                                                      options, Progress());
    ASSERT_TRUE(direct && lean);
    EXPECT_LE(worstOf(*piece, lean->Q, targets), kExact);
    EXPECT_NEAR(lean->distortion, direct->distortion, 0.002 * (direct->distortion - 1));
}

TEST(TargetLengths, ThatAreNoneAreRefused) {
    const auto piece = test::asPiece(test::planeGrid(4, 4, 10));
    for (const double bad : {0.0, -1.0, std::numeric_limits<double>::quiet_NaN(),
                             std::numeric_limits<double>::infinity()}) {
        OutlineTargets targets{lengthsIn3d(*piece)};
        targets.lengths[3] = bad;
        const auto flat = flatten(*piece, targetsBy(Method::Isometric), Progress(), targets);
        ASSERT_FALSE(flat);
        EXPECT_EQ(flat.error().code, ErrorCode::NotFinite);
    }
    OutlineTargets longer{lengthsIn3d(*piece)};
    longer.lengths[3] = longer.lengths.sum();
    for (const Method method : lengthKeepers()) {
        const auto flat = flatten(*piece, targetsBy(method), Progress(), longer);
        ASSERT_FALSE(flat);
        EXPECT_EQ(flat.error().code, ErrorCode::NoClosedOutline) << name(method);
    }
}

}  // namespace
}  // namespace toile
