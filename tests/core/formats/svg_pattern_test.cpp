// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include <gtest/gtest.h>

#include "core/base/file.h"
#include "core/formats/read_pattern.h"
#include "core/formats/tables/pattern_match.h"
#include "core/formats/writers.h"
#include "core/geometry/polygon.h"
#include "tests/core/formats/export_fixtures.h"
#include "tests/core/support/shared_data.h"

namespace toile {
namespace {

TEST(SvgPattern, ReadsOurOwnFilesByTheirPieces) {
    const Pattern pattern = test::sewingPattern();
    const Drawing drawing = draw(pattern, placeCopies(pattern));
    for (const SvgGroups groups : {SvgGroups::Kind, SvgGroups::Piece}) {
        SvgOptions options;
        options.groups = groups;
        const auto file = readSvgPattern(writeSvg(drawing, options));
        ASSERT_TRUE(file) << sentence(file.error());
        ASSERT_EQ(file->pieces.size(), drawing.blocks.size());
        const PatternMatch match = matchPatterns(pattern, *file);
        ASSERT_EQ(match.pairs.size(), file->pieces.size());
        for (const PieceMatch& pair : match.pairs) {
            EXPECT_EQ(pair.by, MatchedBy::Id);
            EXPECT_LT(pair.lines.front().fit.farthest, 0.02);
        }
    }
}

TEST(SvgPattern, TakesOuterLinesForPieces) {
    const std::string page =
        "<svg xmlns='http://www.w3.org/2000/svg' width='500mm' height='300mm' "
        "viewBox='0 0 500 300'>"
        "<path d='M10,10 H210 V110 H10 Z M50,50 H70 V90 H50 Z'/>"
        "<path id='sleeve' d='M250,10 L400,10 L400,200 L250,10'/>"
        "<path d='M10,10 H210 V110 H10 Z'/><path d='M0,200 H100'/></svg>";
    const auto file = readSvgPattern(page);
    ASSERT_TRUE(file);
    EXPECT_FALSE(file->unitInDoubt);
    ASSERT_EQ(file->pieces.size(), 2U);
    EXPECT_EQ(file->pieces[0].holes.size(), 1U);
    EXPECT_NEAR(geometry::perimeterOf(file->pieces[0].cut), 600, 1e-6);
    EXPECT_EQ(file->pieces[1].name, "sleeve");
    EXPECT_EQ(file->pieces[1].cut.rows(), 3);
    EXPECT_GT(geometry::signedAreaOf(file->pieces[1].cut), 0);
    const auto none = readSvgPattern("<svg xmlns='http://www.w3.org/2000/svg'/>");
    ASSERT_FALSE(none);
    EXPECT_EQ(none.error().code, ErrorCode::NoGeometry);
    EXPECT_NE(none.error().detail.pattern(), nullptr);  // in other languages too
}

TEST(SvgPattern, TakesLabelsAndTitlesForNames) {
    const auto file = readSvgPattern(
        "<svg xmlns='http://www.w3.org/2000/svg' xmlns:inkscape='i' width='500mm' height='300mm' "
        "viewBox='0 0 500 300'><title>a skirt</title>"
        "<g inkscape:groupmode='layer' inkscape:label='Layer 1'>"
        "<path id='path7' inkscape:label='Front' d='M0,0 H200 V200 H0 Z'/>"
        "<path id='path8' d='M210,0 H300 V200 H210 Z'><title>Back</title></path>"
        "<g inkscape:label='Collar'><path id='path9' d='M310,0 H350 V200 H310 Z'/></g>"
        "<g inkscape:label='Pockets'><path id='left' d='M400,0 H430 V90 H400 Z'/>"
        "<path id='right' d='M440,0 H470 V80 H440 Z'/></g>"
        "<path id='path10' d='M360,0 H390 V200 H360 Z'/></g></svg>");
    ASSERT_TRUE(file);
    std::vector<std::string> names;
    for (const FilePiece& piece : file->pieces) {
        names.push_back(piece.name);
    }
    EXPECT_EQ(names,
              (std::vector<std::string>{"Front", "Back", "Collar", "path10", "left", "right"}));
    EXPECT_EQ(file->pieces.front().id, "path7");
}

TEST(SvgPattern, ReadsTheFilesOfOtherPrograms) {
    const struct {
        const char* name;
        std::size_t pieces, seamLines;
    } files[] = {// Cutting lines with their seam lines; two patches have one in common.
                 {"patterns/wetsuit_patches.svg", 49, 49},
                 {"garments/tee_sim.pattern.svg", 6, 0}};
    for (const auto& [name, pieces, seamLines] : files) {
        const auto path = test::dataFile(name);
        TOILE_NEEDS_SHARED(path);
        const auto file = readSvgPattern(*readFile(path));
        ASSERT_TRUE(file);
        EXPECT_EQ(file->pieces.size(), pieces) << name;
        EXPECT_EQ(static_cast<std::size_t>(std::ranges::count_if(
                      file->pieces, [](const FilePiece& piece) { return piece.sew.rows() > 0; })),
                  seamLines);
    }
}

}  // namespace
}  // namespace toile
