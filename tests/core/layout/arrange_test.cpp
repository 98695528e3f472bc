// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/layout/arrange.h"

#include <vector>

#include <gtest/gtest.h>

#include "core/base/units.h"
#include "core/layout/marker.h"

namespace toile {
namespace {

const std::vector<Placement> kPlacements = {
    {}, {{120, -30}, 0.4, false}, {{-5, 8}, -2.9, true}, {{0, 0}, kPi, true}};
const std::vector<Eigen::Vector2d> kPoints = {{0, 0}, {10, 3}, {-7, 50}};

TEST(Arrange, TurnsEveryPointAboutTheCentre) {
    const Eigen::Vector2d centre(40, -12);
    for (const Placement& before : kPlacements) {
        const Placement after = turnedAbout(before, centre, 2.1);
        for (const Eigen::Vector2d& point : kPoints) {
            const Eigen::Vector2d should =
                centre + Eigen::Rotation2Dd(2.1) * (before.applied(point) - centre);
            EXPECT_LT((after.applied(point) - should).norm(), 1e-12);
        }
        EXPECT_EQ(after.mirrored, before.mirrored);
    }
}

TEST(Arrange, MirrorsEveryPointAtTheLine) {
    const Eigen::Vector2d centre(40, -12);
    for (const Placement& before : kPlacements) {
        for (const auto mirroring : {Mirroring::LeftRight, Mirroring::UpsideDown}) {
            const int axis = mirroring == Mirroring::LeftRight ? 0 : 1;
            const Placement after = mirroredAt(before, centre, mirroring);
            EXPECT_NE(after.mirrored, before.mirrored);
            for (const Eigen::Vector2d& point : kPoints) {
                Eigen::Vector2d should = before.applied(point);
                should[axis] = 2 * centre[axis] - should[axis];
                EXPECT_LT((after.applied(point) - should).norm(), 1e-12);
            }
            const Placement again = mirroredAt(after, centre, mirroring);
            EXPECT_LT((again.offset - before.offset).norm(), 1e-12);
            EXPECT_LT(std::abs(wrappedAngle(again.turn - before.turn)), 1e-12);
        }
    }
}

TEST(Arrange, DirectionsGoToTheSheetAndBack) {
    for (const Placement& placement : kPlacements) {
        for (const double direction : {-3.0, -1.2, 0.0, 0.7, 2.5}) {
            const double sheet = directionOnSheet(placement, direction);
            const Eigen::Vector2d should =
                placement.linear() * Eigen::Vector2d(std::cos(direction), std::sin(direction));
            EXPECT_LT((Eigen::Vector2d(std::cos(sheet), std::sin(sheet)) - should).norm(), 1e-12);
            EXPECT_NEAR(wrappedAngle(directionOnPiece(placement, sheet) - direction), 0, 1e-12);
        }
    }
}

TEST(Arrange, WrapsAngles) {
    EXPECT_DOUBLE_EQ(wrappedAngle(-kPi), kPi);
    EXPECT_NEAR(wrappedAngle(7), 7 - 2 * kPi, 1e-15);
    EXPECT_EQ(wrappedAngle(std::nan("")), 0);
    EXPECT_EQ(wrappedAngle(HUGE_VAL), 0);
}

const std::vector<Eigen::AlignedBox2d> kBoxes = {{Eigen::Vector2d(0, 0), Eigen::Vector2d(10, 40)},
                                                 {Eigen::Vector2d(70, 5), Eigen::Vector2d(90, 9)},
                                                 {Eigen::Vector2d(12, -8), Eigen::Vector2d(40, 2)}};

TEST(Arrange, AlignsEveryEdge) {
    const auto moved = [](Alignment alignment, std::size_t i) -> Eigen::AlignedBox2d {
        const Eigen::Vector2d move = alignmentMoves(kBoxes, alignment)[i];
        return {kBoxes[i].min() + move, kBoxes[i].max() + move};
    };
    for (std::size_t i = 0; i < kBoxes.size(); ++i) {
        EXPECT_DOUBLE_EQ(moved(Alignment::Left, i).min().x(), 0);
        EXPECT_DOUBLE_EQ(moved(Alignment::Right, i).max().x(), 90);
        EXPECT_DOUBLE_EQ(moved(Alignment::Top, i).max().y(), 40);
        EXPECT_DOUBLE_EQ(moved(Alignment::Bottom, i).min().y(), -8);
        EXPECT_DOUBLE_EQ(moved(Alignment::Centre, i).center().x(), 45);
        EXPECT_DOUBLE_EQ(moved(Alignment::Middle, i).center().y(), 16);
        EXPECT_EQ(moved(Alignment::Left, i).min().y(), kBoxes[i].min().y());
    }
}

TEST(Arrange, DistributesWithTheSameGaps) {
    const auto moves = distributionMoves(kBoxes, Direction::Across);
    EXPECT_EQ(moves[0].norm() + moves[1].norm(), 0);
    const double low = kBoxes[2].min().x() + moves[2].x() - kBoxes[0].max().x();
    const double high = kBoxes[1].min().x() - kBoxes[2].max().x() - moves[2].x();
    EXPECT_DOUBLE_EQ(low, high);
    const std::vector<Eigen::AlignedBox2d> two(kBoxes.begin(), kBoxes.begin() + 2);
    EXPECT_EQ(distributionMoves(two, Direction::Upwards)[0].norm(), 0);
}

TEST(Arrange, RowsOfBoxesAreThoseOfThePattern) {
    Pattern pattern;
    for (const Eigen::AlignedBox2d& box : kBoxes) {
        Points2 outline(4, 2);
        outline << box.min().x(), box.min().y(), box.max().x(), box.min().y(), box.max().x(),
            box.max().y(), box.min().x(), box.max().y();
        pattern.pieces.push_back({{}, "p", "p", outline});
    }
    EXPECT_EQ(layOutInRows(kBoxes).offset, layOutInRows(pattern).offset);
}

}  // namespace
}  // namespace toile
