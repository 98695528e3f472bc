// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/pattern/label.h"

#include <cmath>

#include <gtest/gtest.h>

#include "core/formats/drawing/drawing.h"
#include "tests/core/formats/export_fixtures.h"

namespace toile {
namespace {

using test::curvedPanel;
using test::horseshoe;
using test::rectangle;

const std::vector<std::string> kLines{"front", "seam line, no allowance"};

bool isWithin(const std::vector<Points2>& loops, const Eigen::Vector2d& p) {
    bool inside = false;
    for (const Points2& loop : loops) {
        for (Eigen::Index i = 0; i < loop.rows(); ++i) {
            const Eigen::Vector2d a = loop.row(i), b = loop.row((i + 1) % loop.rows());
            if ((a.y() > p.y()) != (b.y() > p.y()) &&
                p.x() < a.x() + (p.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x())) {
                inside = !inside;
            }
        }
    }
    return inside;
}

/// Whether points all along the rim of the text block are inside.
bool blockIsInside(const std::vector<Points2>& loops, const LabelPlace& place) {
    const Eigen::Vector2d size = textExtent(kLines, place.height);
    const Eigen::Vector2d topLeft =
        place.position + Eigen::Vector2d(-0.5 * size.x(), 0.5 * place.height);
    for (int i = 0; i <= 100; ++i) {
        const double t = i / 100.0;
        for (const Eigen::Vector2d& p :
             {Eigen::Vector2d(t * size.x(), 0), Eigen::Vector2d(t * size.x(), -size.y()),
              Eigen::Vector2d(0, -t * size.y()), Eigen::Vector2d(size.x(), -t * size.y())}) {
            if (!isWithin(loops, topLeft + p)) {
                return false;
            }
        }
    }
    return true;
}

Points2 turned(const Points2& points, double angle) {
    Eigen::Matrix2d rotation;
    rotation << std::cos(angle), std::sin(angle), -std::sin(angle), std::cos(angle);
    return points * rotation;
}

/// Half a ring, as a neckband lies: a thin arch.
Points2 arch(double radius, double width) {
    constexpr int kHalf = 60;
    Points2 points(2 * kHalf, 2);
    for (int i = 0; i < kHalf; ++i) {
        const double t = M_PI * i / (kHalf - 1);
        points.row(i) << radius * std::cos(t), radius * std::sin(t);
        points.row(2 * kHalf - 1 - i) << (radius - width) * std::cos(t),
            (radius - width) * std::sin(t);
    }
    return points;
}

TEST(PlaceLabel, IsFullSizeInTheMiddleOfAWidePiece) {
    const LabelPlace place = placeLabel({rectangle(-50, 900, 400, 300)}, kLines);
    EXPECT_DOUBLE_EQ(place.height, 10);
    EXPECT_NEAR(place.position.x(), 150, 1e-9);
    EXPECT_NEAR(place.position.y(), 1050 + 0.5 * 1.7 * 10, 1e-9);
}

TEST(PlaceLabel, FillsANarrowRectangle) {
    const Eigen::Vector2d block = textExtent(kLines, 1) + Eigen::Vector2d(1, 1);  // with its air
    for (const double height : {1.6, 4.0, 9.5}) {
        const LabelPlace wide = placeLabel({rectangle(0, 0, 500, height * block.y())}, kLines);
        EXPECT_NEAR(wide.height, height, 1e-9);
        EXPECT_NEAR(wide.position.x(), 250, 1e-9);
        const LabelPlace high = placeLabel({rectangle(0, 0, height * block.x(), 500)}, kLines);
        EXPECT_NEAR(high.height, height, 1e-9);
        EXPECT_TRUE(wide.fits && high.fits);
    }
}

TEST(PlaceLabel, StaysInsideConcaveTurnedAndNarrowPieces) {
    const std::vector<Points2> outlines{horseshoe(0, 0, 300, 60),
                                        turned(horseshoe(0, 0, 300, 40), 3.14159),
                                        rectangle(0, 0, 420, 22),
                                        rectangle(0, 0, 45, 500),
                                        curvedPanel(300, 180),
                                        curvedPanel(37, 40),
                                        arch(200, 60),
                                        turned(rectangle(0, 0, 500, 60), 0.7),
                                        turned(horseshoe(0, 0, 200, 45), 1.1)};
    for (std::size_t i = 0; i < outlines.size(); ++i) {
        const LabelPlace place = placeLabel({outlines[i]}, kLines);
        EXPECT_TRUE(blockIsInside({outlines[i]}, place)) << i << ": " << place.height;
        EXPECT_GE(place.height, 1.5);
        EXPECT_LE(place.height, 10);
        EXPECT_TRUE(place.fits);
    }
}

TEST(PlaceLabel, KeepsOffHoles) {
    // Round the middle of a wide piece, and most of a narrow one.
    for (const auto& loops : {std::vector{rectangle(0, 0, 400, 300), rectangle(150, 100, 100, 100)},
                              std::vector{rectangle(0, 0, 300, 60), rectangle(10, 8, 90, 44),
                                          rectangle(200, 8, 90, 44)}}) {
        const LabelPlace place = placeLabel(loops, kLines);
        EXPECT_TRUE(blockIsInside(loops, place)) << place.position.transpose();
        EXPECT_GE(place.height, 4);
    }
}

TEST(PlaceLabel, DoesNotDependOnWinding) {
    const Points2 outline = horseshoe(10, 20, 300, 60);
    const LabelPlace a = placeLabel({outline}, kLines);
    const LabelPlace b = placeLabel({Points2(outline.colwise().reverse())}, kLines);
    EXPECT_NEAR(a.height, b.height, 1e-9);
    EXPECT_NEAR((a.position - b.position).norm(), 0, 1e-9);
}

/// So many teeth, open at the bottom but for a thin back.
Points2 comb(int teeth, double width, double height) {
    Points2 points(4 * teeth, 2);
    for (int i = 0; i < teeth; ++i) {
        const double x = width * i / teeth, gap = width / teeth / 2;
        points.middleRows<4>(4 * i) << x, 0, x, height, x + gap, height, x + gap, 0.1;
    }
    return points;
}

Points2 subdivided(const Points2& outline, int parts) {
    Points2 points(outline.rows() * parts, 2);
    for (Eigen::Index i = 0; i < points.rows(); ++i) {
        const Eigen::RowVector2d from = outline.row(i / parts);
        const Eigen::RowVector2d to = outline.row((i / parts + 1) % outline.rows());
        points.row(i) = from + static_cast<double>(i % parts) / parts * (to - from);
    }
    return points;
}

TEST(PlaceLabel, DoesNotDependOnHowFineTheOutlineIs) {
    for (const Points2& outline :
         {horseshoe(0, 0, 300, 40), arch(200, 60), turned(rectangle(0, 0, 500, 60), 0.7),
          rectangle(0, 0, 45, 500), comb(20, 900, 60), comb(5, 900, 60)}) {
        const LabelPlace coarse = placeLabel({outline}, kLines);
        const LabelPlace fine = placeLabel({subdivided(outline, 500)}, kLines);
        EXPECT_NEAR(coarse.height, fine.height, 0.01);
        if (coarse.fits) {
            EXPECT_NEAR((coarse.position - fine.position).norm(), 0, 0.5);
        }
    }
}

TEST(PlaceLabel, OfAnOutlineThatLeavesNoRoomIsOnTheCloth) {
    const std::vector<std::string> lines{"sleeve left with a longer name", "cut 2 pairs",
                                         "seam line, no allowance"};
    const Points2 outline = comb(2000, 240, 60);
    const LabelPlace place = placeLabel({outline}, lines);
    EXPECT_EQ(place.height, 1.5);
    EXPECT_FALSE(place.fits);
    EXPECT_TRUE(isWithin({outline}, place.position - Eigen::Vector2d(0, 1.7 * 1.5)));
}

TEST(PlaceLabel, KeepsOffWhatIsDrawnThere) {
    // A line across the middle, and a box beside it.
    Points2 line(2, 2), box(5, 2);
    line << 200, -10, 200, 310;
    box << 0, 100, 120, 100, 120, 300, 0, 300, 0, 100;
    const std::vector<Points2> loops{rectangle(0, 0, 400, 300)};
    const LabelPlace place = placeLabel(loops, kLines, {line, box});
    EXPECT_TRUE(place.fits);
    EXPECT_TRUE(blockIsInside({rectangle(200, 0, 200, 300)}, place)) << place.position.transpose();
    EXPECT_GT(place.height, 9);
}

TEST(PlaceLabel, GoesWithThePieceAndWithItsImage) {
    // With lines that reach to both sides alike, the image of a block is a block.
    const Points2 outline = curvedPanel(97, 80);
    const LabelPlace here = placeLabel({outline}, kLines);
    const LabelPlace there =
        placeLabel({Points2(outline.rowwise() + Eigen::RowVector2d(512, -64))}, kLines);
    EXPECT_NEAR(there.height, here.height, 1e-6);
    EXPECT_NEAR((there.position - here.position - Eigen::Vector2d(512, -64)).norm(), 0, 1e-6);
    Points2 image = outline.colwise().reverse();
    image.col(0) *= -1;
    const LabelPlace mirrored = placeLabel({image}, kLines);
    EXPECT_NEAR(mirrored.height, here.height, 1e-6);
    EXPECT_NEAR(mirrored.position.x(), -here.position.x(), 1e-6);
    EXPECT_NEAR(mirrored.position.y(), here.position.y(), 1e-6);
}

TEST(PlaceLabel, IsAtLeastLegibleWhereNothingFits) {
    const LabelPlace tiny = placeLabel({rectangle(5, 5, 1e-4, 1e-4)}, kLines);
    EXPECT_DOUBLE_EQ(tiny.height, 1.5);
    EXPECT_NEAR(tiny.position.x(), 5, 1e-3);
    const LabelPlace band = placeLabel({rectangle(0, 0, 10, 400)}, kLines);
    EXPECT_DOUBLE_EQ(band.height, 1.5);
    EXPECT_FALSE(band.fits);
    EXPECT_NEAR(band.position.x(), 5, 1e-9);
    EXPECT_NEAR(band.position.y(), 200, 5);
    const LabelPlace strap = placeLabel({horseshoe(0, 0, 90, 4)}, kLines);
    EXPECT_DOUBLE_EQ(strap.height, 1.5);
    EXPECT_TRUE(strap.position.allFinite());
    EXPECT_TRUE(placeLabel({Points2(0, 2)}, kLines).position.allFinite());
}

}  // namespace
}  // namespace toile
