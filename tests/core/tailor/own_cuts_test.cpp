// SPDX-License-Identifier: GPL-3.0-or-later
// Tailors' cuts beside those that a person has drawn.
#include <algorithm>
#include <random>

#include <gtest/gtest.h>

#include "core/assemble/cut_pieces.h"
#include "core/geometry/segment.h"
#include "core/tailor/tailor_cuts.h"
#include "tests/core/tailor/worn_shapes.h"

namespace toile {
namespace {

UserCut drawn(const char* name, std::vector<Eigen::Vector3d> points,
              UserCut::Kind kind = UserCut::Kind::Path) {
    UserCut cut;
    cut.name = name;
    cut.kind = kind;
    cut.points = std::move(points);
    return cut;
}

CutProposer tailor(int& asked) {
    return {[&asked](const auto& piece, const auto& own, const Progress& progress) {
        ++asked;
        ProposedCuts made;
        if (const auto body = readBody(piece, progress)) {
            for (const TailorCut& cut : tailorCuts(*piece, *body, own, progress)) {
                made.cuts.push_back({cut.cut, "from the shape"});
            }
        }
        return made;
    }};
}

CutPieces cutBeside(const std::shared_ptr<const Piece>& piece, const std::vector<UserCut>& own) {
    int asked = 0;
    return cutPieces({piece}, own, true, Progress(), {}, tailor(asked));
}

double areaOfAll(const CutPieces& made) {
    double area = 0;
    for (const auto& piece : made.pieces) {
        for (int f = 0; f < piece->mesh.F.rows(); ++f) {
            area += doubleAreaNormal(piece->mesh, f).norm() / 2;
        }
    }
    return area;
}

const AppliedCut* cutNamed(const CutPieces& made, const std::string& name) {
    const auto found = std::ranges::find(made.cuts, name, &AppliedCut::name);
    return found == made.cuts.end() ? nullptr : &*found;
}

/// Every cut of a person's is what it is where nothing is proposed.
void expectAsDrawn(const std::shared_ptr<const Piece>& piece, const std::vector<UserCut>& own,
                   const CutPieces& made) {
    const CutPieces alone = cutPieces({piece}, own, false, Progress());
    std::size_t at = 0;
    for (const AppliedCut& cut : alone.cuts) {
        ASSERT_LT(at, made.cuts.size());
        EXPECT_EQ(made.cuts[at].name, cut.name);
        EXPECT_EQ(made.cuts[at].author, CutAuthor::User);
        EXPECT_EQ(made.cuts[at].id, cut.id);
        EXPECT_EQ(made.cuts[at].points, cut.points);
        EXPECT_NEAR(made.cuts[at].length, cut.length, 1e-9 * cut.length);
        ++at;
    }
    EXPECT_EQ(made.problems.size(), alone.problems.size());
}

double distanceTo(const AppliedCut& cut, const Eigen::Vector3d& p) {
    double least = (cut.points.front() - p).norm();
    for (std::size_t k = 1; k < cut.points.size(); ++k) {
        least = std::min(least, geometry::distanceToSegment(p, cut.points[k - 1], cut.points[k]));
    }
    return least;
}

TEST(OwnCuts, AreMadeAsDrawnWithProposalsBesideThem) {
    const auto shirt = test::wornPiece(test::wornShirt());
    const std::vector<UserCut> own{drawn("opening", {{7, 520, 80}, {-3, 250, 80}, {4, 0, 80}})};
    const CutPieces made = cutBeside(shirt, own);
    expectAsDrawn(shirt, own, made);
    EXPECT_EQ(made.pieces.size(), 5U);  // the front in two
    EXPECT_TRUE(
        std::ranges::none_of(made.pieces, [](const auto& piece) { return !!piece->defect; }));
}

TEST(OwnCuts, WhatRunsAlongOneIsNotCutTwice) {
    const auto shirt = test::wornPiece(test::wornShirt());
    // The left side, drawn a little to the front; and across the body at the waist.
    const std::vector<UserCut> own{
        drawn("my side", {{198, 440, 15}, {196, 220, 22}, {197, 0, 12}}),
        drawn("belt", {{0, 250, 80}, {200, 250, 0}, {0, 250, -80}, {-200, 250, 0}},
              UserCut::Kind::Loop)};
    for (std::size_t count = 1; count <= own.size(); ++count) {
        const std::vector<UserCut> some(own.begin(), own.begin() + std::ptrdiff_t(count));
        const CutPieces made = cutBeside(shirt, some);
        expectAsDrawn(shirt, some, made);
        double along = 0;
        const AppliedCut& side = *cutNamed(made, "my side");
        for (const AppliedCut& cut : made.cuts) {
            for (std::size_t k = 1; k < cut.points.size() && cut.author != CutAuthor::User; ++k) {
                const Eigen::Vector3d middle = (cut.points[k - 1] + cut.points[k]) / 2;
                along += distanceTo(side, middle) < 25 && middle.y() < 420
                             ? (cut.points[k] - cut.points[k - 1]).norm()
                             : 0;
            }
        }
        EXPECT_LT(along, 1e-6);
        EXPECT_EQ(made.pieces.size(), count == 1 ? 4U : 6U);
        for (const auto& piece : made.pieces) {
            EXPECT_GT(piece->mesh.F.rows(), 250) << "a scrap";
        }
    }
}

TEST(OwnCuts, ProposalsThatMeetOneEndOnIt) {
    const auto shirt = test::wornPiece(test::wornShirt());
    // Around the left arm, outward of where the armhole would be.
    const std::vector<UserCut> own{
        drawn("my armhole", {{230, 520, 75}, {225, 600, 0}, {230, 520, -75}, {225, 440, 0}},
              UserCut::Kind::Loop)};
    const CutPieces made = cutBeside(shirt, own);
    expectAsDrawn(shirt, own, made);
    EXPECT_EQ(made.pieces.size(), 4U);
    EXPECT_FALSE(cutNamed(made, "left armhole"));
    EXPECT_TRUE(cutNamed(made, "right armhole"));
}

TEST(OwnCuts, WhereTheyOpenAPieceNothingIsProposed) {
    const auto skirt = test::wornPiece(test::wornSkirt());
    int asked = 0;
    const CutPieces made = cutPieces({skirt}, {drawn("mine", {{0, 600, -90}, {0, 0, -210}})}, true,
                                     Progress(), {}, tailor(asked));
    EXPECT_EQ(asked, 0);
    ASSERT_EQ(made.cuts.size(), 1U);
    EXPECT_EQ(made.cuts[0].name, "mine");
}

TEST(OwnCuts, ProposalsAreAskedForAgainWhereTheyAreOthers) {
    const auto shirt = test::wornPiece(test::wornShirt());
    const std::vector<UserCut> own{drawn("opening", {{0, 520, 80}, {0, 0, 80}})};
    int asked = 0;
    const CutProposer proposer = tailor(asked);
    const CutPieces first = cutPieces({shirt}, own, true, Progress(), {}, proposer);
    const CutPieces again = cutPieces({shirt}, own, true, Progress(), first.records, proposer);
    EXPECT_EQ(asked, 1);
    EXPECT_EQ(again.pieces, first.pieces);  // by pointer
    const CutPieces without = cutPieces({shirt}, {}, true, Progress(), first.records, proposer);
    EXPECT_EQ(asked, 2);
    // A proposal that stays has the id it had, and with it what is known of its seam.
    ASSERT_TRUE(cutNamed(first, "right side") && cutNamed(without, "right side"));
    EXPECT_EQ(cutNamed(first, "right side")->id, cutNamed(without, "right side")->id);
}

TEST(OwnCuts, ATangleOfThemHoldsNothingUp) {
    const auto shirt = test::wornPiece(test::wornShirt());
    std::mt19937 random(11);
    const auto place = [&] {
        const auto v =
            static_cast<Eigen::Index>(random() % static_cast<unsigned>(shirt->mesh.V.rows()));
        return Eigen::Vector3d(shirt->mesh.V.row(v));
    };
    for (const bool isShort : {true, false}) {
        std::vector<UserCut> own;
        for (int k = 0; k < 300; ++k) {
            const Eigen::Vector3d from = place();
            const Eigen::Vector3d to =
                isShort ? Eigen::Vector3d(0.9 * from + 0.1 * place()) : place();
            own.push_back(drawn(("cut " + std::to_string(k)).c_str(), {from, to}));
        }
        const CutPieces made = cutBeside(shirt, own);
        expectAsDrawn(shirt, own, made);
        EXPECT_NEAR(areaOfAll(made), areaOfAll(cutPieces({shirt}, {}, false, Progress())), 1e-3);
        const auto byUser = std::ranges::count(made.cuts, CutAuthor::User, &AppliedCut::author);
        EXPECT_GT(byUser, 250);
        if (isShort) {
            EXPECT_TRUE(cutNamed(made, "left underarm"));
        }
    }
}

}  // namespace
}  // namespace toile
