// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/pdf/sheets.h"

#include <gtest/gtest.h>

#include "core/formats/drawing/sheet_drawing.h"
#include "core/formats/pdf/pdf_writer.h"
#include "tests/core/formats/export_fixtures.h"

namespace toile {
namespace {

/// Counts what is begun and ended, and keeps the squares.
class CountingCanvas : public SheetCanvas {
public:
    void save() override { ++saved; }
    void restore() override { EXPECT_GE(--saved, 0); }
    void transform(double a, double b, double c, double d, const Eigen::Vector2d&) override {
        EXPECT_EQ(a * d - b * c, 1);  // true scale, never mirrored
    }
    void clip(const Eigen::AlignedBox2d& box) override { clipped = box; }
    void drawing() override {
        ++drawings;
        EXPECT_FALSE(clipped.isEmpty());
    }
    void beginLayer(int) override { ++begun; }
    void beginItem(std::string_view id, std::string_view) override {
        ++begun;
        items.emplace_back(id);
    }
    void end() override { EXPECT_GE(--begun, 0); }
    void setGrey(double grey) override { EXPECT_TRUE(grey >= 0 && grey <= 1); }
    void setWidth(double width) override { EXPECT_GT(width, 0); }
    void setDashes(double, double) override {}
    void setRoundEnds() override {}
    void line(const Points2& points, bool) override { EXPECT_GT(points.rows(), 0); }
    void curves(const std::vector<CubicCurve>& curves, bool) override {
        EXPECT_FALSE(curves.empty());
    }
    void box(const Eigen::AlignedBox2d& box) override { boxes.push_back(box); }
    void segment(const Eigen::Vector2d&, const Eigen::Vector2d&) override {}
    double text(std::string_view text, const Eigen::Vector2d&, double height, TextStart, double,
                double) override {
        said += std::string(text) + '|';
        return static_cast<double>(text.size()) * height;
    }

    int saved = 0, begun = 0, drawings = 0;
    Eigen::AlignedBox2d clipped;
    std::string said;
    std::vector<std::string> items;
    std::vector<Eigen::AlignedBox2d> boxes;
};

class Sheets : public testing::TestWithParam<Paper> {};

TEST_P(Sheets, EndWhatTheyBeginAndShowTheDrawingOnce) {
    const Drawing drawing = test::sewingDrawing();
    const auto plan = planPdf(drawing, {GetParam(), 10});
    ASSERT_TRUE(plan);
    for (std::size_t sheet = 0; sheet < sheetCount(*plan); ++sheet) {
        CountingCanvas canvas;
        drawSheet(canvas, drawing, *plan, sheet, GetParam() == Paper::Projector);
        EXPECT_EQ(canvas.saved, 0);
        EXPECT_EQ(canvas.begun, 0);
        const bool isCover = plan->isTiled && sheet == 0;
        EXPECT_EQ(canvas.drawings, isCover ? 0 : 1);
        EXPECT_TRUE(
            (sheetPaper(*plan, sheet) - (isCover ? plan->coverPaper : plan->paper)).isZero());
    }
}

TEST_P(Sheets, HaveBothSquaresOnce) {
    const Drawing drawing = test::sewingDrawing();
    const auto plan = planPdf(drawing, {GetParam(), 10});
    ASSERT_TRUE(plan);
    std::vector<double> sides;
    for (std::size_t sheet = 0; sheet < sheetCount(*plan); ++sheet) {
        CountingCanvas canvas;
        drawSheet(canvas, drawing, *plan, sheet);
        if (!canvas.items.empty()) {
            ASSERT_EQ(canvas.items, (std::vector<std::string>{"square-50-mm", "square-1-in"}));
            sides.push_back(canvas.boxes[0].sizes().x());
            sides.push_back(canvas.boxes[1].sizes().x());
        }
    }
    ASSERT_EQ(sides.size(), 2U);
    EXPECT_NEAR(sides[0], kMetricSquare, 1e-9);
    EXPECT_NEAR(sides[1], kInchSquare, 1e-9);
}

TEST(SheetTexts, AreInTheWordsOfTheDrawing) {
    Drawing drawing = test::sewingDrawing();
    drawing.words.pages = "Teile: %1, Seiten: %2";
    drawing.words.page = "von %2 die %1.";
    drawing.words.printing = "Auf 100 %\nstellen";
    const auto plan = planPdf(drawing, {Paper::A4, 10});
    ASSERT_TRUE(plan);
    CountingCanvas cover, tile;
    drawSheet(cover, drawing, *plan, 0);
    drawSheet(tile, drawing, *plan, 1);
    const std::string pages = std::to_string(plan->pages.size());
    const std::string all = std::to_string(plan->pages.size() + 1);
    const std::string pieces = std::to_string(drawing.blocks.size());
    EXPECT_NE(cover.said.find("|Teile: |" + pieces + "|, Seiten: |" + pages + "|"),
              std::string::npos)
        << cover.said;
    EXPECT_NE(cover.said.find("|Auf 100 %|stellen||Cut along"), std::string::npos) << cover.said;
    EXPECT_NE(cover.said.find("|von |" + all + "| die |1|.|"), std::string::npos) << cover.said;
    EXPECT_NE(tile.said.find("|von |" + all + "| die |2|.|"), std::string::npos) << tile.said;
}

INSTANTIATE_TEST_SUITE_P(Papers, Sheets,
                         testing::Values(Paper::A4, Paper::Letter, Paper::Shared, Paper::A0,
                                         Paper::ArchD, Paper::ArchE, Paper::Roll610, Paper::Roll841,
                                         Paper::Roll914, Paper::Projector));

TEST(DrawPattern, DrawsEveryLineOfItsLayersOnce) {
    const Pattern pattern = test::sewingPattern();
    const Drawing drawing = draw(pattern, placeCopies(pattern));
    CountingCanvas canvas;
    drawPattern(canvas, drawing, pattern, {LayerKind::Sew, LayerKind::Cut});
    std::vector<std::string> wanted;
    for (const LayerKind layer : {LayerKind::Sew, LayerKind::Cut}) {
        for (const DrawnPath& path : drawing.paths) {
            if (path.layer == layer) {
                wanted.push_back(path.id);
            }
        }
    }
    EXPECT_EQ(canvas.items, wanted);
    EXPECT_EQ(canvas.saved, 0);
    EXPECT_EQ(canvas.begun, 0);
}

}  // namespace
}  // namespace toile
