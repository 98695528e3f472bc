// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstdio>
#include <memory>
#include <sstream>
#include <string>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "core/formats/writers.h"
#include "tests/core/formats/export_fixtures.h"
#include "tests/core/support/temporary_folder.h"

namespace toile {
namespace {

/// What a command prints; empty where it fails.
std::string printedByClient(const std::string& command) {
    struct Close {
        void operator()(std::FILE* pipe) const { pclose(pipe); }
    };
    const std::unique_ptr<std::FILE, Close> pipe(popen((command + " 2>/dev/null").c_str(), "r"));
    std::string text;
    for (int c = 0; pipe && (c = std::fgetc(pipe.get())) != EOF;) {
        text += static_cast<char>(c);
    }
    return text;
}

bool hasClient(const std::string& program) {
    return !printedByClient("command -v " + program).empty();
}

constexpr double kPointSize = 25.4 / 72, kPixelOfScreen = 25.4 / 96;  // mm
constexpr SvgPreset kTrueSizePresets[] = {SvgPreset::Inkscape, SvgPreset::Illustrator,
                                          SvgPreset::Silhouette, SvgPreset::Laser,
                                          SvgPreset::Cricut};

TEST(DrawingClients, RsvgGivesEverySvgItsTrueSize) {
    if (!hasClient("rsvg-convert")) {
        GTEST_SKIP() << "rsvg-convert is not installed";
    }
    const Drawing drawing = test::sewingDrawing();
    const test::TemporaryFolder folder;
    for (const SvgPreset preset : kTrueSizePresets) {
        const auto file = folder.write("drawing.svg", writeSvg(drawing, {.preset = preset}));
        const std::string pdf = printedByClient("rsvg-convert -f pdf '" + file.string() + "'");
        const std::size_t box = pdf.find("/MediaBox");
        ASSERT_NE(box, std::string::npos);
        std::istringstream numbers(pdf.substr(pdf.find('[', box) + 1, 80));
        double left = 0, bottom = 0, width = 0, height = 0;
        numbers >> left >> bottom >> width >> height;
        EXPECT_NEAR(width * kPointSize, drawing.width, 0.01);
        EXPECT_NEAR(height * kPointSize, drawing.height, 0.01);
    }
}

TEST(DrawingClients, InkscapeMeasuresTheCheckSquare) {
    if (!hasClient("inkscape")) {
        GTEST_SKIP() << "inkscape is not installed";
    }
    const test::TemporaryFolder folder;
    for (const SvgPreset preset : kTrueSizePresets) {
        const auto file =
            folder.write("drawing.svg", writeSvg(test::sewingDrawing(), {.preset = preset}));
        const std::string found = printedByClient("inkscape --query-all '" + file.string() + "'");
        const std::size_t at = found.find("check-square,");
        ASSERT_NE(at, std::string::npos);
        std::string line = found.substr(at, found.find('\n', at) - at);
        for (char& c : line) {
            c = c == ',' ? ' ' : c;
        }
        std::istringstream words(line);
        std::string id;
        double x = 0, y = 0, width = 0, height = 0;
        words >> id >> x >> y >> width >> height;
        const double stroke = preset == SvgPreset::Laser ? 0.0254 : 0.3;  // counts too
        EXPECT_NEAR(width * kPixelOfScreen, 100 + stroke, 0.01);
        EXPECT_NEAR(height * kPixelOfScreen, 100 + stroke, 0.01);
    }
}

TEST(DrawingClients, Hp2xxGivesThePlotItsTrueSize) {
    if (!hasClient("hp2xx")) {
        GTEST_SKIP() << "hp2xx is not installed";
    }
    const Drawing drawing = test::sewingDrawing();
    Eigen::AlignedBox2d box;  // the picture has what is drawn, and nothing about it
    for (const DrawnPath& path : drawing.paths) {
        for (Eigen::Index k = 0; k < path.points.rows(); ++k) {
            box.extend(path.points.row(k).transpose());
        }
    }
    const test::TemporaryFolder folder;
    for (const bool turned : {false, true}) {
        const auto file = folder.write("drawing.plt", writePlt(drawing, {turned}));
        const std::string svg = printedByClient("hp2xx -q -m svg -t -f - '" + file.string() + "'");
        const std::size_t view = svg.find("viewBox=\"");
        ASSERT_NE(view, std::string::npos);
        std::istringstream numbers(svg.substr(view + 9, 80));
        double left = 0, upper = 0, width = 0, height = 0;
        numbers >> left >> upper >> width >> height;
        EXPECT_NEAR((turned ? height : width) * kPointSize, box.sizes().x(), 0.2);
        EXPECT_NEAR((turned ? width : height) * kPointSize, box.sizes().y(), 0.2);
    }
}

}  // namespace
}  // namespace toile
