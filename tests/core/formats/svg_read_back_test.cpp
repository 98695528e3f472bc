// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <cmath>
#include <set>
#include <string>

#include <gtest/gtest.h>
#include <pugixml.hpp>

#include "core/formats/drawing/text_outlines.h"
#include "core/formats/read_backs.h"
#include "core/formats/writers.h"
#include "tests/core/formats/export_fixtures.h"

namespace toile {
namespace {

constexpr SvgPreset kSvgPresets[] = {SvgPreset::Inkscape, SvgPreset::Illustrator,
                                     SvgPreset::Silhouette, SvgPreset::Laser, SvgPreset::Cricut};

/// Every choice.
std::vector<SvgOptions> svgChoices() {
    std::vector<SvgOptions> all;
    for (const SvgPreset preset : kSvgPresets) {
        for (const SvgGroups groups : {SvgGroups::Kind, SvgGroups::Piece}) {
            for (const bool textAsPaths : {false, true}) {
                all.push_back({preset, groups, textAsPaths});
            }
        }
    }
    return all;
}

/// The pieces of `sewingDrawing` with a seam between the first two and a free edge, a turned text
/// and an open line.
Drawing seamDrawing() {
    Drawing drawing = test::sewingDrawing();
    const auto side = [&drawing](std::size_t path, const char* id, const char* pair) {
        const Points2& line = drawing.paths[path].points;
        const double length = (line.row(1) - line.row(0)).norm();
        drawing.edges.push_back({.id = id,
                                 .pair = pair,
                                 .seam = "Seite <1> & 2",
                                 .number = 1,
                                 .path = static_cast<int>(path),
                                 .from = 0,
                                 .to = length,
                                 .points = line.topRows(2),
                                 .length3d = length + 0.125});
    };
    const DrawnBlock &first = drawing.blocks[0], &second = drawing.blocks[1];
    side(first.path, "edge-a", "edge-b");
    drawing.blocks[0].edgeCount = 1;
    side(second.path, "edge-b", "edge-a");
    side(second.path, "edge-c", "");
    drawing.edges.back().number = 2;
    drawing.blocks[1].edge = 1;
    drawing.blocks[1].edgeCount = 2;
    for (std::size_t k = 2; k < drawing.blocks.size(); ++k) {
        drawing.blocks[k].edge = 3;
    }
    drawing.texts[0].angle = 0.5;
    drawing.paths.push_back(
        {"page-line", LayerKind::Marks, drawing.paths[0].points.topRows(3), false});
    return drawing;
}

std::string nameOf(const SvgOptions& options) {
    return "preset " + std::to_string(static_cast<int>(options.preset)) + ", groups " +
           std::to_string(static_cast<int>(options.groups)) +
           (options.textAsPaths ? ", text as paths" : "");
}

TEST(SvgReadBack, EveryChoiceIsReadAsItWasMeant) {
    const Drawing drawing = seamDrawing();
    for (const SvgOptions& options : svgChoices()) {
        const auto found = readBackSvg(writeSvg(drawing, options), drawing, options);
        ASSERT_TRUE(found) << nameOf(options) << ": " << sentence(found.error());
        EXPECT_EQ(found->pieces, static_cast<int>(drawing.blocks.size()));
        EXPECT_EQ(found->seams, 3);
        EXPECT_LT(found->largest, 3e-4) << nameOf(options);
    }
}

TEST(SvgReadBack, EveryChoiceSaysTheSameSizeAndLines) {
    const Drawing drawing = seamDrawing();
    for (const SvgOptions& options : svgChoices()) {
        const auto svg = readSvg(writeSvg(drawing, options));
        ASSERT_TRUE(svg);
        EXPECT_NEAR(svg->width, drawing.width, 1e-3);
        EXPECT_NEAR(svg->height, drawing.height, 1e-3);
        const auto square = std::ranges::find(svg->lines, "check-square", &SvgLine::id);
        ASSERT_NE(square, svg->lines.end());
        EXPECT_LT((test::edgeLengths(square->points).array() - 100).abs().maxCoeff(), 2e-4)
            << nameOf(options);
        EXPECT_EQ(square->layer, "check");
        EXPECT_EQ(square->piece, "");
    }
}

/// What reading says of a file in which one text is another.
Result<ReadBack> readWith(const Drawing& drawing, const SvgOptions& options,
                          const std::string& what, const std::string& instead) {
    std::string bytes = writeSvg(drawing, options);
    const std::size_t at = bytes.find(what);
    EXPECT_NE(at, std::string::npos) << what;
    return readBackSvg(bytes.replace(std::min(at, bytes.size()), what.size(), instead), drawing,
                       options);
}

TEST(SvgReadBack, EveryDifferenceIsFound) {
    const Drawing drawing = seamDrawing();
    constexpr std::array<std::pair<const char*, const char*>, 9> kDamages{
        {{"width=\"", "width=\"1"},
         {" Z\"", "\""},
         {"M ", "M 1"},
         {"inkscape:label=\"cut\"", "inkscape:label=\"sew\""},
         {"id=\"check-square\"", "id=\"other\""},
         {"data-pair=\"edge-b\"", ""},
         {"data-length-3d=\"", "data-length-3d=\"9"},
         {"data-seam=\"Seite", "data-seam=\"Saum"},
         {"</svg>", ""}}};
    for (const SvgGroups groups : {SvgGroups::Kind, SvgGroups::Piece}) {
        const SvgOptions options{.groups = groups};
        EXPECT_TRUE(readWith(drawing, options, "<desc>", "<desc>1"));
        for (const auto& [what, instead] : kDamages) {
            const auto found = readWith(drawing, options, what, instead);
            ASSERT_FALSE(found) << what;
            EXPECT_EQ(found.error().code, ErrorCode::NotReadBack);
        }
    }
}

TEST(SvgReadBack, MachinesGetNoLineThatIsNotSeen) {
    const Drawing drawing = seamDrawing();
    for (const SvgOptions& options : svgChoices()) {
        const auto svg = readSvg(writeSvg(drawing, options));
        ASSERT_TRUE(svg);
        const auto hidden = std::ranges::count_if(svg->lines, [](const SvgLine& line) {
            return line.stroke == "none" && (line.fill == "none" || line.fill.empty());
        });
        const bool isDrawn =
            options.preset == SvgPreset::Inkscape || options.preset == SvgPreset::Illustrator;
        EXPECT_EQ(hidden, isDrawn ? 3 : 0) << nameOf(options);
    }
}

TEST(SvgReadBack, GroupsAreThePiecesInTheOrderOfTheDrawing) {
    const Drawing drawing = seamDrawing();
    pugi::xml_document document;
    document.load_string(writeSvg(drawing, {.groups = SvgGroups::Piece}).c_str());
    std::vector<std::string> groups, blocks;
    std::set<std::string> ids;
    for (const pugi::xml_node group : document.child("svg").children("g")) {
        if (group.attribute("data-piece")) {
            groups.emplace_back(group.attribute("id").value());
        }
    }
    for (const DrawnBlock& block : drawing.blocks) {
        blocks.push_back(block.id);
    }
    EXPECT_EQ(groups, blocks);
    EXPECT_STREQ(document.child("svg").child("g").attribute("inkscape:label").value(),
                 "Ärmel <links> & \"rechts\"");
    for (const auto& found : document.select_nodes("//@id")) {
        EXPECT_TRUE(ids.insert(found.attribute().value()).second) << found.attribute().value();
    }
}

TEST(SvgReadBack, PiecesAreNamedAlikeInBothKindsOfGroups) {
    const Drawing drawing = seamDrawing();
    std::array<std::set<std::pair<std::string, std::string>>, 2> pieces;
    for (const SvgGroups groups : {SvgGroups::Kind, SvgGroups::Piece}) {
        const auto svg = readSvg(writeSvg(drawing, {.groups = groups}));
        ASSERT_TRUE(svg);
        for (const SvgLine& line : svg->lines) {
            if (!line.seam) {
                pieces[static_cast<std::size_t>(groups)].emplace(line.id, line.piece);
            }
        }
    }
    EXPECT_EQ(pieces[0], pieces[1]);
}

TEST(SvgReadBack, LettersAsPathsStandWhereTheTextDoes) {
    if (textOutlines("H", 1).contours.empty()) {
        GTEST_SKIP() << "No font, such as that of fonts-dejavu-core";
    }
    const Drawing drawing = seamDrawing();
    const auto svg = readSvg(writeSvg(drawing, {.textAsPaths = true}));
    ASSERT_TRUE(svg);
    for (const DrawnText& text : drawing.texts) {
        Eigen::AlignedBox2d box;
        for (const SvgLine& line : svg->lines) {
            if (line.id == text.id) {
                EXPECT_EQ(line.text.substr(0, text.lines.front().size()), text.lines.front());
                EXPECT_TRUE(line.closed);
                for (Eigen::Index k = 0; k < line.points.rows(); ++k) {
                    box.extend(line.points.row(k).transpose());
                }
            }
        }
        ASSERT_FALSE(box.isEmpty()) << text.id;
        EXPECT_TRUE(box.contains(text.position)) << text.id;
    }
}

TEST(SvgReadBack, LaserCutsLastAndInColoursOfItsPalette) {
    pugi::xml_document document;
    document.load_string(writeSvg(seamDrawing(), {.preset = SvgPreset::Laser}).c_str());
    const std::set<std::string> palette{"#000000", "#0000ff", "#ff0000", "#00e000",
                                        "#ff8000", "#00e0e0", "#ff00ff", "#0000a0"};
    std::set<std::string> used;
    pugi::xml_node last;
    for (const pugi::xml_node layer : document.child("svg").children("g")) {
        const std::string colour = layer.attribute("stroke").value();
        EXPECT_TRUE(palette.contains(colour)) << colour;
        EXPECT_TRUE(used.insert(colour).second) << "one operation each: " << colour;
        EXPECT_LE(layer.attribute("stroke-width").as_double(), 0.0254);
        last = layer;
    }
    EXPECT_STREQ(last.attribute("inkscape:label").value(), "cut");
}

}  // namespace
}  // namespace toile
