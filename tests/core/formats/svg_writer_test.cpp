// SPDX-License-Identifier: GPL-3.0-or-later
#include <charconv>
#include <map>
#include <set>
#include <sstream>

#include <gtest/gtest.h>
#include <pugixml.hpp>

#include "core/formats/writers.h"
#include "tests/core/formats/export_fixtures.h"

namespace toile {
namespace {

constexpr double kSvgWritten = 2e-4;  // what 4 decimals can change in a length, mm

double svgNumber(const std::string& text) {
    double value = 0;
    const auto end = std::from_chars(text.data(), text.data() + text.size(), value);
    EXPECT_EQ(end.ptr, text.data() + text.size()) << text;
    return value;
}

/// Points of a path of the form "M x,y L x,y x,y ... Z".
Points2 parsePath(const std::string& data) {
    std::istringstream in(data);
    std::vector<Eigen::RowVector2d> points;
    std::string word, last;
    while (in >> word) {
        last = word;
        if (word == "M" || word == "L" || word == "Z") {
            continue;
        }
        const std::size_t comma = word.find(',');
        EXPECT_EQ(word.size() - word.find('.', comma), 5u) << "4 decimals: " << word;
        points.emplace_back(svgNumber(word.substr(0, comma)), svgNumber(word.substr(comma + 1)));
    }
    EXPECT_EQ(data.substr(0, 2), "M ");
    EXPECT_EQ(last, "Z");
    Points2 result(static_cast<Eigen::Index>(points.size()), 2);
    for (std::size_t i = 0; i < points.size(); ++i) {
        result.row(static_cast<Eigen::Index>(i)) = points[i];
    }
    return result;
}

struct SvgFile {
    explicit SvgFile(const Drawing& drawing) : bytes(writeSvg(drawing)) {
        EXPECT_TRUE(document.load_string(bytes.c_str(), pugi::parse_full | pugi::parse_ws_pcdata));
        svg = document.child("svg");
        for (const auto& found : document.select_nodes("//path")) {
            paths[found.node().attribute("id").value()] =
                parsePath(found.node().attribute("d").value());
        }
    }

    std::string attribute(const char* name) const { return svg.attribute(name).value(); }

    std::string bytes;
    pugi::xml_document document;
    pugi::xml_node svg;
    std::map<std::string, Points2> paths;
};

TEST(WriteSvg, KeepsEveryEdgeLengthToTheWrittenPrecision) {
    const Pattern pattern = test::sewingPattern();
    const SvgFile file(draw(pattern, placeCopies(pattern)));
    ASSERT_EQ(file.paths.size(), pattern.pieces.size() + 1);
    for (const PatternPiece& piece : pattern.pieces) {
        const Points2& written = file.paths.at("piece-" + piece.slug + "-cut");
        ASSERT_EQ(written.rows(), piece.outline.rows());
        const Eigen::VectorXd error = test::edgeLengths(written) - test::edgeLengths(piece.outline);
        EXPECT_LT(error.cwiseAbs().maxCoeff(), kSvgWritten) << piece.slug;
    }
    EXPECT_EQ(test::edgeLengths(file.paths.at("check-square")), Eigen::VectorXd::Constant(4, 100));
}

TEST(WriteSvg, IsUprightAndNotMirrored) {
    const Drawing drawing = test::sewingDrawing();
    const SvgFile file(drawing);
    for (const DrawnPath& path : drawing.paths) {
        Points2 expected = path.points;
        expected.col(1) = drawing.height - expected.col(1).array();
        EXPECT_LT((file.paths.at(path.id) - expected).cwiseAbs().maxCoeff(), 1e-4) << path.id;
    }
}

TEST(WriteSvg, SaysItsSizeInMillimetresAndInUserUnitsAlike) {
    const Drawing drawing = test::sewingDrawing();
    const SvgFile file(drawing);
    const std::string width = file.attribute("width"), height = file.attribute("height");
    ASSERT_TRUE(width.ends_with("mm") && height.ends_with("mm"));
    EXPECT_EQ(file.attribute("viewBox"), "0 0 " + width.substr(0, width.size() - 2) + " " +
                                             height.substr(0, height.size() - 2));
    EXPECT_EQ(svgNumber(width.substr(0, width.size() - 2)), drawing.width);
    for (const auto& [id, points] : file.paths) {
        EXPECT_GE(points.minCoeff(), 10 - 1e-4) << id;
        EXPECT_LE(points.col(0).maxCoeff(), drawing.width - 10 + 1e-4) << id;
        EXPECT_LE(points.col(1).maxCoeff(), drawing.height - 10 + 1e-4) << id;
    }
}

TEST(WriteSvg, HasNoTransformsNoClipsAndUniqueIds) {
    const SvgFile file(test::sewingDrawing());
    EXPECT_TRUE(file.document.select_nodes("//@transform").empty());
    EXPECT_TRUE(file.document.select_nodes("//clipPath").empty());
    std::set<std::string> ids;
    for (const auto& found : file.document.select_nodes("//@id")) {
        EXPECT_TRUE(ids.insert(found.attribute().value()).second) << found.attribute().value();
    }
    EXPECT_TRUE(ids.contains("piece-aermel-cut") && ids.contains("piece-aermel-name"));
    EXPECT_TRUE(ids.contains("check-square"));
}

TEST(WriteSvg, PutsEachKindOnItsColouredLayer) {
    const SvgFile file(test::sewingDrawing());
    std::map<std::string, std::string> colours;
    for (const pugi::xml_node layer : file.svg.children("g")) {
        EXPECT_STREQ(layer.attribute("inkscape:groupmode").value(), "layer");
        const std::string label = layer.attribute("inkscape:label").value();
        EXPECT_EQ(layer.attribute("id").value(), "layer-" + label);
        EXPECT_STREQ(layer.attribute("fill").value(), "none");
        colours[layer.attribute("stroke").value()] = label;
    }
    EXPECT_EQ(colours.size(), 4u) << "a colour for each";
    const auto layerOf = [&](const char* id) {
        const std::string query = std::string("//*[@id='") + id + "']";
        return std::string(
            file.document.select_node(query.c_str()).node().parent().attribute("id").value());
    };
    EXPECT_EQ(layerOf("piece-neckband-cut"), "layer-cut");
    EXPECT_EQ(layerOf("piece-neckband-name"), "layer-text");
    EXPECT_EQ(layerOf("check-square"), "layer-check");
}

TEST(WriteSvg, KeepsNamesOfAnyScript) {
    const SvgFile file(test::sewingDrawing());
    EXPECT_STREQ(file.svg.child("title").text().get(), "Größe <38> & \"Probe\"");
    std::vector<std::string> lines;
    for (const pugi::xml_node text : file.svg.find_child_by_attribute("id", "layer-text")) {
        for (const pugi::xml_node child : text) {
            EXPECT_STREQ(child.name(), "tspan") << "blanks between lines would be drawn";
            lines.emplace_back(child.text().get());
        }
    }
    ASSERT_EQ(lines.size(), 8u);
    EXPECT_EQ(lines[0], "Ärmel <links> & \"rechts\"");
    EXPECT_EQ(lines[2], "前身頃");
    EXPECT_EQ(lines[3], "seam line, no allowance");
}

TEST(WriteSvg, StaysWellFormedWithNamesThatAreNoText) {
    Drawing drawing = draw(Pattern{}, Marker{});
    drawing.title = "a\x01\xFF]]>";
    drawing.texts[0].lines = {"\x1B\xC3", "--><tspan>"};
    const SvgFile file(drawing);
    EXPECT_EQ(file.bytes.find('\x01'), std::string::npos);
    EXPECT_EQ(file.bytes.find("&#"), std::string::npos);
    EXPECT_STREQ(file.svg.child("title").text().get(), "a \xEF\xBF\xBD]]>");
}

TEST(WriteSvg, GivesTheSameBytesTwiceAndInAnyLocale) {
    const std::string bytes = writeSvg(test::sewingDrawing());
    EXPECT_EQ(bytes, writeSvg(test::sewingDrawing()));
    const test::CommaLocale comma;
    EXPECT_EQ(bytes, writeSvg(test::sewingDrawing()));
}

TEST(WriteSvg, DrawsOnlyTheCheckSquareOfAnEmptyPattern) {
    const SvgFile file(draw(Pattern{}, Marker{}));
    EXPECT_EQ(file.paths.size(), 1u);
    EXPECT_EQ(file.attribute("viewBox"), "0 0 120 120");
}

}  // namespace
}  // namespace toile
