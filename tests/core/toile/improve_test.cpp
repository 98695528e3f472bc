// SPDX-License-Identifier: GPL-3.0-or-later
// A pattern is moved against the gap that its proof finds.
#include "core/toile/improve.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

#include "core/seam/find_seams.h"
#include "core/seam/seam_measure.h"
#include "core/toile/pipeline.h"
#include "core/toile/sewn_moves.h"
#include "tests/core/support/shapes.h"

namespace toile {
namespace {

/// Half of a bell that stands upright, wider below and curved both ways: like a skirt.
MeshArrays halfBell(int columns, int rows, double turned) {
    MeshArrays mesh = test::planeGrid(columns, rows, 1);
    for (Eigen::Index v = 0; v < mesh.V.rows(); ++v) {
        const double around = turned + std::numbers::pi * mesh.V(v, 0) / columns;
        const double down = 1 - mesh.V(v, 1) / rows;
        const double radius = 100 + 80 * down * down;
        mesh.V.row(v) << radius * std::sin(around), -250 * down, radius * std::cos(around);
    }
    return mesh;
}

Garment bell(int leftRows = 8, int rightRows = 8) {
    Garment garment;
    garment.files = {std::make_shared<const SourceFile>()};
    const std::pair<MeshArrays, const char*> halves[] = {
        {halfBell(12, leftRows, 0), "left"}, {halfBell(12, rightRows, std::numbers::pi), "right"}};
    for (const auto& [mesh, name] : halves) {
        auto piece = std::make_shared<Piece>(makePiece(name, mesh));
        test::identify(*piece, garment.pieces.size() + 1);
        garment.pieces.push_back(std::move(piece));
    }
    garment.uncut = garment.pieces;
    garment.seams = findSeams(garment.pieces);
    return garment;
}

PieceResults flatOfGarment(const Garment& garment) {
    Progress progress;
    return flattenGarment(garment, {}, progress);
}

/// Soft cloth that hangs by its weight.
ImproveOrder hungSoftly() {
    ImproveOrder order;
    order.proof.settings.hasGravity = true;
    order.proof.settings.pressure = 0.3;
    auto& stiffness = order.proof.settings.stiffness;
    stiffness.warp = stiffness.weft = 30;
    stiffness.shear = 10;
    order.rounds = 2;
    return order;
}

double worstSeam(const Garment& garment, const PieceResults& results) {
    double worst = 0;
    for (int s = 0; s < static_cast<int>(garment.seams.seams.size()); ++s) {
        if (garment.seams.seams[s].kind != SeamKind::Free) {
            worst = std::max(worst, std::abs(measured(garment, results, s)->errorMm));
        }
    }
    return worst;
}

std::vector<Points3> randomMoves(const Garment& garment) {
    std::mt19937 random(7);
    std::vector<Points3> moves;
    for (const auto& piece : garment.pieces) {
        Points3& of = moves.emplace_back(piece->mesh.V.rows(), 3);
        for (double& move : of.reshaped()) {
            move = static_cast<double>(random() % 1000) / 100;
        }
    }
    return moves;
}

TEST(ImprovePattern, ClothThatSagsComesToLieNearer) {
    const Garment garment = bell();
    const PieceResults results = flatOfGarment(garment);
    std::vector<ImproveRound> seen;
    ImproveOrder order = hungSoftly();
    order.watch = [&seen](const ImproveRound& round) { seen.push_back(round); };
    Progress progress;
    const auto improved = improvePattern(garment, results, order, progress);
    ASSERT_TRUE(improved) << sentence(improved.error());
    EXPECT_GT(improved->gain(), 0.2);
    EXPECT_EQ(improved->proof->gap.mean,
              std::ranges::min(improved->rounds, {}, [](const ImproveRound& round) {
                  return round.gap.mean;
              }).gap.mean);
    EXPECT_EQ(seen.size(), improved->rounds.size());
    for (const auto& result : improved->results) {
        ASSERT_TRUE(result->flat && result->quality);
        EXPECT_LT(result->quality->maxTargetLengthError, 1e-9);  // of what it is to measure
    }
    EXPECT_LT(worstSeam(garment, improved->results), 1e-9);
}

TEST(ImprovePattern, SeamsWhoseSidesHaveOtherVerticesStayEqual) {
    const Garment garment = bell(8, 12);
    ImproveOrder order = hungSoftly();
    order.rounds = 1;
    Progress progress;
    const auto improved = improvePattern(garment, flatOfGarment(garment), order, progress);
    ASSERT_TRUE(improved) << sentence(improved.error());
    EXPECT_GT(improved->gain(), 0);
    EXPECT_LT(worstSeam(garment, improved->results), 1e-9);
}

TEST(ImprovePattern, WithoutRoundsThePatternIsProvedAsItIs) {
    const Garment garment = bell();
    const PieceResults results = flatOfGarment(garment);
    ImproveOrder order;
    order.rounds = 0;
    Progress progress;
    const auto improved = improvePattern(garment, results, order, progress);
    ASSERT_TRUE(improved) << sentence(improved.error());
    EXPECT_EQ(improved->results, results);
    EXPECT_EQ(improved->rounds.size(), 1U);
    EXPECT_EQ(improved->gain(), 0);
}

TEST(ImprovePattern, EndsWhereARoundGainsLittle) {
    const Garment garment = bell();
    ImproveOrder order;  // pressed on, which folds its excess
    order.rounds = 12;
    Progress progress;
    const auto improved = improvePattern(garment, flatOfGarment(garment), order, progress);
    ASSERT_TRUE(improved) << sentence(improved.error());
    EXPECT_EQ(improved->ended, ImproveEnd::LittleGain);
    EXPECT_LT(improved->rounds.size(), 12U);
    EXPECT_GE(improved->rounds.back().gain, 0);
    EXPECT_LT(improved->rounds.back().gain, kMinGain);
    EXPECT_GT(improved->gain(), 0);
}

TEST(ImprovePattern, EndsWhereTheGapGrowsHoweverItIsMoved) {
    const Garment garment = bell();
    ImproveOrder order;
    order.proof.settings.stiffness.bending = 0.01;  // as a board
    order.rounds = 12;
    Progress progress;
    const auto improved = improvePattern(garment, flatOfGarment(garment), order, progress);
    ASSERT_TRUE(improved) << sentence(improved.error());
    EXPECT_EQ(improved->ended, ImproveEnd::GapGrows);
    const auto& rounds = improved->rounds;
    ASSERT_GT(rounds.size(), 3U);
    EXPECT_LT(rounds.back().gain, 0);
    EXPECT_TRUE(rounds.back().isSmooth);
    EXPECT_LT(rounds.back().share, 1);
    EXPECT_EQ(improved->proof->gap.mean, std::ranges::min(rounds, {}, [](const ImproveRound& r) {
                                             return r.gap.mean;
                                         }).gap.mean);
}

TEST(ImprovePattern, KeepsTheBestWhereTheNextCannotBeFlattened) {
    const Garment garment = bell();
    const PieceResults results = flatOfGarment(garment);
    ImproveOrder order = hungSoftly();
    order.pattern.flattening.method = static_cast<Method>(99);  // there is none
    Progress progress;
    const auto improved = improvePattern(garment, results, order, progress);
    ASSERT_TRUE(improved) << sentence(improved.error());
    EXPECT_EQ(improved->ended, ImproveEnd::NotFlat);
    ASSERT_TRUE(improved->why);
    EXPECT_EQ(improved->why->code, ErrorCode::NotFinite);
    EXPECT_EQ(improved->results, results);
    EXPECT_EQ(improved->rounds.size(), 1U);
}

TEST(ImprovePattern, CanBeCancelledBetweenRounds) {
    const Garment garment = bell();
    Progress progress;
    ImproveOrder order = hungSoftly();
    order.watch = [&progress](const ImproveRound&) { progress.cancel(); };
    const auto improved = improvePattern(garment, flatOfGarment(garment), order, progress);
    ASSERT_FALSE(improved);
    EXPECT_EQ(improved.error().code, ErrorCode::Cancelled);
}

TEST(ImprovePattern, WhatIsLeftOutStaysOut) {
    const Garment garment = bell();
    PieceResults results = flatOfGarment(garment);
    auto out = std::make_shared<PieceResult>(*results[1]);
    out->flat.reset();
    out->error = Error{ErrorCode::LeftOut, subjectOf(*garment.pieces[1])};
    results[1] = out;
    ImproveOrder order = hungSoftly();
    order.rounds = 1;
    Progress progress;
    const auto improved = improvePattern(garment, results, order, progress);
    ASSERT_TRUE(improved) << sentence(improved.error());
    EXPECT_EQ(improved->results[1], results[1]);
    EXPECT_TRUE(improved->results[0]->flat);
}

TEST(MovedGarment, WithoutAMoveIsTheSame) {
    const Garment garment = bell(8, 12);
    std::vector<Points3> positions;
    for (const auto& piece : garment.pieces) {
        positions.push_back(piece->mesh.V);
    }
    const Garment moved = movedGarment(garment, positions);
    ASSERT_EQ(moved.seams.seams.size(), garment.seams.seams.size());
    for (std::size_t s = 0; s < moved.seams.seams.size(); ++s) {
        const Seam &a = moved.seams.seams[s], &b = garment.seams.seams[s];
        EXPECT_NEAR(a.left.start, b.left.start, 1e-9);
        EXPECT_NEAR(a.left.end, b.left.end, 1e-9);
        EXPECT_NEAR(a.right.start, b.right.start, 1e-9);
        EXPECT_NEAR(a.right.end, b.right.end, 1e-9);
        EXPECT_EQ(a.id, b.id);
    }
    EXPECT_EQ(moved.pieces[0]->id, garment.pieces[0]->id);
}

TEST(MovedGarment, GrowsSeamsWithTheirPieces) {
    const Garment garment = bell();
    std::vector<Points3> positions;
    for (const auto& piece : garment.pieces) {
        positions.push_back(1.5 * piece->mesh.V);
    }
    const Garment moved = movedGarment(garment, positions);
    for (std::size_t s = 0; s < moved.seams.seams.size(); ++s) {
        const Seam &a = moved.seams.seams[s], &b = garment.seams.seams[s];
        EXPECT_NEAR(a.left.length(), 1.5 * b.left.length(), 1e-9);
        EXPECT_NEAR(a.length3d[1], 1.5 * b.length3d[1], 1e-9);
        ASSERT_EQ(a.matches.size(), b.matches.size());
        for (std::size_t m = 0; m < a.matches.size(); ++m) {
            EXPECT_NEAR(a.matches[m].right, 1.5 * b.matches[m].right, 1e-9);
        }
    }
}

TEST(SewnMoves, AreTheSameOnBothSidesOfSeams) {
    const Garment garment = bell();
    SewnMoves sewn(garment, randomMoves(garment));
    for (const bool isSmooth : {false, true}) {
        if (isSmooth) {
            sewn.smooth(30);
        }
        int found = 0;
        const Points3 &left = garment.pieces[0]->mesh.V, &right = garment.pieces[1]->mesh.V;
        for (const int a : garment.pieces[0]->boundary) {
            for (const int b : garment.pieces[1]->boundary) {
                if ((left.row(a) - right.row(b)).norm() < 1e-6) {
                    EXPECT_EQ(sewn.moves()[0].row(a), sewn.moves()[1].row(b));
                    ++found;
                }
            }
        }
        EXPECT_EQ(found, 18);
    }
}

TEST(SewnMoves, SmoothingLeavesACommonMoveAndTakesNoiseAway) {
    const Garment garment = bell();
    const auto noise = randomMoves(garment);
    const auto spread = [](const std::vector<Points3>& moves) {
        return (moves[0].rowwise() - moves[0].colwise().mean()).norm();
    };
    SewnMoves sewn(garment, noise);
    sewn.smooth(60);
    EXPECT_LT(spread(sewn.moves()), spread(noise) / 3);
    std::vector<Points3> same = noise;
    for (Points3& of : same) {
        of = Points3::Constant(of.rows(), 3, 2.5);
    }
    SewnMoves common(garment, same);
    common.smooth(60);
    EXPECT_LT((common.moves()[1].array() - 2.5).abs().maxCoeff(), 1e-12);
}

}  // namespace
}  // namespace toile
