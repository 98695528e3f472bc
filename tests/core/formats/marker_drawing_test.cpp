// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/drawing/marker_drawing.h"

#include <algorithm>
#include <set>

#include <gtest/gtest.h>

#include "core/formats/pdf/pdf_writer.h"
#include "core/formats/writers.h"
#include "tests/core/marker/marker_fixtures.h"
#include "tests/core/readers/pdf_read_back.h"
#include "tests/core/readers/plt_read_back.h"

namespace toile {
namespace {

Pattern drawnCloth() {
    Pattern pattern = test::clothPattern({test::clothPiece("back", 300, 500, 1)});
    pattern.pieces[0].quantity = 2;
    pattern.pieces[0].mirroredPair = true;
    return pattern;
}

TEST(DrawMarker, EachLineAndTextHasAnIdOfItsOwn) {
    const Pattern pattern = drawnCloth();
    const ClothMarker marker = test::laidOn(1000, pattern);
    const DrawnMarker drawn = drawMarker(pattern, marker, {}, {clothSentence(marker)});
    std::set<std::string> ids;
    for (const DrawnPath& path : drawn.drawing.paths) {
        EXPECT_TRUE(ids.insert(path.id).second) << path.id;
    }
    for (const DrawnText& text : drawn.drawing.texts) {
        EXPECT_TRUE(ids.insert(text.id).second) << text.id;
    }
    EXPECT_TRUE(ids.contains("piece-back-cut") && ids.contains("piece-back-copy-4-cut"));
    EXPECT_TRUE(ids.contains("cloth-1") && ids.contains("cloth-text"));
    EXPECT_EQ(drawn.drawing.blocks.size(), 4U);
}

TEST(DrawMarker, LabelsSayNothingOfCopiesThatLieThere) {
    const Pattern pattern = drawnCloth();
    const ClothMarker marker = test::laidOn(1000, pattern);
    for (const DrawnText& text : drawMarker(pattern, marker, {}, {}).drawing.texts) {
        for (const std::string& line : text.lines) {
            EXPECT_EQ(line.find("pairs"), std::string::npos);
            EXPECT_EQ(line.find("wrong side"), std::string::npos);
        }
    }
}

TEST(DrawMarker, CopiesLieAsTheMarkerSays) {
    const Pattern pattern = drawnCloth();
    const ClothMarker marker = test::laidOn(1000, pattern);
    const DrawnMarker drawn = drawMarker(pattern, marker, {}, {});
    for (std::size_t k = 0; k < marker.copies.size(); ++k) {
        const DrawnPath& path = drawn.drawing.paths[drawn.drawing.blocks[k].path];
        const Points2 line = laidOutline(pattern, marker.copies[k]).array() + kDrawingMargin;
        EXPECT_LT((path.points.colwise().minCoeff() - line.colwise().minCoeff()).norm(), 1e-9);
        EXPECT_LT((path.points.colwise().maxCoeff() - line.colwise().maxCoeff()).norm(), 1e-9);
    }
}

TEST(DrawMarker, IsReadBackFromPlotsAndPages) {
    const Pattern pattern = drawnCloth();
    const Drawing drawing = drawMarker(pattern, test::laidOn(1000, pattern), {}, {}).drawing;
    for (const bool turned : {false, true}) {
        const auto plot = readBackPlt(writePlt(drawing, {turned}), drawing, {turned});
        ASSERT_TRUE(plot) << sentence(plot.error());
        EXPECT_EQ(plot->pieces, 4);
    }
    for (const Paper paper : {Paper::A4, Paper::A0, Paper::Roll914}) {
        const auto bytes = writePdf(drawing, pattern, {paper, 10});
        ASSERT_TRUE(bytes) << sentence(bytes.error());
        const auto pages = readBackPdf(*bytes, drawing, {paper, 10});
        ASSERT_TRUE(pages) << sentence(pages.error());
        EXPECT_EQ(pages->pieces, 4);
    }
}

TEST(DrawMarker, GoesIntoFormatsThatHoldAPage) {
    EXPECT_TRUE(holdsMarkers("m.svg") && holdsMarkers("m.DXF") && holdsMarkers("m.pdf") &&
                holdsMarkers("m.plt"));
    EXPECT_FALSE(holdsMarkers("m.obj") || holdsMarkers("m.json") || holdsMarkers("m.csv") ||
                 holdsMarkers("m"));
}

TEST(DrawMarker, TwoCopiesOfAPieceAreNoTwoSidesOfASeam) {
    Pattern pattern = test::clothPattern({test::clothPiece("back", 300, 500, 1)});
    pattern.pieces[0].quantity = 2;
    SeamLine seam;
    seam.number = 1;
    seam.from = 0;
    seam.to = 300;
    seam.line.resize(2, 2);
    seam.line << 0, 0, 300, 0;
    pattern.pieces[0].seams = {seam};
    const Drawing drawing = drawMarker(pattern, test::laidOn(1000, pattern), {}, {}).drawing;
    ASSERT_EQ(drawing.edges.size(), 2U);
    EXPECT_TRUE(drawing.edges[0].pair.empty() && drawing.edges[1].pair.empty());
}

TEST(DrawMarker, TheReportSaysMirroredOfWhatLiesThatWay) {
    const auto pattern = std::make_shared<const Pattern>(drawnCloth());
    ClothMarker marker;
    LaidCopy copy;
    copy.placement.mirrored = true;
    marker.copies = {copy};
    const std::string report = writeMarkers({{pattern, {}, marker}}, std::nullopt);
    EXPECT_NE(report.find("\"mirrored\": true"), std::string::npos) << report;
}

}  // namespace
}  // namespace toile
