// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/symmetry/mirror_segments.h"

#include <numeric>

#include <gtest/gtest.h>

#include "core/quality/measures.h"
#include "core/symmetry/mirrored_pair.h"
#include "tests/core/support/shared_data.h"
#include "tests/core/symmetry/mirror_shapes.h"

namespace toile {
namespace {

using Indices = std::vector<int>;

const MirrorPlane kMirror{{1, 0, 0}, 0};

MirrorSegment segment(int neighbour, double length, double x, double y) {
    MirrorSegment one;
    one.neighbour = neighbour;
    one.length = length;
    one.middle = {x, y, 0};
    return one;
}

/// Pieces 0 and 1 mirror each other, and 2 and 3.
const Indices kTwoPairs{1, 0, 3, 2};

TEST(MirrorSegments, RunInOppositeSenses) {
    const MirrorSegments segments{
        {segment(2, 10, 5, 0), segment(3, 20, 9, 5), segment(-1, 30, 5, 9)},
        {segment(2, 20, -9, 5), segment(3, 10, -5, 0), segment(-1, 30, -5, 9)},
        {},
        {}};
    const SegmentPairs pairs = pairSegments(segments, kTwoPairs, kMirror);
    EXPECT_EQ(pairs[0], (Indices{1, 0, 2}));
    EXPECT_EQ(pairs[1], (Indices{1, 0, 2}));
    EXPECT_TRUE(unpairedSegments(pairs).empty());
}

TEST(MirrorSegments, OfOneNeighbourArePairedByTheirPlaces) {
    // All rotations agree: only the middles tell.
    const MirrorSegments segments{{segment(-1, 10, 5, 0), segment(-1, 10, 9, 5),
                                   segment(-1, 10, 5, 9), segment(-1, 10, 1, 5)},
                                  {segment(-1, 10, -5, 9), segment(-1, 10, -9, 5),
                                   segment(-1, 10, -5, 0), segment(-1, 10, -1, 5)},
                                  {},
                                  {}};
    EXPECT_EQ(pairSegments(segments, kTwoPairs, kMirror)[0], (Indices{2, 1, 0, 3}));
}

TEST(MirrorSegments, AcrossTheMirrorLineArePairedWithThemselves) {
    const MirrorSegments segments{{segment(-1, 40, 0, 0), segment(1, 20, 9, 5), segment(0, 8, 5, 9),
                                   segment(0, 8, -5, 9), segment(2, 20, -9, 5)},
                                  {},
                                  {}};
    EXPECT_EQ(pairSegments(segments, {0, 2, 1}, kMirror)[0], (Indices{0, 4, 3, 2, 1}));
}

TEST(MirrorSegments, InAnotherOrderOnlyWhoAreAlone) {
    // The neighbours 4 and -1 have changed places, and 2 is there twice.
    const Indices counterpart{1, 0, 3, 2, 4};
    const MirrorSegments segments{
        {segment(2, 10, 5, 0), segment(4, 20, 9, 5), segment(-1, 30, 5, 9), segment(2, 10, 1, 5)},
        {segment(3, 10, -1, 5), segment(4, 20.5, -5, 9), segment(-1, 50, -9, 5),
         segment(3, 10, -5, 0)},
        {},
        {},
        {}};
    const SegmentPairs pairs = pairSegments(segments, counterpart, kMirror);
    EXPECT_EQ(pairs[0], (Indices{-1, 1, -1, -1}));
    EXPECT_EQ(pairs[1], (Indices{-1, 1, -1, -1}));
    const std::vector<SegmentPlace> unpaired = unpairedSegments(pairs);
    ASSERT_EQ(unpaired.size(), 6U);
    EXPECT_EQ(unpaired[1], (SegmentPlace{0, 2}));
}

TEST(MirrorSegments, OfTooDifferentLengthsStayAlone) {
    const MirrorSegments segments{{segment(2, 10, 5, 0), segment(-1, 30, 5, 9)},
                                  {segment(-1, 30, -5, 9), segment(3, 14, -5, 0)},
                                  {},
                                  {}};
    EXPECT_EQ(pairSegments(segments, kTwoPairs, kMirror)[0], (Indices{-1, 0}));
}

TEST(MirrorSegments, OfAPieceWithoutCounterpartStayAlone) {
    const MirrorSegments segments{{segment(-1, 10, 5, 0)}};
    EXPECT_EQ(pairSegments(segments, {-1}, kMirror)[0], (Indices{-1}));
}

TEST(SeamSegments, GoRoundEachOutlineOnce) {
    const Garment garment = test::tube4(test::draped);
    const MirrorSegments segments = seamSegments(garment);
    ASSERT_EQ(segments.size(), garment.pieces.size());
    for (std::size_t p = 0; p < segments.size(); ++p) {
        const Piece& piece = *garment.pieces[p];
        double sum = 0;
        Indices neighbours;
        for (const MirrorSegment& one : segments[p]) {
            sum += one.length;
            neighbours.push_back(one.neighbour);
            const Seam& seam = garment.seams.seams[static_cast<std::size_t>(one.seam)];
            EXPECT_EQ((one.isRight ? seam.right : seam.left).piece, static_cast<int>(p));
        }
        EXPECT_NEAR(sum, boundaryLengths3d(piece.mesh.V, piece.boundary).sum(), 1e-9);
        ASSERT_EQ(neighbours.size(), 4U);  // free above and below, sewn at the sides
        EXPECT_EQ(neighbours[0] == -1, neighbours[2] == -1);
        EXPECT_NE(neighbours[1] == -1, neighbours[2] == -1);
    }
}

struct Unpaired {
    const char* file;
    std::size_t unpaired, all;
};

class MirrorSegmentsOf : public testing::TestWithParam<Unpaired> {};

TEST_P(MirrorSegmentsOf, AreMutualAndPairedWhereTheOrderAgrees) {
    TOILE_NEEDS_SHARED(test::dataFile(GetParam().file));
    const Garment garment = test::garmentOf(GetParam().file);
    const auto plane = findMirrorPlane(garment.pieces);
    ASSERT_TRUE(plane);
    const Indices counterpart = pairPieces(garment, *plane).counterpart;
    const MirrorSegments segments = seamSegments(garment);
    const SegmentPairs pairs = pairSegments(segments, counterpart, *plane);
    std::size_t all = 0;
    for (std::size_t p = 0; p < pairs.size(); ++p) {
        all += pairs[p].size();
        for (std::size_t i = 0; i < pairs[p].size(); ++i) {
            if (pairs[p][i] >= 0) {
                const auto there = static_cast<std::size_t>(pairs[p][i]);
                EXPECT_EQ(pairs[static_cast<std::size_t>(counterpart[p])][there],
                          static_cast<int>(i));
            }
        }
    }
    EXPECT_EQ(all, GetParam().all);
    EXPECT_EQ(unpairedSegments(pairs).size(), GetParam().unpaired);
}

INSTANTIATE_TEST_SUITE_P(Garments, MirrorSegmentsOf,
                         testing::Values(Unpaired{"samples/tshirt.obj", 0, 33},
                                         Unpaired{"samples/bodice.obj", 0, 36},
                                         Unpaired{"samples/trousers.obj", 0, 27},
                                         Unpaired{"garments/tee_sim.obj", 0, 32},
                                         // straps that end on different pieces
                                         Unpaired{"garments/dress.obj", 14, 66},
                                         // the placket, and the collar at it
                                         Unpaired{"garments/polo.obj", 4, 42}));

}  // namespace
}  // namespace toile
