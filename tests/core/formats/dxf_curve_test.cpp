// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/dxf/dxf_curve.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include <gtest/gtest.h>

#include "core/base/file.h"
#include "core/formats/read_pattern.h"
#include "core/geometry/polygon.h"
#include "tests/core/formats/dxf_builder.h"
#include "tests/core/support/shared_data.h"

namespace toile {
namespace {

using test::DxfBuilder;

constexpr double kTrueLength = 0.05;  // mm, as docs/exports.md promises
constexpr double kPiOf = std::numbers::pi;

double lengthOf(const FileLine& line) {
    double length = line.closed ? geometry::perimeterOf(line.points) : 0;
    for (Eigen::Index k = 0; !line.closed && k + 1 < line.points.rows(); ++k) {
        length += (line.points.row(k + 1) - line.points.row(k)).norm();
    }
    return length;
}

/// The last entity of a page as a line; closed and without points if there is none.
FileLine lineOf(DxfBuilder text) {
    const std::string bytes = text.end().take();
    const auto document = readDxfDocument(bytes);
    EXPECT_TRUE(document) << (document ? "" : sentence(document.error()));
    const auto line = document ? dxfCurve(document->entities.back(), 1) : std::nullopt;
    return line.value_or(FileLine{Points2(0, 2), true});
}

DxfBuilder entity(std::string_view kind) {
    DxfBuilder text;
    text.section("ENTITIES").tag(0, kind).tag(8, "CUT");
    return text;
}

DxfBuilder& radius(DxfBuilder& text, double r) {
    return text.number(40, r);
}

DxfBuilder circle(double r) {
    DxfBuilder text = entity("CIRCLE");
    return radius(text.at(100, -50), r);
}

TEST(DxfCurve, CirclesAndArcsHaveTheirLength) {
    for (const double r : {2.0, 110.0, 700.0, 5000.0}) {
        const FileLine line = lineOf(circle(r));
        EXPECT_TRUE(line.closed);
        EXPECT_NEAR(lengthOf(line), 2 * kPiOf * r, kTrueLength) << r;
        EXPECT_NEAR(geometry::signedAreaOf(line.points) / (kPiOf * r * r), 1, 1e-2 / r) << r;
        DxfBuilder arc = entity("ARC");
        radius(arc.at(0, 0), r).number(50, 350).number(51, 80);
        const FileLine part = lineOf(arc);
        EXPECT_FALSE(part.closed);
        EXPECT_NEAR(lengthOf(part), kPiOf * r / 2, kTrueLength) << r;
        EXPECT_NEAR(part.points(0, 0), r * std::cos(-kPiOf / 18), 1e-6);
        EXPECT_NEAR(part.points(0, 1), r * std::sin(-kPiOf / 18), 1e-6);
    }
    EXPECT_LT(lineOf(circle(2)).points.rows(), 100);  // no more than the tolerance asks for
}

TEST(DxfCurve, EllipsesHaveTheLengthOfTheIntegral) {
    const double a = 300, b = 120;
    const auto integral = [&](double from, double to) {
        constexpr int kSteps = 100000;
        double sum = 0;
        for (int k = 0; k < kSteps; ++k) {
            const double t = from + (k + 0.5) * (to - from) / kSteps;
            sum += std::hypot(a * std::sin(t), b * std::cos(t)) * (to - from) / kSteps;
        }
        return sum;
    };
    for (const char* up : {"1", "-1"}) {
        DxfBuilder whole = entity("ELLIPSE");
        whole.at(10, 20).number(11, 0).number(21, a).number(40, b / a).tag(230, up);
        const FileLine line = lineOf(whole);
        EXPECT_TRUE(line.closed);
        EXPECT_NEAR(lengthOf(line), integral(0, 2 * kPiOf), kTrueLength);
        DxfBuilder part = entity("ELLIPSE");
        part.at(0, 0).number(11, a).number(21, 0).number(40, b / a).tag(230, up);
        const FileLine arc = lineOf(part.number(41, 0.3).number(42, 1.7));
        EXPECT_NEAR(lengthOf(arc), integral(0.3, 1.7), kTrueLength);
        // Upside down it runs the other way round.
        EXPECT_EQ(arc.points(arc.points.rows() - 1, 1) > 0, up == std::string("1"));
    }
}

TEST(DxfCurve, BulgesAreArcs) {
    // A square of 100 mm with a half circle outwards, a quarter inwards, and the last edge bent.
    const std::array<double, 4> bulges{1, -std::tan(kPiOf / 8), 0, 0.2};
    const double expected = kPiOf * 50 + kPiOf / 2 * 100 / std::sqrt(2) + 100 +
                            4 * std::atan(0.2) * 100 * (1 + 0.04) / (4 * 0.2);
    const std::array<std::pair<double, double>, 4> corners{
        std::pair(0.0, 0.0), {100.0, 0.0}, {100.0, 100.0}, {0.0, 100.0}};
    for (const bool isLight : {true, false}) {
        DxfBuilder text = entity(isLight ? "LWPOLYLINE" : "POLYLINE");
        text.tag(70, "1");
        for (std::size_t k = 0; k < 4; ++k) {
            if (!isLight) {
                text.tag(0, "VERTEX").tag(8, "CUT");
            }
            text.at(corners[k].first, corners[k].second).number(42, bulges[k]);
        }
        const FileLine line = lineOf(text);
        EXPECT_TRUE(line.closed);
        EXPECT_NEAR(lengthOf(line), expected, kTrueLength);
        EXPECT_NEAR(line.points.col(1).minCoeff(), -50,
                    0.01);  // outwards: to the right of the edge
        EXPECT_LT(line.points.col(0).maxCoeff(), 100.01);
    }
}

/// A circle of radius 100 as a rational B-spline of degree 2.
DxfBuilder splineCircle() {
    DxfBuilder text = entity("SPLINE");
    text.tag(70, "5").tag(71, "2").tag(72, "12").tag(73, "9").tag(74, "0");
    for (const double knot : {0, 0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 4}) {
        text.number(40, knot);
    }
    for (int k = 0; k < 9; ++k) {
        text.number(41, k % 2 == 0 ? 1 : std::sqrt(0.5));
    }
    for (int k = 0; k < 9; ++k) {
        const double far = k % 2 == 0 ? 100 : 100 * std::sqrt(2.0);
        text.at(far * std::cos(k * kPiOf / 4), far * std::sin(k * kPiOf / 4));
    }
    return text;
}

TEST(DxfCurve, RationalSplinesAreCircles) {
    const FileLine line = lineOf(splineCircle());
    EXPECT_TRUE(line.closed);
    EXPECT_NEAR(lengthOf(line), 200 * kPiOf, kTrueLength);
    EXPECT_NEAR(geometry::signedAreaOf(line.points), 1e4 * kPiOf, 2);
}

TEST(DxfCurve, SplinesOfControlPointsHaveTheirLength) {
    // A parabola y = x² / 200 from -100 to 100, in one stretch and in two.
    const double slope = 1, expected = 100 * (slope * std::sqrt(2) + std::asinh(slope));
    DxfBuilder one = entity("SPLINE");
    one.tag(70, "8").tag(71, "2");
    for (const double knot : {0, 0, 0, 1, 1, 1}) {
        one.number(40, knot);
    }
    one.at(-100, 50).at(0, -50).at(100, 50);
    EXPECT_NEAR(lengthOf(lineOf(one)), expected, kTrueLength);
    DxfBuilder two = entity("SPLINE");
    two.tag(70, "8").tag(71, "2");
    for (const double knot : {0.0, 0.0, 0.0, 0.25, 1.0, 1.0, 1.0}) {
        two.number(40, knot);
    }
    two.at(-100, 50).at(-75, 25).at(25, -25).at(100, 50);
    EXPECT_NEAR(lengthOf(lineOf(two)), expected, kTrueLength);
}

TEST(DxfCurve, SplinesWithoutControlPointsGoThroughTheirFitPoints) {
    const auto circleThrough = [](int count, int last, bool closed, bool hasWays) {
        DxfBuilder text = entity("SPLINE");
        text.tag(70, closed ? "1" : "0").tag(71, "3");
        for (int k = 0; k <= last; ++k) {
            const double angle = 2 * kPiOf * k / count;
            text.number(11, 100 * std::cos(angle)).number(21, 100 * std::sin(angle));
        }
        if (hasWays) {
            const double angle = 2 * kPiOf * last / count;
            text.number(12, 0).number(22, 1);
            text.number(13, -std::sin(angle)).number(23, std::cos(angle));
        }
        return lengthOf(lineOf(text));
    };
    EXPECT_NEAR(circleThrough(24, 24, true, false), 200 * kPiOf, kTrueLength);
    EXPECT_NEAR(circleThrough(24, 23, true, false), 200 * kPiOf, kTrueLength);
    EXPECT_NEAR(circleThrough(24, 12, false, true), 100 * kPiOf, kTrueLength);
    EXPECT_NEAR(circleThrough(24, 12, false, false), 100 * kPiOf, 0.5);  // it ends straight
}

TEST(DxfCurve, SplineFitPolylinesAreTheirSplines) {
    const auto polyline = [](int perSpan, bool hasFrame) {
        DxfBuilder text = entity("POLYLINE");
        text.tag(66, "1").tag(70, "4").tag(75, "6");
        const auto vertex = [&text](double x, double y, const char* flags) {
            text.tag(0, "VERTEX").tag(8, "CUT").at(x, y).tag(70, flags);
        };
        for (const auto& [x, y] :
             {std::pair(0.0, 0.0), {0.0, 200.0}, {300.0, 200.0}, {300.0, 0.0}}) {
            if (hasFrame) {
                vertex(x, y, "16");
            }
        }
        for (int k = 0; k <= perSpan; ++k) {  // one cubic stretch
            const double t = static_cast<double>(k) / perSpan, u = 1 - t;
            vertex(300 * (3 * u * t * t + t * t * t), 600 * u * t, "8");
        }
        return lengthOf(lineOf(text));
    };
    EXPECT_NEAR(polyline(16, true), polyline(2000, false), kTrueLength);
    EXPECT_GT(polyline(2000, false) - polyline(16, false), kTrueLength);
}

TEST(DxfCurve, IsNoneWhereItCannotBeRead) {
    DxfBuilder tilted = circle(10);
    EXPECT_EQ(lineOf(tilted.number(210, 0.6).number(220, 0).number(230, 0.8)).points.rows(), 0);
    EXPECT_EQ(lineOf(circle(0)).points.rows(), 0);
    DxfBuilder spline = entity("SPLINE");
    EXPECT_EQ(lineOf(spline.tag(71, "3").number(40, 0).at(0, 0).at(1, 1)).points.rows(), 0);
    DxfBuilder mesh = entity("POLYLINE");
    mesh.tag(70, "64").tag(0, "VERTEX").at(0, 0).tag(0, "VERTEX").at(1, 1);
    EXPECT_EQ(lineOf(mesh).points.rows(), 0);
    EXPECT_EQ(lineOf(entity("HATCH")).points.rows(), 0);
}

/// All kinds of curves as one closed outline each, in a block that is inserted in a block.
std::string insertedFile(double x, double y, double turn, double scaleX, double scaleY,
                         bool isUpsideDown) {
    DxfBuilder text;
    text.section("HEADER").tag(9, "$INSUNITS").tag(70, "4").end().section("BLOCKS");
    text.block("inner", 5, 7);
    text.tag(0, "CIRCLE").tag(8, "0").at(0, 0).number(40, 150);
    text.tag(0, "LWPOLYLINE").tag(8, "0").tag(70, "1");
    text.at(400, 0).number(42, 0.4).at(600, 50).number(42, -0.3).at(500, 300);
    text.tag(0, "ELLIPSE").tag(8, "0").at(0, 600).number(11, 120).number(21, 90).number(40, 0.5);
    text.tag(0, "ARC").tag(8, "0").at(500, 600).number(40, 100).number(50, 0).number(51, 180);
    text.line("0", 400, 600, 600, 600).endBlock();
    text.block("outer", -3, 2).insert("inner", 10, 20).number(50, 30).endBlock();
    text.end().section("ENTITIES").insert("outer", x, y);
    text.number(50, turn).number(41, scaleX).number(42, scaleY);
    if (isUpsideDown) {
        text.number(210, 0).number(220, 0).number(230, -1);
    }
    text.line("1", 5000, 5000, 5300, 5000).line("1", 5300, 5000, 5300, 5300);
    return text.line("1", 5300, 5300, 5000, 5000).end().take();
}

TEST(DxfCurve, LengthsSurviveInsertion) {
    const auto lengths = [](const std::string& bytes) {
        const auto file = readDxfPattern(bytes);
        EXPECT_TRUE(file) << (file ? "" : sentence(file.error()));
        std::vector<double> found;
        for (const FilePiece& piece : file ? file->pieces : std::vector<FilePiece>{}) {
            found.push_back(geometry::perimeterOf(piece.cut));
        }
        std::ranges::sort(found);
        return found;
    };
    const std::vector<double> plain = lengths(insertedFile(0, 0, 0, 1, 1, false));
    ASSERT_EQ(plain.size(), 5u);
    EXPECT_NEAR(plain[0], 200 + 100 * kPiOf, kTrueLength);
    for (const double scale : {1.0, 2.0}) {
        for (const bool isMirrored : {false, true}) {
            for (const bool isUpsideDown : {false, true}) {
                std::vector<double> moved = lengths(insertedFile(
                    -4000, 3000, 77, isMirrored ? -scale : scale, scale, isUpsideDown));
                ASSERT_EQ(moved.size(), 5u);
                std::vector<double> expected = plain;
                const double triangle = 600 + 300 * std::sqrt(2.0);  // on the page itself
                for (double& length : expected) {
                    length *= std::abs(length - triangle) < 1e-3 ? 1 : scale;
                }
                std::ranges::sort(expected);
                for (std::size_t k = 0; k < 5; ++k) {
                    EXPECT_NEAR(moved[k], expected[k], kTrueLength);
                }
            }
        }
    }
}

TEST(DxfCurve, UpsideDownTheXAxisIsTurnedRound) {
    DxfBuilder text = circle(10);
    const FileLine line = lineOf(text.number(230, -1));
    EXPECT_NEAR(line.points.col(0).mean(), -100, 1e-6);
    EXPECT_NEAR(line.points.col(1).mean(), -50, 1e-6);
    DxfBuilder light = entity("LWPOLYLINE");
    const FileLine half =
        lineOf(light.tag(70, "0").number(230, -1).at(0, 0).number(42, 1).at(100, 0));
    EXPECT_NEAR(half.points.col(0).minCoeff(), -100, 1e-9);
    EXPECT_NEAR(half.points.col(1).minCoeff(), -50, 0.01);
}

TEST(DxfCurve, ReadsTheCurvesOfOtherPrograms) {
    const struct {
        const char* name;
        double length, area;  // mm, mm²
    } files[] = {{"bulge_lwpolyline", 1831.04, 167624}, {"bulge_r12_polyline", 1831.04, 167624},
                 {"line_arc", 1831.04, 167624},         {"line_spline", 1831.01, 167649},
                 {"aama_bulge_inch", 1860.34, 173031},  {"circle_skirt", 4398.23, 1539380}};
    for (const auto& [name, length, area] : files) {
        const auto path = test::dataFile("reports/dxf-curves/" + std::string(name) + ".dxf");
        TOILE_NEEDS_SHARED(path);
        const auto file = readDxfPattern(*readFile(path));
        ASSERT_TRUE(file) << name;
        ASSERT_EQ(file->pieces.size(), 1u) << name;
        EXPECT_NEAR(geometry::perimeterOf(file->pieces[0].cut), length, kTrueLength) << name;
        EXPECT_NEAR(geometry::signedAreaOf(file->pieces[0].cut), area, 12) << name;
        EXPECT_TRUE(file->notes.empty()) << name << file->notes.front();
    }
}

}  // namespace
}  // namespace toile
