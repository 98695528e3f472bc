// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tailor/tailor_cuts.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include <gtest/gtest.h>

#include "core/assemble/cut_pieces.h"
#include "tests/core/support/shapes.h"
#include "tests/core/tailor/worn_shapes.h"

namespace toile {
namespace {

/// What comes of a garment that is cut as proposed.
CutPieces cutByTailor(const std::shared_ptr<const Piece>& piece,
                      const std::vector<TailorCut>& proposed) {
    return cutPieces({piece}, {}, true, Progress(), {},
                     {[&proposed](const auto&, const auto&, const auto&) {
                         ProposedCuts made;
                         for (const TailorCut& cut : proposed) {
                             made.cuts.push_back({cut.cut, "from the shape"});
                         }
                         return made;
                     }});
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
    const auto shirt = test::wornPiece(test::wornShirt());
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
    const std::vector<TailorCut> cuts = tailorCuts(test::wornPiece(test::wornShirt()));
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
    const std::vector<TailorCut> cuts = tailorCuts(test::wornPiece(test::wornShirt()));
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
    const auto trousers = test::wornPiece(test::wornTrousers());
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
    // Of a lathe every ruling is an even row of edges, along which it is bent.
    for (const auto& [around, along] : {std::pair(64, 30), {48, 48}, {40, 40}, {32, 60}}) {
        const auto skirt = test::wornPiece(test::wornSkirt(around, along));
        const CutPieces made = cutByTailor(skirt, tailorCuts(skirt));
        EXPECT_EQ(made.pieces.size(), 2U) << around;
        EXPECT_TRUE(areDisks(made));
    }
}

TEST(TailorCuts, WhatIsNotWornGetsNone) {
    EXPECT_TRUE(tailorCuts(test::wornPiece(test::octahedron())).empty());
    EXPECT_TRUE(tailorCuts(test::wornPiece(test::piercedTorus(24, 12))).empty());
}

TEST(TailorCuts, WhatIsProposedOnceIsNotAskedForAgain) {
    const auto skirt = test::wornPiece(test::wornSkirt());
    int asked = 0;
    const CutProposer propose{[&asked](const auto& piece, const auto&, const Progress& progress) {
        ++asked;
        ProposedCuts made;
        for (const TailorCut& cut : tailorCuts(piece, progress)) {
            made.cuts.push_back({cut.cut, "from the shape"});
        }
        return made;
    }};
    const CutPieces first = cutPieces({skirt}, {}, true, Progress(), {}, propose);
    const CutPieces again = cutPieces({skirt}, {}, true, Progress(), first.records, propose);
    EXPECT_EQ(asked, 1);
    EXPECT_EQ(again.pieces, first.pieces);  // by pointer
    // Nor is a piece that is not worn, of which it is said.
    const auto ball = test::wornPiece(test::octahedron());
    const CutPieces none = cutPieces({ball}, {}, true, Progress(), {}, propose);
    const CutPieces still = cutPieces({ball}, {}, true, Progress(), none.records, propose);
    EXPECT_EQ(asked, 2);
    ASSERT_EQ(still.problems.size(), 1U);
    EXPECT_EQ(still.problems[0].code, ErrorCode::NoBodySeen);
    EXPECT_FALSE(still.pieces[0]->defect);
}

TEST(TailorCuts, CutsThatMeetStillMeetWhereNoVertexLiesInTheMiddle) {
    MeshArrays mesh = test::wornTrousers();
    for (Eigen::Index v = 0; v < mesh.V.rows(); ++v) {
        if (mesh.V(v, 0) == 0) {
            mesh.V(v, 0) = 4;  // and the mirror plane is nearly where it was
        }
    }
    const auto trousers = test::wornPiece(mesh);
    const std::vector<TailorCut> cuts = tailorCuts(trousers);
    const CutPieces made = cutByTailor(trousers, cuts);
    EXPECT_EQ(made.pieces.size(), 4U);
    EXPECT_EQ(made.cuts.size(), cuts.size());
    EXPECT_TRUE(areDisks(made));
}

TEST(TailorCuts, CancelledThereAreNone) {
    Progress progress;
    progress.cancel();
    EXPECT_TRUE(tailorCuts(test::wornPiece(test::wornShirt()), progress).empty());
}

}  // namespace
}  // namespace toile
