// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/read_back.h"

#include <cmath>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

#include "tests/core/formats/export_fixtures.h"

namespace toile {
namespace {

const std::vector<LayerKind> kAll(kLayerKinds.begin(), kLayerKinds.end());

/// What a perfect reader would give.
ReadDrawing readAsIs(const Drawing& drawing, bool withIds) {
    ReadDrawing read;
    read.pieces = static_cast<int>(drawing.blocks.size());
    for (const DrawnPath& path : drawing.paths) {
        read.lines.push_back({path.layer, withIds ? path.id : "", path.points, path.closed});
    }
    return read;
}

std::string faultOf(const ReadDrawing& read, const Drawing& drawing) {
    const auto found = comparedWithDrawing(read, drawing, kAll);
    return found ? "" : std::string(found.error().detail);
}

/// A sheet of 300 x 200 mm sewn along its right and its left side, and a mirrored copy of it.
Drawing sewnDrawing() {
    Pattern pattern;
    for (int k = 0; k < 2; ++k) {
        PatternPiece piece;
        piece.name = piece.slug = k == 0 ? "front" : "back";
        piece.outline = test::rectangle(0, 0, 300, 200);
        for (int side = 0; side < 2; ++side) {
            SeamLine seam;
            seam.number = side + 1;
            seam.name = side == 0 ? "right" : "left";
            seam.line = (Points2(2, 2) << (side == 0 ? 300 : 0), (side == 0 ? 0 : 200),
                         (side == 0 ? 300 : 0), (side == 0 ? 200 : 0))
                            .finished();
            seam.from = side == 0 ? 300 : 800;
            seam.to = seam.from + 200;
            seam.isRight = k == 1;
            seam.length3d = 201;
            piece.seams.push_back(seam);
        }
        pattern.pieces.push_back(piece);
    }
    return draw(pattern, placeCopies(pattern, {Placement{}, Placement{{400, 0}, 0.3, true}}));
}

TEST(ReadBack, OfTheSameLinesHasNoDifference) {
    for (const Drawing& drawing : {test::sewingDrawing(), sewnDrawing()}) {
        for (const bool withIds : {true, false}) {
            const auto found = comparedWithDrawing(readAsIs(drawing, withIds), drawing, kAll);
            ASSERT_TRUE(found) << found.error().detail;
            EXPECT_EQ(found->pieces, static_cast<int>(drawing.blocks.size()));
            EXPECT_LT(found->largest, 1e-9);
            EXPECT_EQ(found->seams, static_cast<int>(drawing.edges.size()));
        }
    }
}

TEST(ReadBack, DoesNotMindWhereAClosedLineBegins) {
    const Drawing drawing = sewnDrawing();
    ReadDrawing read = readAsIs(drawing, true);
    for (ReadLine& line : read.lines) {
        if (line.closed) {
            const Eigen::Index count = line.points.rows();
            const Points2 before = line.points;
            for (Eigen::Index k = 0; k < count; ++k) {
                line.points.row(k) = before.row((k + 2) % count);
            }
        }
    }
    EXPECT_EQ(faultOf(read, drawing), "");
}

/// A comb of 1000 teeth, 100 mm long and 200 m around, as drawn and with longer teeth.
std::string faultOfComb(double longer) {
    Points2 comb(2002, 2);
    for (Eigen::Index k = 0; k < 2001; ++k) {
        comb.row(k) << 0.5 * static_cast<double>(k), k % 2 == 0 ? 0 : 100;
    }
    comb.row(2001) << 500, -10;
    Pattern pattern;
    pattern.pieces.emplace_back().outline = comb;
    const Drawing drawing = draw(pattern, placeCopies(pattern, {Placement{}}));
    ReadDrawing read = readAsIs(drawing, true);
    for (Eigen::Index k = 1; k < 2001; k += 2) {
        read.lines.front().points(k, 1) += longer;
    }
    return faultOf(read, drawing);
}

TEST(ReadBack, AllowsOfVeryLongLinesAMillionth) {
    EXPECT_EQ(faultOfComb(0.00005), "");  // 0.1 mm
    EXPECT_NE(faultOfComb(0.0002).find("longer by 0.400 mm"), std::string::npos);
}

/// A jagged outline, as it is written in whole steps of a grid.
struct Jagged {
    Drawing drawing;
    ReadDrawing read;
};

Jagged jaggedOnGrid(unsigned seed, double grid) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<> radius(300, 303);
    Points2 outline(400, 2);
    for (Eigen::Index k = 0; k < outline.rows(); ++k) {
        const double angle = 2 * std::numbers::pi * static_cast<double>(k) / 400;
        outline.row(k) = radius(random) * Eigen::RowVector2d(std::cos(angle), std::sin(angle));
    }
    Pattern pattern;
    pattern.pieces.emplace_back().outline = outline;
    Jagged jagged{draw(pattern, placeCopies(pattern, {Placement{}})), {}};
    jagged.read = readAsIs(jagged.drawing, true);
    for (ReadLine& line : jagged.read.lines) {
        line.points = grid * (line.points / grid).array().round().matrix();
    }
    return jagged;
}

TEST(ReadBack, AllowsOfLinesOnAGridWhatRoundingDoesToThem) {
    constexpr double kGrid = 0.025;
    int refusedElsewhere = 0;
    for (unsigned seed = 1; seed <= 100; ++seed) {
        const Jagged jagged = jaggedOnGrid(seed, kGrid);
        const auto found = comparedWithDrawing(jagged.read, jagged.drawing, kAll, kGrid);
        EXPECT_TRUE(found) << seed << ": " << found.error().detail;
        refusedElsewhere += faultOf(jagged.read, jagged.drawing).empty() ? 0 : 1;
    }
    EXPECT_GT(refusedElsewhere, 0);
    // What no rounding does: every other point a little farther out.
    Jagged longer = jaggedOnGrid(1, kGrid);
    Points2& points = longer.read.lines.front().points;
    points = longer.drawing.paths[0].points;
    const Eigen::RowVector2d middle = points.colwise().mean();
    for (Eigen::Index k = 0; k < points.rows(); ++k) {
        const Eigen::RowVector2d out = points.row(k) - middle;
        const bool isTip = out.norm() > 301.5;
        points.row(k) += (isTip ? 0.015 : -0.015) * out.normalized();
    }
    EXPECT_FALSE(comparedWithDrawing(longer.read, longer.drawing, kAll, kGrid));
}

TEST(ReadBack, DoesNotMindPointsBetween) {
    const Drawing drawing = test::sewingDrawing();
    ReadDrawing read = readAsIs(drawing, true);
    for (ReadLine& line : read.lines) {
        const Eigen::Index count = line.points.rows();
        Points2 finer(2 * count, 2);
        for (Eigen::Index k = 0; k < count; ++k) {
            finer.row(2 * k) = line.points.row(k);
            finer.row(2 * k + 1) = 0.5 * (line.points.row(k) + line.points.row((k + 1) % count));
        }
        line.points = line.closed ? finer : Points2(finer.topRows(2 * count - 1));
    }
    EXPECT_EQ(faultOf(read, drawing), "");
}

TEST(ReadBack, NamesTheLineThatIsElsewhere) {
    const Drawing drawing = sewnDrawing();
    for (std::size_t k = 0; k < drawing.paths.size(); ++k) {
        ReadDrawing read = readAsIs(drawing, true);
        read.lines[k].points(0, 0) += 0.03;
        EXPECT_NE(faultOf(read, drawing).find(drawing.paths[k].id), std::string::npos)
            << drawing.paths[k].id;
        read.lines[k].points(0, 0) -= 0.03 - 0.01;
        EXPECT_EQ(faultOf(read, drawing), "") << drawing.paths[k].id;
    }
}

TEST(ReadBack, FindsMissingStrangeAndOpenLines) {
    const Drawing drawing = sewnDrawing();
    ReadDrawing fewer = readAsIs(drawing, true), more = fewer, open = fewer, other = fewer;
    fewer.lines.pop_back();
    EXPECT_NE(faultOf(fewer, drawing), "");
    more.lines.push_back(more.lines.front());
    more.lines.back().id = "another";
    EXPECT_NE(faultOf(more, drawing), "");
    open.lines.front().closed = false;
    EXPECT_NE(faultOf(open, drawing), "");
    --other.pieces;
    EXPECT_NE(faultOf(other, drawing).find("1 piece instead of 2"), std::string::npos);
}

/// The line without every second point of its curve, as a file of few points has it.
TEST(ReadBack, MeasuresSeamsOnKeyPoints) {
    Pattern pattern;
    PatternPiece piece;
    piece.name = piece.slug = "disk";
    constexpr int kCount = 400;
    piece.outline.resize(kCount, 2);
    for (int k = 0; k < kCount; ++k) {
        const double angle = 2 * 3.14159265358979 * k / kCount;
        piece.outline.row(k) << 100 * std::cos(angle), 100 * std::sin(angle);
    }
    SeamLine seam;
    seam.number = 1;
    seam.name = "rim";
    seam.line = piece.outline.topRows(kCount / 2 + 1);
    seam.to = kCount / 2 * (piece.outline.row(1) - piece.outline.row(0)).norm();
    piece.seams = {seam};
    pattern.pieces = {piece};
    const Drawing drawing = draw(pattern, placeCopies(pattern));
    const auto thinned = [&](Eigen::Index step) -> ReadDrawing {
        ReadDrawing read = readAsIs(drawing, true);
        Points2& points = read.lines.front().points;
        Points2 few(points.rows() / step, 2);
        for (Eigen::Index k = 0; k < few.rows(); ++k) {
            few.row(k) = points.row(k * step);
        }
        points = few;
        read.lines.front().hasKeyPoints = true;
        return read;
    };
    // Chords are shorter than their arc by its angle squared over 24.
    EXPECT_EQ(faultOf(thinned(2), drawing), "");
    EXPECT_NE(faultOf(thinned(20), drawing).find("edge-1"), std::string::npos);
}

TEST(ReadBack, SaysWhatItFound) {
    EXPECT_EQ(readBackSentence({13, 26, 0.0041}),
              "read back: 13 pieces, largest difference 0.004 mm");
}

}  // namespace
}  // namespace toile
