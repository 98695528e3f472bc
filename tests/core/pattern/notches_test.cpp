// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/pattern/notches.h"

#include <algorithm>
#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include "core/pattern/walk.h"
#include "core/seam/seam_measure.h"
#include "core/seam/seam_settings.h"
#include "tests/core/pattern/notched_garments.h"
#include "tests/core/seam/seam_shapes.h"
#include "tests/core/support/shapes.h"
#include "tests/core/support/shared_data.h"

namespace toile {
namespace {

using test::garmentFrom;
using test::notched;
using test::Notched;
using test::plane;

std::vector<double> sharesOf(const std::vector<Notch>& notches) {
    std::vector<double> shares;
    for (const Notch& notch : notches) {
        shares.push_back(std::round(notch.share * 1e6) / 1e6);
    }
    return shares;
}

using Shares = std::vector<double>;

TEST(Notches, AreInTheMiddleAndAtTheQuartersOfLongSeams) {
    for (const auto& [length, shares] : std::initializer_list<std::pair<double, Shares>>{
             {100, {}}, {200, {0.5}}, {400, {0.25, 0.5, 0.75}}}) {
        const Notched pair = notched(plane({test::rectangle(0, 0, 120, length, 3, 20),
                                            test::rectangle(120, 0, 90, length, 3, 15)}));
        const auto all = pair.found();
        EXPECT_EQ(sharesOf(all[0]), shares) << length;
        for (const Notch& notch : all[0]) {
            EXPECT_EQ(notch.reason, NotchReason::Balance);
            EXPECT_EQ(notch.count, 1);  // flat: nobody knows where its back is
            EXPECT_TRUE(notch.onLeft && notch.onRight);
            EXPECT_NEAR(std::abs(notch.at.left - pair.garment.seams.seams[0].left.start),
                        notch.share * length, 1e-9);
        }
    }
}

// Two pieces above a longer one: where the upper seam ends the lower outline runs on.
TEST(Notches, MarkAnEndWhereTheOtherOutlineRunsOnAndOnlyThere) {
    const Notched three = notched(
        plane({test::rectangle(0, 0, 240, 90, 24, 9), test::rectangle(0, 90, 100, 130, 10, 13),
               test::rectangle(100, 90, 140, 130, 14, 13)}));
    const Seam& seam = test::named(three.garment.seams, "a / b");
    const auto all = three.found();
    int marks = 0;
    for (const auto& ofSeam : all) {
        for (const Notch& notch : ofSeam) {
            const Seam& at = three.garment.seams.seams[static_cast<std::size_t>(notch.seam)];
            const bool isEnd = notch.reason == NotchReason::SeamEnd;
            if (isEnd) {
                ++marks;
                EXPECT_EQ(at.left.piece, 0);
                EXPECT_TRUE(notch.onLeft);
                EXPECT_FALSE(notch.onRight);  // a corner marks it
                EXPECT_EQ(notch.count, 1);
                const Points3 line = spaceLine(at.left, *three.garment.pieces[0]);
                const auto end = notch.share > 0 ? line.bottomRows<1>() : line.topRows<1>();
                EXPECT_NEAR(end(0), 100, 1e-9);
            }
        }
    }
    EXPECT_EQ(marks, 1) << seam.name;  // both seams end there
}

TEST(Notches, OfSeamsThatCouldBeTakenForEachOtherDiffer) {
    // A strip with a piece on each long side: seams of one length.
    const Notched strip = notched(
        plane({test::rectangle(0, 0, 90, 400, 4, 20), test::rectangle(90, 0, 120, 400, 4, 20),
               test::rectangle(-120, 0, 120, 400, 4, 20)}));
    const auto all = strip.found();
    ASSERT_GE(all.size(), 2U);
    EXPECT_EQ(sharesOf(all[0]), (Shares{0.25, 0.5, 0.75}));
    EXPECT_EQ(sharesOf(all[1]), (Shares{0.333333, 0.666667}));
    NotchRules none;
    none.automatic = false;
    for (const auto& ofSeam : strip.found(none)) {
        EXPECT_TRUE(ofSeam.empty());
    }
}

TEST(Notches, AreAddedMovedAndTakenAwayByHandOnBothSides) {
    const Notched pair = notched(
        plane({test::rectangle(0, 0, 120, 400, 3, 20), test::rectangle(120, 0, 90, 400, 3, 16)}));
    NotchRules rules;
    rules.notches.push_back(*notchSettingsAt(pair.garment, 0, 0.4));
    EXPECT_EQ(sharesOf(pair.found(rules)[0]), (Shares{0.25, 0.4, 0.5, 0.75}));
    rules.notches.back() = *notchSettingsAt(pair.garment, 0, 0.48);  // too near to the middle one
    rules.notches.back().count = 2;
    const auto moved = pair.found(rules)[0];
    EXPECT_EQ(sharesOf(moved), (Shares{0.25, 0.48, 0.75}));
    EXPECT_EQ(moved[1].reason, NotchReason::ByHand);
    EXPECT_EQ(moved[1].count, 2);
    rules.notches.push_back(*notchSettingsAt(pair.garment, 0, 0.75));
    rules.notches.back().isThere = false;
    EXPECT_EQ(sharesOf(pair.found(rules)[0]), (Shares{0.25, 0.48}));
    // What is said of the other side's line is the same.
    const Seam& seam = pair.garment.seams.seams[0];
    const Piece& right = *pair.garment.pieces[static_cast<std::size_t>(seam.right.piece)];
    const EdgeOrigin& edge =
        *originAt(right.origins, right.boundary[static_cast<std::size_t>(seam.right.first)]);
    NotchRules other;
    other.automatic = false;
    other.notches = {{edge.line, (edge.from + edge.to) / 2, edge.from > edge.to}};
    EXPECT_EQ(pair.found(other)[0].size(), 1U);
}

TEST(Notches, OfAClosedSeamBeginAtItsStart) {
    const MeshArrays whole = test::rectangle(0, 0, 400, 400, 40, 40);
    const auto isPatch = [](const Eigen::RowVector3d& p) {
        return std::abs(p.x() - 200) < 50 && std::abs(p.y() - 200) < 50;
    };
    const Notched patched =
        notched(plane({test::part(whole, [&](const Eigen::RowVector3d& p) { return !isPatch(p); }),
                       test::part(whole, isPatch)}));
    const auto all = patched.found();
    const auto seam = std::ranges::find(patched.garment.seams.seams, true, &Seam::closed);
    ASSERT_NE(seam, patched.garment.seams.seams.end());
    const auto index = static_cast<std::size_t>(seam - patched.garment.seams.seams.begin());
    EXPECT_EQ(sharesOf(all[index]), (Shares{0, 0.25, 0.5, 0.75}));
    for (const SeamWalk& walk :
         walkSeams(patched.garment, patched.results, patched.segments, all)) {
        EXPECT_LE(walk.largestError(), kWalkTolerance);
    }
}

class NotchesOf : public testing::TestWithParam<const char*> {};

double apart(double a, double b, double perimeter) {
    return std::abs(std::remainder(a - b, perimeter));
}

TEST_P(NotchesOf, AreNowhereCrowded) {
    TOILE_NEEDS_SHARED(test::dataFile(GetParam()));
    const Notched all = notched(garmentFrom(GetParam()));
    std::vector<std::vector<double>> ofPiece(all.garment.pieces.size());
    int doubles = 0, singles = 0;
    for (const auto& ofSeam : all.found()) {
        double last = -1;
        for (const Notch& notch : ofSeam) {
            const Seam& seam = all.garment.seams.seams[static_cast<std::size_t>(notch.seam)];
            EXPECT_GT(notch.share, last);
            last = notch.share;
            (notch.count == 2 ? doubles : singles) += 1;
            if (notch.onLeft && seam.left.loop == 0) {
                ofPiece[static_cast<std::size_t>(seam.left.piece)].push_back(notch.at.left);
            }
            if (notch.onRight && seam.right.loop == 0) {
                ofPiece[static_cast<std::size_t>(seam.right.piece)].push_back(notch.at.right);
            }
        }
    }
    EXPECT_GT(singles, 0);
    for (std::size_t p = 0; p < ofPiece.size(); ++p) {
        const double perimeter = loopLengths(*all.garment.pieces[p])[0];
        for (std::size_t i = 0; i < ofPiece[p].size(); ++i) {
            for (std::size_t k = i + 1; k < ofPiece[p].size(); ++k) {
                EXPECT_GE(apart(ofPiece[p][i], ofPiece[p][k], perimeter), kNotchGap - 1e-6);
            }
        }
    }
}

TEST_P(NotchesOf, AreEquallyFarApartOnBothSidesHoweverLinesAreDrawn) {
    TOILE_NEEDS_SHARED(test::dataFile(GetParam()));
    const Garment garment = garmentFrom(GetParam());
    std::vector<SeamSettings> eased;
    for (const Seam& seam : garment.seams.seams) {
        if (seam.kind == SeamKind::Seam && !seam.stacked && seam.length3d[0] > 150) {
            const bool isEven = eased.size() % 2 == 0;
            eased = withEase(eased, seam, isEven ? 0.04 : -0.03,
                             isEven ? SeamPart{0.31, 0.62} : SeamPart{});
        }
    }
    const Garment drawn = *easedGarment(garment, eased);
    LineSettings fair;
    fair.fairing = Fairing{};
    LineSettings mirrored;
    mirrored.mirror = Mirror::Mean;
    for (const Garment* one : {&garment, &drawn}) {
        for (const LineSettings& lines : {LineSettings{}, fair, mirrored}) {
            const Notched made = notched(*one, lines);
            const auto notches = made.found();
            for (const SeamWalk& walk :
                 walkSeams(made.garment, made.results, made.segments, notches)) {
                EXPECT_LE(walk.largestError(), kWalkTolerance)
                    << made.garment.seams.seams[static_cast<std::size_t>(walk.seam)].name;
                EXPECT_GE(walk.stations.size(), 2U);
            }
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Garments, NotchesOf,
                         testing::Values("samples/tshirt.obj", "samples/bodice.obj"));
INSTANTIATE_TEST_SUITE_P(Slow, NotchesOf,
                         testing::Values("samples/trousers.obj", "samples/cap.obj",
                                         "samples/skirt.obj", "garments/tee_sim.obj",
                                         "garments/dress.obj", "garments/polo.obj",
                                         "garments/skirt_clo.obj"));

TEST(Notches, OfTheTshirtMarkItsSleeveHeadsAndItsBack) {
    const Notched shirt = notched(garmentFrom("samples/tshirt.obj"));
    const auto all = shirt.found();
    int heads = 0;
    for (const auto& ofSeam : all) {
        for (const Notch& notch : ofSeam) {
            const Seam& seam = shirt.garment.seams.seams[static_cast<std::size_t>(notch.seam)];
            heads += notch.reason == NotchReason::SleeveHead ? 1 : 0;
            if (notch.reason == NotchReason::SleeveHead) {
                EXPECT_EQ(seam.name.find("neckband"), std::string::npos);
            }
        }
    }
    EXPECT_EQ(heads, 2);
    for (const Notch& notch : all[static_cast<std::size_t>(shirt.indexOf("back / sleeve_left"))]) {
        EXPECT_EQ(notch.count, notch.reason == NotchReason::Balance ? 2 : 1);
    }
    for (const Notch& notch : all[static_cast<std::size_t>(shirt.indexOf("front / sleeve_left"))]) {
        EXPECT_EQ(notch.count, 1);
    }
}

TEST(Notches, OfMirroredSeamsAreMirrorImages) {
    LineSettings lines;
    lines.mirror = Mirror::Mean;
    const Notched shirt = notched(garmentFrom("samples/tshirt.obj"), lines);
    ASSERT_TRUE(shirt.symmetry);
    const auto left = static_cast<std::size_t>(shirt.indexOf("front / sleeve_left"));
    const auto right = static_cast<std::size_t>(shirt.indexOf("front / sleeve_right"));
    NotchRules rules;
    rules.notches = {*notchSettingsAt(shirt.garment, static_cast<int>(right), 0.2)};
    for (const bool byHand : {false, true}) {
        const auto all = shirt.found(byHand ? rules : NotchRules{});
        Shares turned = sharesOf(all[right]);
        for (double& share : turned) {
            share = 1 - share;
        }
        std::ranges::sort(turned);
        const Shares own = sharesOf(all[left]);
        ASSERT_EQ(own.size(), turned.size());
        ASSERT_EQ(own.size(), byHand ? 3U : 2U);
        for (std::size_t k = 0; k < own.size(); ++k) {
            EXPECT_NEAR(own[k], turned[k], 2e-6);
        }
        // A seam across the plane is its own image.
        const auto across = static_cast<std::size_t>(shirt.indexOf("front / neckband"));
        const Shares band = sharesOf(all[across]);
        for (std::size_t k = 0; k < band.size(); ++k) {
            EXPECT_NEAR(band[k], 1 - band[band.size() - 1 - k], 2e-6);
        }
    }
}

TEST(Walk, SharesStatedEaseOutEvenlyAndFindsWhatIsNotDrawn) {
    Garment garment =
        plane({test::rectangle(0, 0, 120, 400, 3, 20), test::rectangle(120, 0, 90, 400, 3, 16)});
    garment.seams.seams[0].ease = 0.1;
    const Notched pair = notched(garment);
    const auto walks = walkSeams(pair.garment, pair.results, pair.segments, pair.found());
    ASSERT_EQ(walks.size(), 1U);
    ASSERT_EQ(walks[0].stations.size(), 5U);
    EXPECT_EQ(walks[0].stations[0].left, 0);
    for (std::size_t k = 1; k < 5; ++k) {
        const WalkStation& station = walks[0].stations[k];
        EXPECT_NEAR(station.left, 100, 1e-6);
        EXPECT_NEAR(station.right, 100, 1e-6);
        EXPECT_NEAR(station.ease, 10, 1e-6);
        EXPECT_NEAR(station.error(), -10, 1e-6);
    }
    EXPECT_NEAR(walks[0].stations.front().kink.value_or(1), 0, 1e-6);
    EXPECT_NEAR(walks[0].stations.back().kink.value_or(1), 0, 1e-6);
}

TEST(Walk, AddsUpToTheLedger) {
    const Notched shirt = notched(garmentFrom("samples/tshirt.obj"), {}, Method::Lscm);
    for (const SeamWalk& walk :
         walkSeams(shirt.garment, shirt.results, shirt.segments, shirt.found())) {
        const SeamMeasure measure = *measured(shirt.garment, shirt.results, walk.seam);
        double left = 0, error = 0;
        for (const WalkStation& station : walk.stations) {
            left += station.left;
            error += station.error();
        }
        EXPECT_NEAR(left, measure.length2dLeft, 1e-9 * left);
        EXPECT_NEAR(error, measure.errorMm, 1e-8);
    }
}

}  // namespace
}  // namespace toile
