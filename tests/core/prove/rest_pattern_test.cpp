// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/prove/rest_pattern.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "tests/core/prove/proved_garment.h"
#include "tests/core/support/shared_data.h"

namespace toile::prove {
namespace {

/// How far places along a loop are from where they lie in our pattern, moved and enlarged.
double farthestPlace(const RestLoop& loop, double scale) {
    constexpr int kTried = 200;
    Points2 drawn(kTried, 2), rest(kTried, 2);
    for (int k = 0; k < kTried; ++k) {
        drawn.row(k) = loop.drawnAt(loop.length() * k / kTried);
        rest.row(k) = loop.restAt(loop.length() * k / kTried) / scale;
    }
    drawn.rowwise() -= drawn.colwise().mean().eval();
    rest.rowwise() -= rest.colwise().mean().eval();
    return (drawn - rest).rowwise().norm().maxCoeff();
}

double farthestPlace(const RestPattern& pattern, double scale) {
    double farthest = 0;
    for (const auto& piece : pattern.pieces) {
        EXPECT_TRUE(piece);
        for (const auto& loop : piece->loops) {
            EXPECT_TRUE(loop);
            farthest = std::max(farthest, farthestPlace(*loop, scale));
        }
    }
    return farthest;
}

TEST(RestPattern, OurOwnFileLiesOnOursToItsDecimals) {
    for (const char* sample : {"tshirt", "trousers", "cap", "bodice", "skirt"}) {
        const test::ProvedGarment garment(
            test::sourceFile(std::string("resources/samples/") + sample + ".obj"));
        const auto pattern = restPattern(garment.source(), {});
        ASSERT_TRUE(pattern);
        EXPECT_LT(farthestPlace(*pattern, 1), 1e-4) << sample;
    }
}

/// Its file's unit is known, and not guessed by how large people are.
TEST(RestPattern, ADollsPatternIsReadInItsSize) {
    LoadOptions options;
    options.unit = FileUnit::ofMillimetres(0.05);
    options.up = UpAxis::Y;
    const test::ProvedGarment garment(test::sourceFile("resources/samples/tshirt.obj"), options);
    const auto pattern = restPattern(garment.source(), {});
    ASSERT_TRUE(pattern);
    EXPECT_LT(farthestPlace(*pattern, 1), 1e-3);
}

TEST(RestPattern, AFileOfAnotherSizeThatLiesOtherwiseDoesToo) {
    const test::ProvedGarment garment(test::sourceFile("resources/samples/tshirt.obj"));
    for (const double scale : {0.95, 1.05}) {
        ProofOrder order;
        order.file = garment.file();
        const Eigen::Rotation2Dd turn(0.7);
        for (FilePiece& piece : order.file->pieces) {
            test::changePoints(piece, [&](Eigen::Ref<Eigen::RowVector2d> p) {
                p = scale * (turn * Eigen::Vector2d(p.transpose())).transpose();
            });
            for (Eigen::Vector2d& end : *piece.grain) {
                end = scale * (turn * end);
            }
        }
        const auto pattern = restPattern(garment.source(), order);
        ASSERT_TRUE(pattern);
        // The grain line says by how much it is turned, to its decimals.
        EXPECT_LT(farthestPlace(*pattern, scale), 0.05) << scale;
        for (const auto& piece : pattern->pieces) {
            EXPECT_NEAR(std::remainder(piece->warp - std::numbers::pi / 2, std::numbers::pi), 0,
                        1e-4);
        }
    }
}

TEST(LineMap, FollowsALineWithoutCorners) {
    Points2 oval(90, 2), other(90, 2);
    for (int k = 0; k < 90; ++k) {
        const double angle = 2 * std::numbers::pi * k / 90;
        oval.row(k) << 100 * std::cos(angle), 60 * std::sin(angle) + 8 * std::cos(2 * angle);
    }
    for (int k = 0; k < 90; ++k) {
        other.row(k) = oval.row((k + 37) % 90);
    }
    const auto ours = geometry::Line::closed(oval), theirs = geometry::Line::closed(other);
    const LineMap map(ours, theirs, roughFit(ours, theirs, {0}));
    for (double at = -50; at < 700; at += 13) {
        EXPECT_LT((ours.pointAt(at) - theirs.pointAt(map.theirsAt(at))).norm(), 1e-4) << at;
    }
}

TEST(LineMap, PairsCornersWhereLengthsDiffer) {
    Points2 ours(4, 2), theirs(6, 2);
    ours << 0, 0, 300, 0, 300, 100, 0, 100;
    // 12 mm shorter, begun elsewhere, with a notch cut into one side.
    theirs << 288, 100, 0, 100, 0, 0, 140, 0, 144, 1, 288, 0;
    const auto line = geometry::Line::closed(ours), other = geometry::Line::closed(theirs);
    const LineMap map(line, other, roughFit(line, other, {0}));
    for (int k = 0; k < 4; ++k) {
        const Eigen::RowVector2d there = other.pointAt(map.theirsAt(line.arc()[k]));
        EXPECT_NEAR(there.y(), ours(k, 1), 1e-9);
        EXPECT_NEAR(there.x(), ours(k, 0) * 288 / 300, 1e-9);
    }
}

}  // namespace
}  // namespace toile::prove
