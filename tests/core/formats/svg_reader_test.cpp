// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/svg/svg_reader.h"

#include <cmath>
#include <numbers>
#include <string>

#include <gtest/gtest.h>

#include "core/formats/writers.h"
#include "tests/core/formats/export_fixtures.h"
#include "tests/core/support/generator.h"

namespace toile {
namespace {

/// A page of 100 x 50 mm in millimetres with this in it.
std::string svgPage(const std::string& content) {
    return "<svg xmlns='http://www.w3.org/2000/svg' xmlns:inkscape='i' width='100mm' height='50mm' "
           "viewBox='0 0 100 50'>" +
           content + "</svg>";
}

ReadSvg readSvgPage(const std::string& content) {
    auto svg = readSvg(svgPage(content));
    EXPECT_TRUE(svg) << content;
    return svg ? std::move(*svg) : ReadSvg();
}

SvgLine onlySvgLine(const std::string& content) {
    ReadSvg svg = readSvgPage(content);
    EXPECT_EQ(svg.lines.size(), 1U) << content;
    return svg.lines.empty() ? SvgLine() : std::move(svg.lines.front());
}

SvgLine svgPath(const std::string& data) {
    return onlySvgLine("<path d='" + data + "'/>");
}

Points2 svgPoints(std::initializer_list<std::pair<double, double>> list) {
    Points2 all(static_cast<Eigen::Index>(list.size()), 2);
    Eigen::Index row = 0;
    for (const auto& [x, y] : list) {
        all.row(row++) << x, y;
    }
    return all;
}

void expectSvgPoints(const SvgLine& line, const Points2& expected) {
    ASSERT_EQ(line.points.rows(), expected.rows());
    EXPECT_LT((line.points - expected).cwiseAbs().maxCoeff(), 1e-9) << line.points;
}

double lengthOfLine(const SvgLine& line) {
    double length = 0;
    for (Eigen::Index k = 0; k + 1 < line.points.rows(); ++k) {
        length += (line.points.row(k + 1) - line.points.row(k)).norm();
    }
    const auto ends = line.points.row(line.points.rows() - 1) - line.points.row(0);
    return length + (line.closed ? ends.norm() : 0);
}

TEST(ReadSvg, PlacesAreMillimetresFromTheLowerLeftCorner) {
    const ReadSvg svg = readSvgPage("<path id='a' d='M 10,20 L 30,20 30,45 Z'/>");
    EXPECT_EQ(svg.width, 100);
    EXPECT_EQ(svg.height, 50);
    ASSERT_EQ(svg.lines.size(), 1U);
    EXPECT_EQ(svg.lines[0].id, "a");
    EXPECT_TRUE(svg.lines[0].closed);
    expectSvgPoints(svg.lines[0], svgPoints({{10, 30}, {30, 30}, {30, 5}}));
}

TEST(ReadSvg, RefusesDecimalCommas) {
    for (const char* content : {"<rect x='0,5' y='0' width='10' height='10'/>",
                                "<g stroke-width='0,3'><path d='M 10,20 L 30,20 30,45 Z'/></g>",
                                "<circle cx='5' cy='5' r='2,5'/>"}) {
        const auto svg = readSvg(svgPage(content));
        ASSERT_FALSE(svg) << content;
        EXPECT_EQ(svg.error().code, ErrorCode::MalformedFile);
        EXPECT_NE(sentence(svg.error()).find("decimal comma"), std::string::npos);
    }
    // Commas between coordinates are as SVG has them.
    EXPECT_TRUE(readSvg(svgPage("<text x='1,2,3'>abc</text><path d='M 10,20 L 30,20 30,45 Z'/>")));
}

TEST(ReadSvg, LettersInBothCasesDrawTheSame) {
    const Points2 expected = svgPoints({{10, 40}, {30, 40}, {30, 20}, {15, 10}});
    for (const char* data : {"M10 10L30 10L30 30L15 40Z", "m10,10h20v20l-15,10z",
                             "M10 10H30V30L15 40z", "M 10 10 30 10 30 30 15 40 Z",
                             "m10 10 20 0 0 20-15 10z", "M10,10L30,10,30,30 15,40,10,10Z"}) {
        const SvgLine line = svgPath(data);
        EXPECT_TRUE(line.closed);
        expectSvgPoints(line, expected);
    }
}

TEST(ReadSvg, NumbersNeedNoBlanksBetweenThem) {
    expectSvgPoints(svgPath("M1.5.5-2-.5 1e1+3"), svgPoints({{1.5, 49.5}, {-2, 50.5}, {10, 47}}));
}

TEST(ReadSvg, EveryPartOfAPathIsALine) {
    const ReadSvg svg = readSvgPage("<path id='a' d='M0 0h10v10z m20 0h10 M 50 5z M1 1'/>");
    ASSERT_EQ(svg.lines.size(), 2U);
    EXPECT_TRUE(svg.lines[0].closed);
    EXPECT_FALSE(svg.lines[1].closed);
    expectSvgPoints(svg.lines[1], svgPoints({{20, 50}, {30, 50}}));
}

TEST(ReadSvg, ArcsLieOnTheirCircle) {
    // A quarter to the right and down, the short way and the long way round.
    for (const bool isLong : {false, true}) {
        const SvgLine line =
            svgPath("M20 10A10 10 0 " + std::string(isLong ? "1" : "0") + "1 30 20");
        const Eigen::RowVector2d middle =
            isLong ? Eigen::RowVector2d(30, 40) : Eigen::RowVector2d(20, 30);
        EXPECT_LT(((line.points.rowwise() - middle).rowwise().norm().array() - 10).abs().maxCoeff(),
                  1e-4);
        EXPECT_NEAR(lengthOfLine(line), std::numbers::pi * (isLong ? 15 : 5), 0.01);
    }
    // Flags that the next number follows at once; radii that are too small grow.
    const SvgLine tight = svgPath("M0 0a1 1 0 0110 0");
    EXPECT_NEAR(lengthOfLine(tight), std::numbers::pi * 5, 0.01);
}

TEST(ReadSvg, CurvesGoOnAsTheyBegan) {
    // Two quarters of a turn by quadratic and by cubic curves: S and T reflect the handle.
    for (const auto& [whole, shortened] :
         {std::pair("M0 0C0 10 10 10 10 20C10 30 20 30 20 40", "M0 0C0 10 10 10 10 20S20 30 20 40"),
          std::pair("M0 0Q10 0 10 10Q10 20 20 20", "M0 0Q10 0 10 10T20 20"),
          std::pair("M0 0q10 0 10 10q0 10 10 10", "M0 0q10 0 10 10t10 10"),
          std::pair("M0 0C0 0 10 10 10 20", "M0 0S10 10 10 20"),
          std::pair("M0 0L10 20", "M0 0T10 20")}) {
        const SvgLine a = svgPath(whole), b = svgPath(shortened);
        EXPECT_NEAR(lengthOfLine(a), lengthOfLine(b), 1e-6) << shortened;
        EXPECT_LT((a.points.bottomRows(1) - b.points.bottomRows(1)).norm(), 1e-9) << shortened;
    }
}

TEST(ReadSvg, CurvesAreFine) {
    // A parabola y = x^2 / 40, as a quadratic curve.
    const SvgLine line = svgPath("M0 0Q20 0 40 40");
    for (Eigen::Index k = 0; k < line.points.rows(); ++k) {
        const double x = line.points(k, 0);
        EXPECT_NEAR(50 - line.points(k, 1), x * x / 40, 1e-9);
    }
    EXPECT_GT(line.points.rows(), 20);
}

TEST(ReadSvg, TransformsAddUp) {
    const SvgLine line = onlySvgLine(
        "<g transform='translate(10,5)'><g transform='rotate(90) scale(2)'>"
        "<path transform='matrix(1 0 0 1 1 0)' d='M0 0L1 0'/></g></g>");
    expectSvgPoints(line, svgPoints({{10, 43}, {10, 41}}));
    expectSvgPoints(
        onlySvgLine("<path transform='rotate(180 5 5) skewX(0) skewY(0)' d='M0 0L1 0'/>"),
        svgPoints({{10, 40}, {9, 40}}));
}

TEST(ReadSvg, UnitsOfThePageScale) {
    const auto sideOf = [](const std::string& head) {
        const auto svg = readSvg("<svg " + head + "><path d='M0 0H72'/></svg>");
        EXPECT_TRUE(svg && svg->lines.size() == 1U);
        return svg && !svg->lines.empty() ? lengthOfLine(svg->lines[0]) : 0;
    };
    EXPECT_NEAR(sideOf("width='720pt' height='72pt' viewBox='0 0 720 72'"), 25.4, 1e-9);
    EXPECT_NEAR(sideOf("width='10in' height='1in' viewBox='0 0 720 72'"), 25.4, 1e-9);
    EXPECT_NEAR(sideOf("width='72cm' viewBox='0 0 720 72'"), 72, 1e-9);
    EXPECT_NEAR(sideOf("viewBox='0 0 720 72'"), 72 * 25.4 / 96, 1e-9);
    EXPECT_NEAR(sideOf("width='100%' height='100%'"), 72 * 25.4 / 96, 1e-9);
    EXPECT_NEAR(sideOf(""), 72 * 25.4 / 96, 1e-9);
    // The smaller scale counts where the shapes differ, but for "none".
    EXPECT_NEAR(sideOf("width='72mm' height='144mm' viewBox='0 0 72 72'"), 72, 1e-9);
    EXPECT_NEAR(sideOf("width='144mm' height='72mm' viewBox='0 0 72 72'"), 72, 1e-9);
    EXPECT_NEAR(
        sideOf("preserveAspectRatio='none' width='144mm' height='72mm' viewBox='0 0 72 72'"), 144,
        1e-9);
}

TEST(ReadSvg, ShapesAreLines) {
    expectSvgPoints(onlySvgLine("<rect x='1' y='2' width='3' height='4'/>"),
                    svgPoints({{1, 48}, {4, 48}, {4, 44}, {1, 44}}));
    expectSvgPoints(onlySvgLine("<polygon points='0,0 4,0 4,3'/>"),
                    svgPoints({{0, 50}, {4, 50}, {4, 47}}));
    EXPECT_FALSE(onlySvgLine("<polyline points='0,0 4,0 4,3'/>").closed);
    EXPECT_NEAR(lengthOfLine(onlySvgLine("<line x1='1' y1='1' x2='4' y2='5'/>")), 5, 1e-9);
    const SvgLine circle = onlySvgLine("<circle cx='20' cy='20' r='10'/>");
    EXPECT_TRUE(circle.closed);
    EXPECT_LT(((circle.points.rowwise() - Eigen::RowVector2d(20, 30)).rowwise().norm().array() - 10)
                  .abs()
                  .maxCoeff(),
              1e-4);
    EXPECT_TRUE(onlySvgLine("<ellipse cx='20' cy='20' rx='10' ry='5'/>").closed);
    const SvgLine rounded = onlySvgLine("<rect width='10' height='10' rx='2'/>");
    EXPECT_NEAR(lengthOfLine(rounded), 24 + std::numbers::pi * 4, 0.02);
    EXPECT_TRUE(readSvgPage("<circle r='-1'/><rect width='0' height='1'/><text>M0 0</text>"
                            "<path/><path d=''/>")
                    .lines.empty());
}

TEST(ReadSvg, LayersAreNamedByTheirLabelsElseByTheOutermostGroup) {
    EXPECT_EQ(
        onlySvgLine("<g id='x'><g id='l' inkscape:groupmode='layer' inkscape:label='Cut line'>"
                    "<g id='y' inkscape:label='no layer'><path d='M0 0H1'/></g></g></g>")
            .layer,
        "Cut line");
    EXPECT_EQ(
        onlySvgLine("<g id='CUT' data-name='Cut it'><g id='b'><path d='M0 0H1'/></g></g>").layer,
        "Cut it");
    EXPECT_EQ(onlySvgLine("<path d='M0 0H1'/>").layer, "");
    EXPECT_EQ(onlySvgLine("<g data-piece='p'><path d='M0 0H1'/></g>").piece, "p");
}

TEST(ReadSvg, ColoursAreFoundWhereverTheyAreSaid) {
    for (const char* content :
         {"<path stroke='#F00' d='M0 0H1'/>",
          "<path style='fill:none; stroke : RGB(255,0,0)' d='M0 0H1'/>",
          "<g stroke='#ff0000'><path d='M0 0H1'/></g>",
          "<style>.b,.a{fill:none;stroke:#f00;}</style><path class='x a' d='M0 0H1'/>",
          "<defs><style>.a{stroke:#FF0000}</style></defs><g class='a'><path d='M0 0H1'/></g>",
          "<g stroke='blue'><path style='stroke:#ff0000' stroke='green' d='M0 0H1'/></g>"}) {
        EXPECT_EQ(onlySvgLine(content).stroke, "#ff0000") << content;
    }
}

TEST(ReadSvg, WhatIsNotShownIsNotRead) {
    EXPECT_TRUE(readSvgPage("<defs><path d='M0 0H1'/></defs><clipPath><path d='M0 0H1'/></clipPath>"
                            "<g style='display:none'><g display='inline'><path d='M0 0H1'/></g></g>"
                            "<symbol><path d='M0 0H1'/></symbol>")
                    .lines.empty());
}

TEST(ReadSvg, WrongDataEndTheirPathOnly) {
    const ReadSvg svg = readSvgPage(
        "<path d='M0 0H10 L nan 5 L 20 20'/><path d='M0 0L1e999 0 5 5'/><path d='M0 0L1e300 0L5 "
        "5'/>"
        "<path d='M 0 0 A 1 1 0 2 0 5 5'/><path d='x'/><path d='M0 0H3'/>");
    ASSERT_EQ(svg.lines.size(), 2U);
    expectSvgPoints(svg.lines[0], svgPoints({{0, 50}, {10, 50}}));
    EXPECT_EQ(lengthOfLine(svg.lines[1]), 3);
}

TEST(ReadSvg, OtherFilesAreRefused) {
    for (const char* bytes : {"", "no", "<html/>", "<svg><g></svg>", "\xff\xfe", "<?xml?>"}) {
        const auto svg = readSvg(bytes);
        ASSERT_FALSE(svg) << bytes;
        EXPECT_EQ(svg.error().code, ErrorCode::MalformedFile);
    }
}

TEST(ReadSvg, DeepAndLongFilesDoNoHarm) {
    std::string deep;
    for (int k = 0; k < 20'000; ++k) {
        deep += "<g transform='scale(2)'>";
    }
    EXPECT_FALSE(readSvg("<svg>" + deep));
    for (int k = 0; k < 20'000; ++k) {
        deep += "</g>";
    }
    EXPECT_TRUE(readSvg("<svg>" + deep + "<path d='M0 0H1'/></svg>"));
    std::string curves = "M0 0";
    for (int k = 0; k < 10'000; ++k) {
        curves += "C9e6 0 0 9e6 0 0";
    }
    EXPECT_FALSE(readSvg(svgPage("<path d='" + curves + "'/>")));
}

/// Random damage to files gives finite lines or an error.
TEST(ReadSvg, DamagedFilesDoNoHarm) {
    test::Generator random(20260);
    const std::string drawing = writeSvg(draw(Pattern{}, Marker{}));
    const std::string shapes = svgPage(
        "<style>.a,.b{stroke:rgb(1,2,3);display:none}</style><g transform='rotate(3 4,5)skewX(2)' "
        "style='stroke:red'><path class='a' d='M1 2A3 4 5 0 1 6 7c1 2 3 4 5 6s7 8 9 1q2 3 4 5t6 "
        "7H8v9z'/>"
        "<rect x='1' y='2' width='3' height='4' rx='1'/><circle cx='1' r='2'/>"
        "<polygon points='1 2 3 4 5 6'/></g>");
    constexpr std::string_view kBytes =
        "0123456789.-+eE,() <>/='\"MmLlHhVvCcSsQqTtAaZz{}#;:%\x01\xff";
    for (int round = 0; round < 6000; ++round) {
        std::string bytes = round % 2 == 0 ? drawing : shapes;
        for (int k = random.whole(1, 6); k > 0; --k) {
            const auto at =
                static_cast<std::size_t>(random.whole(0, static_cast<int>(bytes.size()) - 1));
            const char other = kBytes[static_cast<std::size_t>(
                random.whole(0, static_cast<int>(kBytes.size()) - 1))];
            switch (random.whole(0, 3)) {
                case 0:
                    bytes.erase(at, static_cast<std::size_t>(random.whole(1, 20)));
                    break;
                case 1:
                    bytes.insert(at, 1, other);
                    break;
                case 2:
                    bytes.insert(at, bytes.substr(at / 2, 30));
                    break;
                default:
                    bytes[at] = other;
            }
        }
        const auto svg = readSvg(bytes);
        if (!svg) {
            continue;
        }
        EXPECT_TRUE(std::isfinite(svg->width) && std::isfinite(svg->height));
        for (const SvgLine& line : svg->lines) {
            ASSERT_TRUE(line.points.allFinite()) << bytes;
            ASSERT_GE(line.points.rows(), 2);
        }
    }
}

}  // namespace
}  // namespace toile
