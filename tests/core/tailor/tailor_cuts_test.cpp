// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tailor/tailor_cuts.h"

#include <algorithm>
#include <cmath>
#include <map>

#include <gtest/gtest.h>

#include "core/garment/cut_pieces.h"
#include "tests/core/support/shapes.h"
#include "tests/core/tailor/worn_shapes.h"

namespace toile {
namespace {

/// What comes of a garment that is cut as proposed.
CutPieces cutByTailor(const std::shared_ptr<const Piece>& piece,
                      const std::vector<TailorCut>& proposed) {
    std::vector<ProposedCut> cuts;
    for (const TailorCut& cut : proposed) {
        cuts.push_back({cut.cut, "by the form"});
    }
    return cutPieces({piece}, {}, true, Progress(), {}, {cuts});
}

bool areDisks(const CutPieces& made) {
    return std::ranges::all_of(made.pieces, [](const auto& piece) { return !piece->defect; });
}

std::map<std::string, const TailorCut*> byName(const std::vector<TailorCut>& cuts) {
    std::map<std::string, const TailorCut*> named;
    for (const TailorCut& cut : cuts) {
        named[cut.cut.name] = &cut;
    }
    return named;
}

TEST(TailorCuts, AShirtFallsIntoFrontBackAndSleeves) {
    const auto shirt = test::asPiece(test::wornShirt());
    const std::vector<TailorCut> cuts = tailorCuts(shirt);
    const auto named = byName(cuts);
    for (const char* name : {"left side", "right side", "left underarm", "right underarm",
                             "left shoulder", "right shoulder", "left armhole", "right armhole"}) {
        EXPECT_TRUE(named.contains(name)) << name;
    }
    const CutPieces made = cutByTailor(shirt, cuts);
    EXPECT_EQ(made.pieces.size(), 4U);
    EXPECT_TRUE(areDisks(made));
    EXPECT_TRUE(std::ranges::all_of(
        made.cuts, [](const AppliedCut& cut) { return cut.author == CutAuthor::Automatic; }));
}

TEST(TailorCuts, SeamsRunWhereFrontMeetsBackAndMeetAtTheArmpit) {
    const std::vector<TailorCut> cuts = tailorCuts(test::asPiece(test::wornShirt()));
    const auto named = byName(cuts);
    const Eigen::Vector3d armpit(200, 440, 0);  // of the wearer, who looks along z, the left one
    for (const char* name : {"left side", "left underarm"}) {
        for (const Eigen::Vector3d& point : named.at(name)->cut.points) {
            EXPECT_LT(std::abs(point.z()), 25) << name;
        }
    }
    const Eigen::Vector3d meet = named.at("left side")->cut.points.front();
    EXPECT_LT((meet - armpit).norm(), 25);
    EXPECT_EQ(named.at("left underarm")->cut.points.back(), meet);
    EXPECT_EQ(named.at("left armhole")->cut.points.front(), meet);
}

TEST(TailorCuts, BothSidesOfASymmetricGarmentAreCutAlike) {
    const std::vector<TailorCut> cuts = tailorCuts(test::asPiece(test::wornShirt()));
    const auto named = byName(cuts);
    for (const char* line : {"side", "underarm", "shoulder", "armhole"}) {
        const auto& left = named.at(std::string("left ") + line)->cut.points;
        const auto& right = named.at(std::string("right ") + line)->cut.points;
        ASSERT_EQ(left.size(), right.size());
        for (std::size_t k = 0; k < left.size(); ++k) {
            EXPECT_LT((left[k].cwiseProduct(Eigen::Vector3d(-1, 1, 1)) - right[k]).norm(), 1e-6);
        }
    }
}

TEST(TailorCuts, TrousersAreCutAlongLegsAndThroughTheCrotch) {
    const auto trousers = test::asPiece(test::wornTrousers());
    const std::vector<TailorCut> cuts = tailorCuts(trousers);
    const auto named = byName(cuts);
    ASSERT_TRUE(named.contains("centre") && named.contains("left inseam"));
    for (const Eigen::Vector3d& point : named.at("centre")->cut.points) {
        EXPECT_LT(std::abs(point.x()), 21);
    }
    const CutPieces made = cutByTailor(trousers, cuts);
    EXPECT_EQ(made.pieces.size(), 4U);
    EXPECT_TRUE(areDisks(made));
}

TEST(TailorCuts, ASkirtIsCutAlongItsSides) {
    const auto skirt = test::asPiece(test::wornSkirt());
    const CutPieces made = cutByTailor(skirt, tailorCuts(skirt));
    EXPECT_EQ(made.pieces.size(), 2U);
    EXPECT_TRUE(areDisks(made));
}

TEST(TailorCuts, WhatIsNotWornGetsNone) {
    EXPECT_TRUE(tailorCuts(test::asPiece(test::octahedron())).empty());
    EXPECT_TRUE(tailorCuts(test::asPiece(test::piercedTorus(24, 12))).empty());
}

TEST(TailorCuts, NothingIsProposedWhereAPersonHasCut) {
    const auto skirt = test::asPiece(test::wornSkirt());
    std::vector<ProposedCut> proposed;
    for (const TailorCut& cut : tailorCuts(skirt)) {
        proposed.push_back({cut.cut, {}});
    }
    UserCut own;
    own.name = "mine";
    own.points = {{0, 600, -90}, {0, 0, -210}};
    const CutPieces made = cutPieces({skirt}, {own}, true, Progress(), {}, {proposed});
    ASSERT_EQ(made.cuts.size(), 1U);
    EXPECT_EQ(made.cuts[0].name, "mine");
}

TEST(TailorCuts, CancelledThereAreNone) {
    Progress progress;
    progress.cancel();
    EXPECT_TRUE(tailorCuts(test::asPiece(test::wornShirt()), progress).empty());
}

}  // namespace
}  // namespace toile
