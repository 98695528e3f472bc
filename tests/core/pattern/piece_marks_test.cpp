// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/pattern/piece_marks.h"

#include <cmath>

#include <gtest/gtest.h>

#include "core/geometry/line.h"
#include "core/geometry/segment.h"
#include "core/pattern/half_pattern.h"
#include "tests/core/formats/export_fixtures.h"
#include "tests/core/pattern/allowance_shapes.h"

namespace toile {
namespace {

using Eigen::Vector2d;

/// A piece of this outline, sewn all round by seams of equal lengths.
PatternPiece sewnRound(const Points2& outline, int seamCount, int firstNumber) {
    PatternPiece piece{{}, "piece with a long name", "piece", outline};
    const auto line = geometry::Line::closed(outline);
    for (int k = 0; k < seamCount; ++k) {
        SeamLine& seam = piece.seams.emplace_back();
        seam.number = firstNumber + k;
        seam.name = "front / back, seam " + std::to_string(k);
        seam.line = line.part(line.length() * k / seamCount, line.length() * (k + 1) / seamCount);
    }
    return piece;
}

/// A text as it is drawn.
struct Block {
    Points2 box;  ///< ends where it begins

    /// Whether a segment meets its inside, but for a hair's breadth.
    bool meets(const Vector2d& a, const Vector2d& b) const {
        const Vector2d origin = box.row(0), along = box.row(1) - box.row(0),
                       up = box.row(3) - box.row(0);
        const auto within = [&](const Vector2d& p) {
            return Vector2d((p - origin).dot(along) / along.squaredNorm(),
                            (p - origin).dot(up) / up.squaredNorm());
        };
        const Vector2d from = within(a), low(1e-6, 1e-6), high = Vector2d(1, 1) - low;
        const auto share = geometry::shareInBox<Vector2d>(from, within(b) - from, low, high);
        return share.first <= share.last;
    }
    bool meets(const Points2& line) const {
        for (Eigen::Index i = 1; i < line.rows(); ++i) {
            if (meets(line.row(i - 1), line.row(i))) {
                return true;
            }
        }
        return false;
    }
};

Points2 ending(const Points2& loop) {
    Points2 closed(loop.rows() + 1, 2);
    closed << loop, loop.row(0);
    return closed;
}

Points2 lineOf(const Chord& chord) {
    Points2 line(2, 2);
    line << chord.from.transpose(), chord.to.transpose();
    return line;
}

std::vector<Block> blocksOf(const PieceMarks& marks) {
    std::vector<Block> blocks;
    for (const SeamMark& mark : marks.seams) {
        if (mark.numberPlace) {
            blocks.push_back({textBox(*mark.numberPlace, {numberText(mark)}, mark.angle, 0)});
        }
        if (mark.namePlace) {
            blocks.push_back({textBox(*mark.namePlace, {mark.name}, mark.angle, 0)});
        }
    }
    if (marks.label.fits) {
        blocks.push_back({textBox(marks.label, marks.lines, 0, 0)});
    }
    return blocks;
}

/// No text meets the outline, what is drawn there, a tick or another text; all are on the cloth.
void expectApart(const PatternPiece& piece, const Placement& placement, const PieceMarks& marks,
                 const std::vector<Points2>& drawn, const std::string& where) {
    std::vector<Points2> there{ending(turnedLine(piece.outline, placement))};
    for (const Points2& line : drawn) {
        there.push_back(turnedLine(line, placement));
    }
    for (const SeamMark& mark : marks.seams) {
        for (const auto& tick : mark.ticks) {
            if (tick) {
                there.push_back(lineOf(*tick));
            }
        }
    }
    const Points2 outline = turnedLine(piece.outline, placement);
    const std::vector<Block> blocks = blocksOf(marks);
    for (std::size_t i = 0; i < blocks.size(); ++i) {
        for (const Points2& line : there) {
            EXPECT_FALSE(blocks[i].meets(line)) << where << " text " << i;
        }
        for (std::size_t k = 0; k < blocks.size(); ++k) {
            EXPECT_FALSE(k != i && blocks[i].meets(blocks[k].box)) << where << i << " " << k;
        }
        EXPECT_LT(test::outside(blocks[i].box.row(0), outline), 0) << where << " text " << i;
    }
}

TEST(PieceMarks, MeetNothingOnRandomOutlines) {
    int labels = 0, numbers = 0, beside = 0;
    for (unsigned seed = 0; seed < 40; ++seed) {
        Points2 outline = test::randomAllowances(seed).seamLine;
        if (test::areaOf(outline) < 0) {
            outline = outline.colwise().reverse().eval();
        }
        const PatternPiece piece = sewnRound(outline, 2 + static_cast<int>(seed) % 7, 5);
        const Placement placement{{0, 0}, 0.1 * seed, seed % 3 == 0};
        Points2 dart(3, 2);
        dart << outline.row(0), 0.4 * outline.row(0), outline.row(1);
        const std::vector<std::string> lines =
            labelLines(piece.name, piece, placement.mirrored, {}, CutAs::Whole);
        const PieceMarks marks = placeMarks(piece, placement, lines, 0.3, {dart});
        expectApart(piece, placement, marks, {dart}, std::to_string(seed));
        labels += marks.label.fits ? 1 : 0;
        for (const SeamMark& mark : marks.seams) {
            numbers += mark.numberPlace ? 1 : 0;
        }
        if (marks.grain && marks.label.fits) {
            const Block label{textBox(marks.label, marks.lines, 0, 0)};
            beside += label.meets(lineOf(*marks.grain)) ? 0 : 1;
        }
    }
    EXPECT_GT(labels, 20);
    EXPECT_GT(numbers, 100);
    EXPECT_GT(beside, labels - 6);
}

TEST(PieceMarks, NarrowStripsHaveAllOfThem) {
    for (const double width : {60.0, 24.0, 16.0}) {
        const PatternPiece piece = sewnRound(test::rectangle(0, 0, 500, width), 2, 1);
        for (const double grain : {0.0, kGrainUpwards}) {
            const std::vector<std::string> lines = labelLines("neckband, inner", piece, false, {});
            const PieceMarks marks = placeMarks(piece, {}, lines, grain);
            expectApart(piece, {}, marks, {}, std::to_string(width));
            EXPECT_TRUE(marks.label.fits);
            EXPECT_GT(marks.label.height, 3);
            for (const SeamMark& mark : marks.seams) {
                EXPECT_TRUE(mark.numberPlace && mark.numberPlace->height > 4);
            }
            ASSERT_TRUE(marks.grain);
            EXPECT_FALSE(
                Block{textBox(marks.label, marks.lines, 0, 0)}.meets(lineOf(*marks.grain)));
        }
    }
}

TEST(PieceMarks, KeepOffTheFold) {
    PatternPiece piece = sewnRound(test::rectangle(0, 0, 80, 120), 3, 1);
    piece.cutAs = CutAs::OnFold;
    const std::vector<std::string> lines = labelLines(piece.name, piece, false, {}, piece.cutAs);
    const PieceMarks marks = placeMarks(piece, {}, lines, kGrainUpwards);
    const FoldMark fold = foldMark(piece, {}, "place on fold");
    const Block words{textBox(fold.place, {"place on fold"}, fold.angle, 0)};
    for (const Block& block : blocksOf(marks)) {
        EXPECT_FALSE(block.meets(fold.path));
        EXPECT_FALSE(block.meets(words.box) || words.meets(block.box));
    }
}

TEST(LabelLines, AreAsBeforeWhereNothingElseIsKnown) {
    Cutting cutting;
    cutting.quantity = 2;
    EXPECT_EQ(labelLines("cuff", cutting, true, {}),
              (std::vector<std::string>{"cuff", "cut 2", "seam line, no allowance",
                                        "mirrored: wrong side of the fabric up"}));
}

TEST(LabelLines, SayAllThatIsKnown) {
    LabelFacts facts;
    facts.number = 3;
    facts.count = 12;
    facts.size = "M";
    facts.material = "lining";
    facts.date = "2026-01-31";
    facts.hasAllowance = true;
    EXPECT_EQ(labelLines("cuff", {}, false, {}, CutAs::Pair, facts),
              (std::vector<std::string>{"cuff", "piece 3 of 12", "size M", "lining", "cut 1 pair",
                                        "seam allowance included", "2026-01-31"}));
}

TEST(FactsOf, SayWhatIsStatedOfAnyPattern) {
    Pattern pattern = test::sewingPattern();
    PatternPiece& piece = pattern.pieces.front();
    pattern.hasAllowance = false;
    piece.number = 1;
    EXPECT_EQ(labelLines("front", {}, false, {}, CutAs::Whole, factsOf(pattern, piece)),
              (std::vector<std::string>{"front", "seam line, no allowance"}));
    pattern.label = {"M\n", "31.1.2026"};
    piece.material = std::string(100, 'x');
    const LabelFacts bare = factsOf(pattern, piece);
    EXPECT_EQ(bare.size, "M ");
    EXPECT_EQ(bare.material, std::string(kMaxLabelText, 'x') + "…");
    EXPECT_EQ(bare.date, "31.1.2026");
    EXPECT_FALSE(bare.hasAllowance || bare.number > 0);
    pattern.hasAllowance = true;
    EXPECT_EQ(factsOf(pattern, piece).number, 1);
    EXPECT_EQ(factsOf(pattern, piece).date, "31.1.2026");
}

TEST(BrokenLines, KeepTheWordsAndGetNarrower) {
    const std::vector<std::string> lines{"cuff", "piece 3 of 12", "seam allowance included"};
    EXPECT_EQ(brokenLines(lines),
              (std::vector<std::string>{"cuff", "piece 3 of 12", "seam allowance", "included"}));
    EXPECT_EQ(brokenLines({"seam line, no allowance"}),
              (std::vector<std::string>{"seam line,", "no allowance"}));
    // What cannot be broken sets the width for all.
    const std::vector<std::string> word{"Donaudampfschifffahrtsgesellschaft", "cut 2 pairs"};
    EXPECT_EQ(brokenLines(word), word);
    EXPECT_EQ(brokenLines({" a", "a ", ""}), (std::vector<std::string>{" a", "a ", ""}));
}

TEST(PlaceMarks, BreaksTheLinesOfALabelOnANarrowStrip) {
    const PatternPiece placket = sewnRound(test::rectangle(0, 0, 28, 160), 2, 1);
    LabelFacts facts;
    facts.number = 3;
    facts.count = 12;
    facts.hasAllowance = true;
    const std::vector<std::string> lines =
        labelLines("placket", {}, false, {}, CutAs::Whole, facts);
    const PieceMarks marks = placeMarks(placket, {}, lines, kGrainUpwards);
    EXPECT_TRUE(marks.label.fits);
    EXPECT_GE(marks.label.height, kSmallestLabel);
    EXPECT_EQ(marks.lines, brokenLines(lines));
    EXPECT_NE(marks.lines, lines);
    expectApart(placket, {}, marks, {}, "placket");
    // Where there is room they stay as they are.
    const PatternPiece wide = sewnRound(test::rectangle(0, 0, 100, 160), 2, 1);
    EXPECT_EQ(placeMarks(wide, {}, lines, kGrainUpwards).lines, lines);
}

TEST(AsCut, NumbersWhatIsDrawn) {
    Pattern whole = test::sewingPattern();
    for (std::size_t i = 0; i < whole.pieces.size(); ++i) {
        whole.pieces[i].number = static_cast<int>(i) + 1;
    }
    whole.pieces[1].mirror = {false, 2, true};
    whole.pieces[2].mirror = {false, 1, false};
    whole.pieces[1].byHalf = true;
    const Pattern cut = asCut(whole);
    EXPECT_EQ(drawnCount(cut), 3);
    EXPECT_EQ(cut.pieces[1].number, 2);
    EXPECT_EQ(cut.pieces[2].number, 0);
    EXPECT_EQ(cut.pieces[3].number, 3);
}

TEST(PieceMarks, PiecesBelowASquareCentimetreHaveNoLabel) {
    for (const double side : {0.1, 9.9, 10.1, 40.0}) {
        const PatternPiece piece = sewnRound(test::rectangle(0, 0, side, side), 2, 1);
        const PieceMarks marks = placeMarks(piece, {}, {"name"}, 1.5);
        EXPECT_EQ(marks.lines.empty(), side < 10) << side;
        EXPECT_TRUE(side >= 10 || !marks.grain) << side;
        EXPECT_EQ(marks.seams.size(), 2U);
        EXPECT_LT((marks.label.position - Vector2d(side / 2, side / 2)).norm(), side);
    }
}

}  // namespace
}  // namespace toile
