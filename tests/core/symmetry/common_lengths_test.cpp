// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "core/symmetry/mirror_segments.h"
#include "core/symmetry/mirrored_pair.h"
#include "tests/core/support/shared_data.h"
#include "tests/core/symmetry/mirror_shapes.h"

namespace toile {
namespace {

using Indices = std::vector<int>;

CommonLengths commonOf(const Garment& garment) {
    const auto plane = findMirrorPlane(garment.pieces);
    EXPECT_TRUE(plane);
    if (!plane) {
        return {};
    }
    const Indices counterpart = pairPieces(garment, *plane).counterpart;
    const MirrorSegments segments = seamSegments(garment);
    return commonLengths(garment, segments, counterpart,
                         pairSegments(segments, counterpart, *plane));
}

/// The length of a seam's side with the seam's factor.
double scaled(const Garment& garment, const CommonLengths& common, int seam, int side) {
    const auto s = static_cast<std::size_t>(seam);
    return common.factor[s] * garment.seams.seams[s].length3d[side];
}

void expectEqualBothSides(const Garment& garment, const CommonLengths& common) {
    for (int s = 0; s < static_cast<int>(common.mirrored.size()); ++s) {
        const int other = common.mirrored[static_cast<std::size_t>(s)];
        if (other < 0) {
            continue;
        }
        EXPECT_EQ(common.mirrored[static_cast<std::size_t>(other)], s);
        const double length = scaled(garment, common, s, 0);
        EXPECT_NEAR(scaled(garment, common, other, 0), length, 1e-12 * length);
    }
}

TEST(CommonLengths, MakeMirroredSeamsEqual) {
    const Garment garment = test::tube4(test::draped);
    const CommonLengths common = commonOf(garment);
    ASSERT_EQ(common.factor.size(), garment.seams.seams.size());
    EXPECT_TRUE(common.withoutCounterpart().empty());
    expectEqualBothSides(garment, common);
    const auto change = [](double factor) { return std::abs(factor - 1); };
    EXPECT_GT(std::ranges::max(common.factor, {}, change), 1 + 1e-6);
    EXPECT_LT(change(std::ranges::max(common.factor, {}, change)), 0.05);
}

TEST(CommonLengths, ChangeNothingWhereAllIsSymmetric) {
    for (const double factor : commonOf(test::tube4()).factor) {
        EXPECT_NEAR(factor, 1, 1e-12);
    }
}

TEST(CommonLengths, DoNotDependOnTheOrderOfPieces) {
    const Garment garment = test::tube4(test::draped);
    const auto sorted = [](std::vector<double> values) {
        std::ranges::sort(values);
        return values;
    };
    const auto factors = sorted(commonOf(garment).factor);
    const auto others = sorted(commonOf(test::inOppositeOrder(garment)).factor);
    ASSERT_EQ(factors.size(), others.size());
    for (std::size_t i = 0; i < factors.size(); ++i) {
        EXPECT_NEAR(factors[i], others[i], 1e-12);
    }
}

/// Two free edges, and seams 2 and 3, which mirror each other.
Garment fourSeams() {
    Garment garment;
    garment.seams.seams.resize(4);
    const double lengths[][2] = {{50, 0}, {50, 0}, {102, 98}, {205, 215}};
    for (std::size_t s = 0; s < 4; ++s) {
        Seam& seam = garment.seams.seams[s];
        std::copy_n(lengths[s], 2, seam.length3d);
        seam.left.piece = 0;
        seam.right.piece = s < 2 ? -1 : 1;
    }
    return garment;
}

MirrorSegment sideOf(int seam, bool isRight) {
    MirrorSegment segment;
    segment.seam = seam;
    segment.isRight = isRight;
    return segment;
}

TEST(CommonLengths, KeepEaseAsARatio) {
    const Garment garment = fourSeams();
    const MirrorSegments segments{
        {sideOf(0, false), sideOf(1, false), sideOf(2, false), sideOf(3, false)},
        {sideOf(2, true), sideOf(3, true)}};
    const CommonLengths common = commonLengths(garment, segments, {0, 1}, {{0, -1, 3, 2}, {1, 0}});
    EXPECT_EQ(common.mirrored, (Indices{0, -1, 3, 2}));
    EXPECT_EQ(common.withoutCounterpart(), (Indices{1}));
    EXPECT_EQ(common.factor[0], 1);
    EXPECT_EQ(common.factor[1], 1);
    EXPECT_NEAR(common.factor[2], 155.0 / 100, 1e-15);
    EXPECT_NEAR(common.factor[3], 155.0 / 210, 1e-15);
}

TEST(CommonLengths, LeaveSeamsWhoseSidesDisagree) {
    const MirrorSegments segments{{sideOf(2, false), sideOf(3, false)},
                                  {sideOf(2, true), sideOf(3, true)}};
    const CommonLengths common = commonLengths(fourSeams(), segments, {0, 1}, {{1, 0}, {0, 1}});
    EXPECT_EQ(common.withoutCounterpart(), (Indices{0, 1, 2, 3}));
    EXPECT_EQ(common.factor, std::vector<double>(4, 1));
}

TEST(CommonLengths, TellWhichPiecesDifferTooMuch) {
    const Garment garment = fourSeams();
    const MirrorSegments segments{{sideOf(0, false), sideOf(2, false)},
                                  {sideOf(1, false), sideOf(3, false)}};
    const SegmentPairs pairs{{0, 1}, {0, 1}};
    const CommonLengths common = commonLengths(garment, segments, {1, 0}, pairs);
    const auto unequal = unequalPieces(garment, segments, {1, 0}, common);
    ASSERT_EQ(unequal.size(), 1U);
    EXPECT_EQ(unequal[0].piece, 1);  // of the longer seam
    EXPECT_EQ(unequal[0].counterpart, 0);
    EXPECT_EQ(unequal[0].seam, 3);
    EXPECT_EQ(unequal[0].mirrored, 2);
    EXPECT_NEAR(unequal[0].difference, 110, 1e-12);
    EXPECT_NEAR(unequal[0].tolerance, 2.1, 1e-12);
    EXPECT_EQ(mirrorTolerance(100, 150), 2);
    EXPECT_EQ(mirrorTolerance(300, 250), 3);
}

struct Changes {
    const char* file;
    std::size_t without;
    double mostMm;  ///< the largest change of a length
};

class CommonLengthsOf : public testing::TestWithParam<Changes> {};

TEST_P(CommonLengthsOf, ChangeLengthsAsMeasured) {
    TOILE_NEEDS_SHARED(test::dataFile(GetParam().file));
    const Garment garment = test::garmentOf(GetParam().file);
    const CommonLengths common = commonOf(garment);
    expectEqualBothSides(garment, common);
    double most = 0;
    for (std::size_t s = 0; s < common.factor.size(); ++s) {
        const double change = (common.factor[s] - 1) * garment.seams.seams[s].length3d[0];
        most = std::max(most, std::abs(change));
    }
    EXPECT_NEAR(most, GetParam().mostMm, 0.01 + 1e-9);
    EXPECT_EQ(common.withoutCounterpart().size(), GetParam().without);
}

INSTANTIATE_TEST_SUITE_P(Garments, CommonLengthsOf,
                         testing::Values(Changes{"samples/tshirt.obj", 0, 0},
                                         Changes{"samples/bodice.obj", 0, 0},
                                         Changes{"garments/tee_sim.obj", 0, 0.71},
                                         Changes{"garments/dress.obj", 10, 1.03}));

}  // namespace
}  // namespace toile
