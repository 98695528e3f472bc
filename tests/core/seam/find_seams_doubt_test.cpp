// SPDX-License-Identifier: GPL-3.0-or-later
// Where finding seams could go wrong: gaps, layers, strips, turned pieces, scale and numbering.
#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "core/seam/find_seams.h"
#include "tests/core/seam/seam_shapes.h"
#include "tests/core/support/growth.h"
#include "tests/core/support/shapes.h"

namespace toile {
namespace {

using test::asPiece;
using test::named;
using test::only;
using test::rectangle;

TEST(SeamsInDoubt, APieceWoundTheOtherWayIsSewnAlong) {
    const Pieces apart{asPiece(rectangle(0, 0, 50, 100, 5, 10), "front"),
                       asPiece(test::woundAgainst(rectangle(50, 0, 70, 100, 7, 10)), "back")};
    for (const Pieces& pieces : {apart, test::welded(apart)}) {
        const SeamGraph graph = findSeams(pieces);
        test::expectValid(graph, pieces);
        const Seam seam = named(graph, "front / back");
        EXPECT_FALSE(seam.right.reversed);
        EXPECT_NEAR(seam.length3d[1], 100, 1e-9);
        EXPECT_EQ(graph.seams.size(), 3U);
    }
}

TEST(SeamsInDoubt, GapsUpToTheToleranceAreClosed) {
    const auto seamsAt = [](double gap, const SeamOptions& options) {
        return only(findSeams({asPiece(rectangle(0, 0, 400, 600, 40, 60), "front"),
                               asPiece(rectangle(400 + gap, 0, 400, 600, 37, 55), "back")},
                              options),
                    SeamKind::Seam)
            .size();
    };
    EXPECT_EQ(seamsAt(1, {}), 1U);
    EXPECT_EQ(seamsAt(2, {}), 1U);
    EXPECT_EQ(seamsAt(3, {}), 0U);
    EXPECT_EQ(seamsAt(3, {.gap = 0.4}), 1U);
    EXPECT_EQ(seamsAt(1, {.gap = 0.05}), 0U);
}

TEST(SeamsInDoubt, WhatNearnessSewsIsReported) {
    const auto notesAt = [](double gap) {
        return findSeams({asPiece(rectangle(0, 0, 400, 600, 40, 60), "front"),
                          asPiece(rectangle(400 + gap, 0, 400, 600, 40, 60), "back")})
            .notes;
    };
    EXPECT_TRUE(notesAt(0).empty());
    const Problems notes = notesAt(1.25);
    ASSERT_EQ(notes.size(), 1U);
    EXPECT_EQ(notes[0].code, ErrorCode::SeamsByNearness);
    EXPECT_NE(sentence(notes[0]).find("1 seam, at most 1.25 mm apart"), std::string::npos)
        << sentence(notes[0]);
    EXPECT_TRUE(notesAt(3).empty());  // not sewn
}

TEST(SeamsInDoubt, ParallelEdgesOfAPlacketGoToTheBetterPartner) {
    // The upper band meets the front; the band below begins 3 mm further in.
    const Pieces pieces{asPiece(rectangle(0, 0, 400, 600, 20, 30), "front"),
                        asPiece(rectangle(400, 0, 60, 600, 3, 28), "upper band"),
                        asPiece(rectangle(403, 0, 60, 600, 3, 30), "lower band")};
    const SeamGraph graph = findSeams(pieces);
    test::expectValid(graph, pieces);
    EXPECT_NEAR(named(graph, "front / upper band").length3d[0], 600, 1e-9);
    EXPECT_EQ(only(graph, SeamKind::Seam).size(), 1U);
}

/// Front and back of a skirt that lies flat: two sheets 480 wide and 500 high that meet at their
/// sides and bulge by so much.
Pieces lens(double depth) {
    Pieces pieces;
    for (const double side : {1.0, -1.0}) {
        MeshArrays mesh = rectangle(0, 0, 480, 500, 40, 40);
        for (Eigen::Index v = 0; v < mesh.V.rows(); ++v) {
            const double x = mesh.V(v, 0) / 240 - 1;
            mesh.V(v, 2) = side * depth / 2 * (1 - x * x);
        }
        pieces.push_back(
            asPiece(side > 0 ? mesh : test::woundAgainst(mesh), side > 0 ? "front" : "back"));
    }
    return pieces;
}

TEST(SeamsInDoubt, HemsThatLieOnEachOtherStayOpen) {
    for (const double depth : {0.1, 1.0, 5.0, 20.0, 60.0, 200.0}) {
        const Pieces apart = lens(depth);
        for (const Pieces& pieces : {apart, test::welded(apart)}) {
            const SeamGraph graph = findSeams(pieces);
            test::expectValid(graph, pieces);
            const std::vector<Seam> seams = only(graph, SeamKind::Seam);
            EXPECT_EQ(seams.size(), 2U) << depth;
            for (const Seam& seam : seams) {
                EXPECT_NEAR(seam.length3d[0], 500, 1e-6) << depth;
                EXPECT_NEAR(seam.length3d[1], 500, 1e-6) << depth;
            }
            EXPECT_EQ(only(graph, SeamKind::Free).size(), 4U) << depth;
        }
    }
}

TEST(SeamsInDoubt, BandsThatLieOnEachOtherAreNotSewnWhereAllIsWelded) {
    // Two bands that are welded to the front, one over the other, 1 mm apart at their far ends.
    const auto band = [](double off) {
        MeshArrays mesh = rectangle(100, 0, 40, 100, 4, 10);
        mesh.V.col(2) = (mesh.V.col(0).array() - 100) / 40 * off;
        return mesh;
    };
    const Pieces pieces =
        test::welded({asPiece(rectangle(0, 0, 100, 100, 10, 10), "front"),
                      asPiece(band(1), "upper band"), asPiece(band(-1), "lower band")});
    for (const Seam& seam : only(findSeams(pieces), SeamKind::Seam)) {
        EXPECT_TRUE(seam.name.starts_with("front / ")) << seam.name;
        EXPECT_NEAR(seam.length3d[0], 100, 1e-6) << seam.name;
    }
}

TEST(SeamsInDoubt, AThirdLayerIsASeamOfItsOwn) {
    // The upper band is longer than the front and goes on along the facing; the lower one lies
    // beneath it, on the front's edge only.
    const Pieces apart{asPiece(rectangle(0, 0, 100, 100, 10, 10), "front"),
                       asPiece(rectangle(0, 100, 100, 60, 10, 6), "facing"),
                       asPiece(rectangle(100, 0, 40, 160, 4, 16), "upper band"),
                       asPiece(rectangle(100, 10, 30, 90, 3, 9), "lower band")};
    for (const Pieces& pieces : {apart, test::welded(apart)}) {
        const SeamGraph graph = findSeams(pieces);
        EXPECT_FALSE(named(graph, "front / facing").stacked);
        EXPECT_FALSE(named(graph, "facing / upper band").stacked);
        const std::vector<Seam> seams = only(graph, SeamKind::Seam);
        EXPECT_EQ(seams.size(), 4U);
        int stacked = 0;
        for (const Seam& seam : seams) {
            EXPECT_TRUE(seam.name != "upper band / lower band");
            stacked += seam.stacked ? 1 : 0;
        }
        EXPECT_EQ(stacked, 1);
        EXPECT_NEAR(named(graph, "front / lower band").length3d[0], 90, 1e-9);
        EXPECT_NEAR(named(graph, "front / upper band").length3d[0], 100, 1e-9);
    }
}

TEST(SeamsInDoubt, TheSidesOfAStripAreNotSewnTogether) {
    EXPECT_TRUE(
        only(findSeams({asPiece(rectangle(0, 0, 600, 1, 60, 1), "tape")}), SeamKind::Seam).empty());
    MeshArrays gore = rectangle(0, 0, 600, 1, 60, 1);  // running out into a point
    for (Eigen::Index v = 0; v < gore.V.rows(); ++v) {
        gore.V(v, 1) *= 20 * (1.01 - gore.V(v, 0) / 600);
    }
    EXPECT_EQ(findSeams({asPiece(gore, "gore")}).seams.size(), 1U);
}

TEST(SeamsInDoubt, AGatheredSideIsLonger) {
    MeshArrays skirt = rectangle(0, -300, 400, 300, 160, 30);
    for (int c = 0; c <= 160; ++c) {  // the upper edge waves out of the plane
        skirt.V(30 * 161 + c, 2) = c % 4 == 1 ? 1.5 : c % 4 == 3 ? -1.5 : 0;
    }
    const Pieces pieces{asPiece(rectangle(0, 0, 400, 300, 40, 30), "bodice"),
                        asPiece(skirt, "skirt")};
    const SeamGraph graph = findSeams(pieces);
    test::expectValid(graph, pieces);
    const Seam seam = named(graph, "bodice / skirt");
    EXPECT_NEAR(seam.length3d[0], 400, 1e-9);
    EXPECT_NEAR(seam.length3d[1], 160 * std::hypot(2.5, 1.5), 1e-9);
    EXPECT_EQ(only(graph, SeamKind::Seam).size(), 1U);
}

Pieces smallGarment(double scale, double shift, unsigned seed) {
    std::vector<std::pair<MeshArrays, std::string>> parts{
        {test::withSlit(rectangle(0, 0, 100, 80, 10, 8), 10, 4, 5), "skirt"},
        {rectangle(0, 80, 60, 90, 6, 9), "left"},
        {rectangle(60.2, 80.1, 40, 90, 3, 8), "right"}};
    Pieces pieces;
    for (auto& [mesh, name] : parts) {
        mesh.V *= scale;
        mesh.V.array() += shift;
        pieces.push_back(
            asPiece(seed > 0 ? test::renumber(mesh, seed++).mesh : std::move(mesh), name));
    }
    return pieces;
}

TEST(SeamsInDoubt, SizeAndPlaceDoNotMatter) {
    const auto expected = test::summary(findSeams(smallGarment(1, 0, 0)), 1, 4);
    EXPECT_EQ(expected.size(), 8U);
    EXPECT_EQ(test::summary(findSeams(smallGarment(1e-6, 0, 0)), 1e-6, 4), expected);
    EXPECT_EQ(test::summary(findSeams(smallGarment(1e6, 0, 0)), 1e6, 4), expected);
    EXPECT_EQ(test::summary(findSeams(smallGarment(1, 1e6, 0)), 1, 4), expected);
}

TEST(SeamsInDoubt, RenumberingGivesTheSameGraph) {
    const auto expected = test::summary(findSeams(smallGarment(1, 0, 0)), 1, 4);
    for (unsigned seed = 1; seed < 40; seed += 3) {
        const Pieces pieces = smallGarment(1, 0, seed);
        const SeamGraph graph = findSeams(pieces);
        test::expectValid(graph, pieces);
        EXPECT_EQ(test::summary(graph, 1, 4), expected);
    }
}

TEST(SeamsInDoubt, AnySoupOfPiecesGivesAValidGraph) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> place(0, 1);
    for (const double size : {2.0, 10.0, 60.0}) {
        Pieces pieces;
        for (int k = 0; k < 300; ++k) {
            MeshArrays mesh =
                rectangle(0, 0, size * place(random) + 0.1, size, 1 + k % 3, 1 + k % 5);
            for (Eigen::Index v = 0; v < mesh.V.rows(); ++v) {
                mesh.V.row(v) +=
                    0.02 * size * Eigen::RowVector3d(place(random), place(random), place(random));
            }
            mesh.V.rowwise() +=
                100 * Eigen::RowVector3d(place(random), place(random), 0.1 * place(random));
            pieces.push_back(asPiece(k % 7 == 0 ? test::woundAgainst(mesh) : mesh,
                                     "patch " + std::to_string(k)));
        }
        const SeamGraph graph = findSeams(pieces, {.gap = 0.5});
        ASSERT_EQ(graph.seamsOfEdge.size(), pieces.size());
        for (const Seam& seam : graph.seams) {
            EXPECT_TRUE(std::isfinite(seam.length3d[0]) && seam.length3d[0] > 0);
        }
    }
}

/// Four pieces around a point, of about `side` x `side` squares each, sampled differently.
Pieces fineMeshes(int side) {
    Pieces pieces;
    for (int k = 0; k < 4; ++k) {
        pieces.push_back(
            asPiece(rectangle(500.0 * (k % 2), 500.0 * (k / 2), 500, 500, side + k, side + 1),
                    "p" + std::to_string(k)));
    }
    return pieces;
}

TEST(SeamsInDoubt, FineMeshesAreSewnAsWell) {
    EXPECT_EQ(only(findSeams(fineMeshes(100)), SeamKind::Seam).size(), 4U);
}

TEST(SeamsInDoubtClock, FineMeshesCostWhatWalkingOverThemCosts) {
    const Pieces some = fineMeshes(176), more = fineMeshes(353);  // a million triangles
    EXPECT_LT(test::growth([&] { findSeams(some); }, [&] { findSeams(more); }), 8);
}

}  // namespace
}  // namespace toile
