// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/tables/pattern_match.h"

#include <gtest/gtest.h>

#include "core/formats/read_pattern.h"
#include "core/formats/writers.h"
#include "core/geometry/polygon.h"
#include "tests/core/formats/export_fixtures.h"

namespace toile {
namespace {

Points2 moved(const Points2& line, double angle, double x, double y, bool mirrored = false) {
    Points2 image = line;
    image.col(0) *= mirrored ? -1 : 1;
    const Eigen::Matrix2d turn = Eigen::Rotation2Dd(angle).toRotationMatrix();
    return geometry::antiClockwise((image * turn.transpose()).rowwise() + Eigen::RowVector2d(x, y));
}

/// The same line with its points beginning elsewhere.
Points2 startedAt(const Points2& line, Eigen::Index start) {
    Points2 other(line.rows(), 2);
    for (Eigen::Index k = 0; k < line.rows(); ++k) {
        other.row(k) = line.row((k + start) % line.rows());
    }
    return other;
}

PatternFile fileOf(const std::vector<std::pair<std::string, Points2>>& pieces) {
    PatternFile file;
    for (const auto& [name, line] : pieces) {
        FilePiece& piece = file.pieces.emplace_back();
        piece.name = name;
        piece.sew = line;
    }
    return file;
}

Pattern patternOfLines(const std::vector<std::pair<std::string, Points2>>& pieces) {
    Pattern pattern;
    for (const auto& [name, line] : pieces) {
        PatternPiece& piece = pattern.pieces.emplace_back();
        piece.name = name;
        piece.slug = name;
        piece.outline = line;
    }
    return pattern;
}

TEST(FitLine, FindsTheMotionOfAnyLine) {
    const Points2 lines[] = {test::rectangle(0, 0, 300, 100), test::horseshoe(10, 20, 200, 50),
                             test::curvedPanel(60, 150)};
    for (const Points2& line : lines) {
        for (const bool mirrored : {false, true}) {
            for (const double angle : {0.0, 1.0, 2.5, -3.0}) {
                const Points2 other =
                    startedAt(moved(line, angle, 500, -70, mirrored), line.rows() / 3);
                const LineFit fit = fitLine(line, other);
                EXPECT_LT(fit.farthest, 1e-4) << angle << mirrored;
                EXPECT_NEAR(geometry::perimeterOf(fit.laid), geometry::perimeterOf(line), 1e-9);
            }
        }
    }
    EXPECT_TRUE(fitLine(lines[2], moved(lines[2], 1, 0, 0, true)).mirrored);
    EXPECT_FALSE(fitLine(lines[0], moved(lines[0], 1, 0, 0, true)).mirrored);
    EXPECT_GT(fitLine(lines[2], moved(lines[2], 1, 0, 0, true), false).farthest, 1);
}

TEST(FitLine, MeasuresWhatDiffers) {
    const Points2 line = test::rectangle(0, 0, 300, 100);
    const LineFit fit = fitLine(line, test::rectangle(40, 50, 304, 100));
    EXPECT_NEAR(fit.farthest, 2, 0.02);
    EXPECT_GT(fit.mean, 0.1);
    EXPECT_LT(fit.mean, 2);
    EXPECT_GT(fit.rms, fit.mean);
    EXPECT_LT(fit.rms, fit.farthest);
}

TEST(PatternMatch, PairsByNameThenByShape) {
    const Points2 rectangle = test::rectangle(0, 0, 300, 100), panel = test::curvedPanel(60, 150),
                  shoe = test::horseshoe(0, 0, 200, 50);
    const Pattern pattern = patternOfLines(
        {{"Front, left", panel}, {"b", shoe}, {"c", rectangle}, {"alone", moved(panel, 0, 0, 0)}});
    const PatternFile file = fileOf({{"x", moved(rectangle, 1, 9, 9)},
                                     {"FRONT_LEFT", rectangle},
                                     {"y", moved(shoe, 2, 5, 0, true)}});
    const PatternMatch match = matchPatterns(pattern, file);
    ASSERT_EQ(match.pairs.size(), 3U);
    EXPECT_EQ(match.pairs[0].filePiece, 1);
    EXPECT_EQ(match.pairs[0].by, MatchedBy::Name);  // however little they are alike
    EXPECT_EQ(match.pairs[1].filePiece, 2);
    EXPECT_EQ(match.pairs[1].by, MatchedBy::Shape);
    EXPECT_EQ(match.pairs[2].filePiece, 0);
    EXPECT_LT(match.pairs[2].lines.front().fit.farthest, 1e-4);
    EXPECT_EQ(match.alone, std::vector<int>{3});
    EXPECT_TRUE(match.aloneInFile.empty());
}

TEST(PatternMatch, NamesWhatFitsAsWell) {
    const Points2 rectangle = test::rectangle(0, 0, 300, 100);
    const PatternMatch match =
        matchPatterns(patternOfLines({{"a", rectangle}, {"b", test::horseshoe(0, 0, 200, 50)}}),
                      fileOf({{"x", rectangle},
                              {"y", test::rectangle(0, 0, 300, 100.2)},
                              {"z", test::horseshoe(7, 7, 200, 50)}}));
    ASSERT_EQ(match.pairs.size(), 2U);
    EXPECT_EQ(match.pairs[0].filePiece, 0);
    EXPECT_EQ(match.pairs[0].rivals, std::vector<int>{1});
    EXPECT_TRUE(match.pairs[1].rivals.empty());
    EXPECT_EQ(match.aloneInFile, std::vector<int>{1});
}

TEST(PatternMatch, LeavesUnrelatedShapesAloneAndDoubtsLargeDifferences) {
    const Points2 panel = test::rectangle(0, 0, 300, 200);
    // A fifth longer and 49 % larger: another piece.
    const PatternMatch other = matchPatterns(patternOfLines({{"a", panel}}),
                                             fileOf({{"x", test::rectangle(0, 0, 370, 242)}}));
    EXPECT_TRUE(other.pairs.empty());
    EXPECT_EQ(other.alone, std::vector<int>{0});
    EXPECT_EQ(other.aloneInFile, std::vector<int>{0});
    const auto isDoubtful = [&panel](const std::string& name, double width) {
        const PatternMatch match = matchPatterns(
            patternOfLines({{"a", panel}}), fileOf({{name, test::rectangle(0, 0, width, 200)}}));
        EXPECT_EQ(match.pairs.size(), 1U);
        return !match.pairs.empty() && match.pairs.front().isDoubtful();
    };
    EXPECT_FALSE(isDoubtful("x", 303));
    EXPECT_TRUE(isDoubtful("x", 340));
    EXPECT_FALSE(isDoubtful("a", 303));
    EXPECT_TRUE(isDoubtful("a", 450));  // paired by its name, however little they are alike
}

TEST(PatternMatch, ComparesLineWithLine) {
    Pattern pattern = patternOfLines({{"a", test::rectangle(0, 0, 300, 100)}});
    PatternFile file = fileOf({{"a", test::rectangle(0, 0, 300, 100)}});
    file.pieces.front().cut = test::rectangle(-10, -10, 320, 120);
    EXPECT_EQ(matchPatterns(pattern, file).pairs.front().lines.size(), 1U);
    pattern.pieces.front().cuttingLine = test::rectangle(-10, -10, 320, 120);
    const auto both = matchPatterns(pattern, file).pairs.front().lines;
    ASSERT_EQ(both.size(), 2U);
    EXPECT_EQ(both[1].ours, MatchedLine::Cut);
    EXPECT_LT(both[1].fit.farthest, 1e-6);
    // A file with one line alone.
    file.pieces.front().sew.resize(0, 2);
    EXPECT_EQ(matchPatterns(pattern, file).pairs.front().lines.front().ours, MatchedLine::Cut);
    pattern.pieces.front().cuttingLine.resize(0, 2);
    const auto one = matchPatterns(pattern, file).pairs.front().lines.front();
    EXPECT_EQ(one.ours, MatchedLine::Seam);
    EXPECT_EQ(one.theirs, MatchedLine::Cut);
}

TEST(PatternMatch, FindsOurOwnExport) {
    const Pattern pattern = test::sewingPattern();
    const auto file = readDxfPattern(writePlainDxf(draw(pattern, placeCopies(pattern))));
    ASSERT_TRUE(file);
    const PatternMatch match = matchPatterns(pattern, *file);
    EXPECT_TRUE(match.alone.empty());
    EXPECT_TRUE(match.aloneInFile.empty());
    for (const PieceMatch& pair : match.pairs) {
        EXPECT_LT(pair.lines.front().fit.farthest, 0.02);
    }
    const std::string json = writePatternMatch(pattern, *file, match);
    EXPECT_NE(json.find("\"paired_by\""), std::string::npos);
    const Drawing drawing = drawPatternMatch(pattern, *file, match);
    EXPECT_EQ(drawing.paths.size(), 2 * match.pairs.size());
    for (const DrawnPath& path : drawing.paths) {
        EXPECT_GE(path.points.minCoeff(), 0);
        EXPECT_LE(path.points.col(0).maxCoeff(), drawing.width);
        EXPECT_LE(path.points.col(1).maxCoeff(), drawing.height);
    }
}

}  // namespace
}  // namespace toile
