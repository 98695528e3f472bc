// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/drawing/drawing.h"

#include <set>

#include <gtest/gtest.h>

#include "core/formats/writers.h"
#include "core/pattern/label.h"
#include "tests/core/formats/export_fixtures.h"

namespace toile {
namespace {

struct Box {
    Eigen::Vector2d low, high;

    bool overlaps(const Box& o) const {
        return (low.array() < o.high.array()).all() && (o.low.array() < high.array()).all();
    }
};

Box boxOf(const DrawnPath& path) {
    return {path.points.colwise().minCoeff().transpose(),
            path.points.colwise().maxCoeff().transpose()};
}

Box boxOf(const DrawnText& text) {
    const Eigen::Vector2d size = textExtent(text.lines, text.height);
    const Eigen::Vector2d top = text.position + Eigen::Vector2d(0, 0.5 * text.height);
    return {{top.x() - 0.5 * size.x(), top.y() - size.y()}, {top.x() + 0.5 * size.x(), top.y()}};
}

void expectOnPage(const Box& box, const Drawing& drawing, double margin) {
    EXPECT_GE(box.low.minCoeff(), margin - 1e-9);
    EXPECT_LE(box.high.x(), drawing.width - margin + 1e-9);
    EXPECT_LE(box.high.y(), drawing.height - margin + 1e-9);
}

TEST(Draw, KeepsOutlinesApartAndWithinTheMargin) {
    const Drawing drawing = test::sewingDrawing();
    ASSERT_EQ(drawing.paths.size(), 5u);
    for (std::size_t i = 0; i < drawing.paths.size(); ++i) {
        expectOnPage(boxOf(drawing.paths[i]), drawing, 10);
        for (std::size_t j = 0; j < i; ++j) {
            EXPECT_FALSE(boxOf(drawing.paths[i]).overlaps(boxOf(drawing.paths[j]))) << i << j;
        }
    }
}

TEST(DrawingNotes, NameWhatLiesOnEachOther) {
    const Pattern pattern = test::sewingPattern();
    Marker marker = placeCopies(pattern);
    EXPECT_TRUE(overlapNotes(pattern, draw(pattern, marker)).empty());
    const auto middleOf = [drawing = draw(pattern, marker)](std::size_t block) {
        const Box box = boxOf(drawing.paths[drawing.blocks[block].path]);
        return Eigen::Vector2d((box.low + box.high) / 2);
    };
    marker.copies[3].placement.offset += middleOf(0) - middleOf(3);
    const auto notes = overlapNotes(pattern, draw(pattern, marker));
    ASSERT_EQ(notes.size(), 1U);
    EXPECT_NE(notes[0].find(pattern.pieces[0].name + " / " + pattern.pieces[3].name),
              std::string::npos);
}

TEST(DrawingNotes, NamePiecesWithoutAGrainLineOnce) {
    Pattern pattern = test::sewingPattern();
    Marker marker = placeCopies(pattern);
    marker.copies.push_back(marker.copies[0]);
    for (PatternPiece& piece : pattern.pieces) {
        piece.grain = kGrainUpwards;
    }
    EXPECT_TRUE(grainNotes(pattern, draw(pattern, marker)).empty());
    pattern.pieces[0].grain.reset();
    const auto notes = grainNotes(pattern, draw(pattern, marker));
    ASSERT_EQ(notes.size(), 1U);
    EXPECT_NE(notes[0].find(": \"" + pattern.pieces[0].name + "\"."), std::string::npos);
}

TEST(Draw, KeepsEveryEdgeLength) {
    const Pattern pattern = test::sewingPattern();
    const Drawing drawing = draw(pattern, placeCopies(pattern));
    ASSERT_GE(pattern.pieces.size(), 2U);
    for (std::size_t i = 0; i < pattern.pieces.size(); ++i) {
        const Eigen::VectorXd is = test::edgeLengths(drawing.paths[i].points);
        const Eigen::VectorXd should = test::edgeLengths(pattern.pieces[i].outline);
        EXPECT_LT((is - should).cwiseAbs().maxCoeff(), 1e-11) << i;
    }
}

TEST(Draw, NamesPiecesAndSaysThatThereIsNoAllowance) {
    const Drawing drawing = test::sewingDrawing();
    ASSERT_EQ(drawing.texts.size(), 5u);
    EXPECT_EQ(drawing.texts[1].lines,
              (std::vector<std::string>{"前身頃", "seam line, no allowance"}));
    EXPECT_EQ(drawing.texts[1].layer, LayerKind::Text);
    EXPECT_EQ(drawing.paths[1].layer, LayerKind::Cut);
    std::set<std::string> ids;
    for (const DrawnPath& path : drawing.paths) {
        EXPECT_TRUE(ids.insert(path.id).second) << path.id;
    }
    for (const DrawnText& text : drawing.texts) {
        EXPECT_TRUE(ids.insert(text.id).second) << text.id;
    }
    EXPECT_TRUE(ids.contains("piece-aermel-cut") && ids.contains("piece-cuff-2-name"));
}

TEST(Draw, SpeaksTheWordsOfItsCaller) {
    Pattern pattern = test::sewingPattern();
    pattern.pieces[0].quantity = 3;
    pattern.pieces[1].mirroredPair = true;
    const std::vector<std::optional<Placement>> placements{{}, Placement{{0, 0}, 0, true}};
    const Drawing drawing = draw(pattern, placeCopies(pattern, placements),
                                 {.noAllowance = "ohne Zugabe",
                                  .mirrored = "gespiegelt",
                                  .cut = "%1 x",
                                  .cutPair = "ein Paar",
                                  .cutPairs = "%1 Paare",
                                  .checkSquare = "zum Messen"});
    const auto below = [&](std::size_t i) {
        return std::vector(drawing.texts[i].lines.begin() + 1, drawing.texts[i].lines.end());
    };
    EXPECT_EQ(below(0), (std::vector<std::string>{"3 x", "ohne Zugabe"}));
    EXPECT_EQ(below(1), (std::vector<std::string>{"ein Paar", "ohne Zugabe", "gespiegelt"}));
    EXPECT_EQ(drawing.texts.back().lines, std::vector<std::string>{"zum Messen"});
}

TEST(Draw, SaysHowOftenAPieceIsCut) {
    Pattern pattern = test::sewingPattern();
    pattern.pieces[0].quantity = 3;
    pattern.pieces[1].mirroredPair = true;
    pattern.pieces[2].mirroredPair = true;
    pattern.pieces[2].quantity = 2;
    const Drawing drawing = draw(pattern, placeCopies(pattern));
    const auto second = [&](std::size_t i) { return drawing.texts[i].lines[1]; };
    EXPECT_EQ(second(0), "cut 3");
    EXPECT_EQ(second(1), "cut 1 pair");
    EXPECT_EQ(second(2), "cut 2 pairs");
    EXPECT_EQ(second(3), "seam line, no allowance");
    for (const std::string& file : {writeSvg(drawing), writePlainDxf(drawing)}) {
        for (const char* note : {"cut 3", "cut 1 pair", "cut 2 pairs"}) {
            EXPECT_NE(file.find(note), std::string::npos) << note;
        }
    }
    for (const std::string& file :
         {writeSvg(test::sewingDrawing()), writePlainDxf(test::sewingDrawing())}) {
        EXPECT_EQ(file.find("cut 1"), std::string::npos);
    }
}

TEST(Draw, HasACheckSquareOfAHundredMillimetresWithItsTextInside) {
    for (const Drawing& drawing : {test::sewingDrawing(), draw(Pattern{}, Marker{})}) {
        const DrawnPath& square = drawing.paths.back();
        EXPECT_EQ(square.id, "check-square");
        EXPECT_EQ(square.layer, LayerKind::Check);
        EXPECT_EQ(test::edgeLengths(square.points), Eigen::VectorXd::Constant(4, 100));
        const DrawnText& text = drawing.texts.back();
        EXPECT_EQ(text.lines, std::vector<std::string>{"check square 100 mm x 100 mm"});
        const Box inner = boxOf(text), outer = boxOf(square);
        EXPECT_GT((inner.low - outer.low).minCoeff(), 5);
        EXPECT_GT((outer.high - inner.high).minCoeff(), 5);
    }
}

TEST(Draw, TakesAPatternWithoutPieces) {
    const Drawing drawing = draw(Pattern{}, placeCopies(Pattern{}));
    EXPECT_EQ(drawing.width, 120);
    EXPECT_EQ(drawing.height, 120);
    EXPECT_EQ(drawing.paths.size(), 1u);
    EXPECT_FALSE(drawing.title.empty());
}

TEST(Draw, KeepsTextsOnThePageAtAnyScale) {
    for (const double scale : {1e-7, 1e-3, 1.0, 1e4}) {
        Pattern pattern = test::sewingPattern();
        for (PatternPiece& piece : pattern.pieces) {
            piece.outline *= scale;
        }
        const Drawing drawing = draw(pattern, placeCopies(pattern));
        if (scale >= 1) {  // pieces below 1 cm2 have no label
            EXPECT_GE(drawing.texts.size(), pattern.pieces.size());
        }
        for (const DrawnText& text : drawing.texts) {
            expectOnPage(boxOf(text), drawing, 0);
        }
    }
}

}  // namespace
}  // namespace toile
