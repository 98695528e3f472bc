// SPDX-License-Identifier: GPL-3.0-or-later
// Half patterns: what is drawn once of what is its own or another's mirror image.
#include "core/pattern/half_pattern.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <string>

#include <gtest/gtest.h>
#include <pugixml.hpp>

#include "core/formats/writers.h"
#include "core/pattern/curve_fit.h"
#include "core/toile/pipeline.h"
#include "tests/core/formats/dxf_reader.h"
#include "tests/core/support/shared_data.h"
#include "tests/core/symmetry/mirror_shapes.h"

namespace toile {
namespace {

struct MirroredPattern {
    Garment garment;
    PieceResults results;
    Pattern whole;  ///< all of it by half
};

MirroredPattern byHalves(const std::string& name, bool isFair, Mirror mirror = Mirror::Mean) {
    MirroredPattern made;
    made.garment = name == "tube" ? test::tube4(test::draped) : test::garmentOf(name);
    LineSettings lines;
    lines.mirror = mirror;
    if (isFair) {
        lines.fairing = Fairing{};
    }
    Progress progress;
    made.results = flattenGarment(made.garment, {}, progress, 0, lines);
    made.whole = makePattern(made.garment, made.results, lines);
    for (PatternPiece& piece : made.whole.pieces) {
        piece.byHalf = true;
    }
    return made;
}

double areaOf(const Points2& loop) {
    double area = 0;
    for (Eigen::Index k = 0; k < loop.rows(); ++k) {
        const Eigen::RowVector2d a = loop.row(k), b = loop.row((k + 1) % loop.rows());
        area += (a.x() * b.y() - a.y() * b.x()) / 2;
    }
    return area;
}

double perimeterOf(const Points2& loop) {
    double length = 0;
    for (Eigen::Index k = 0; k < loop.rows(); ++k) {
        length += (loop.row((k + 1) % loop.rows()) - loop.row(k)).norm();
    }
    return length;
}

Points2 reflectedIn(const Chord& line, const Points2& points) {
    const Eigen::RowVector2d from = line.from.transpose();
    const Eigen::RowVector2d along = (line.to - line.from).normalized().transpose();
    const Points2 rest = points.rowwise() - from;
    const Points2 parallel = rest * along.transpose() * along;
    return (2 * parallel - rest).rowwise() + from;
}

struct HalfCase {
    const char* garment;
    int symmetric, pairs;
};

class HalfPattern : public testing::TestWithParam<HalfCase> {};

void expectExactHalf(const PatternPiece& whole, const PatternPiece& half) {
    const Eigen::Index n = whole.outline.rows();
    ASSERT_EQ(half.outline.rows(), n / 2 + 1);
    // The outline is its own image in the fold, point by point.
    const Points2 image = reflectedIn(foldOf(whole), whole.outline);
    for (Eigen::Index k = 0; k < n; ++k) {
        EXPECT_LT((image.row(k) - whole.outline.row((n - k) % n)).norm(), 1e-9);
    }
    const Chord fold = foldOf(half);
    const double edge = (fold.to - fold.from).norm();
    EXPECT_EQ(foldOf(whole).from, fold.from);
    EXPECT_EQ(foldOf(whole).to, fold.to);
    EXPECT_NEAR(2 * areaOf(half.outline) / areaOf(whole.outline), 1, 1e-12);
    EXPECT_NEAR(2 * (perimeterOf(half.outline) - edge), perimeterOf(whole.outline), 1e-9);
    // What lies on it covers the half and nothing besides.
    double at = 0;
    const auto outline = geometry::Line::closed(half.outline);
    for (const PatternSegment& segment : half.segments) {
        EXPECT_NEAR(curveLength(curvesOf(half, outline, segment)), segment.length,
                    kCurveLengthTolerance);
        EXPECT_NEAR(segment.from, at, 1e-6);
        EXPECT_NEAR(segment.to - segment.from, segment.length, 1e-6);
        EXPECT_EQ(segment.isFold, &segment == &half.segments.back());
        at = segment.to;
    }
    EXPECT_NEAR(at, perimeterOf(half.outline), 1e-6);
    double sewn = 0, ofWhole = 0;
    for (const SeamLine& seam : half.seams) {
        sewn += seam.to - seam.from;
    }
    for (const SeamLine& seam : whole.seams) {
        ofWhole += seam.to - seam.from;
    }
    EXPECT_NEAR(2 * sewn, ofWhole, 1e-6);
}

TEST_P(HalfPattern, HalfAndItsImageAreTheWhole) {
    if (std::string(GetParam().garment) != "tube") {
        TOILE_NEEDS_SHARED(test::dataFile(GetParam().garment));
    }
    for (const bool isFair : {false, true}) {
        const MirroredPattern made = byHalves(GetParam().garment, isFair);
        const Pattern cut = asCut(made.whole);
        int symmetric = 0, pairs = 0;
        for (std::size_t p = 0; p < cut.pieces.size(); ++p) {
            const PatternPiece &piece = cut.pieces[p], &whole = made.whole.pieces[p];
            SCOPED_TRACE(piece.name);
            if (piece.cutAs == CutAs::OnFold) {
                ++symmetric;
                expectExactHalf(whole, piece);
            } else if (piece.cutAs == CutAs::Pair) {
                ++pairs;
                EXPECT_EQ(piece.outline, whole.outline);
                const auto other = static_cast<std::size_t>(piece.mirror.counterpart);
                EXPECT_EQ(cut.pieces[other].cutAs, CutAs::Image);
                EXPECT_EQ(cut.pieces[other].outline.rows(), 0);
                EXPECT_NEAR(areaOf(made.whole.pieces[other].outline) / areaOf(whole.outline), 1,
                            1e-12);
            } else if (piece.cutAs == CutAs::Whole) {
                EXPECT_EQ(piece.outline, whole.outline);
            }
        }
        EXPECT_EQ(symmetric, GetParam().symmetric);
        EXPECT_EQ(pairs, GetParam().pairs);
    }
}

INSTANTIATE_TEST_SUITE_P(Garments, HalfPattern,
                         testing::Values(HalfCase{"tube", 2, 1},
                                         HalfCase{"samples/tshirt.obj", 3, 1},
                                         HalfCase{"garments/tee_sim.obj", 2, 2},
                                         HalfCase{"garments/dress.obj", 3, 2}));

/// The points of a path of an SVG, y up from its top.
Points2 svgPath(const std::string& bytes, const std::string& id, bool& isClosed) {
    pugi::xml_document document;
    EXPECT_TRUE(document.load_string(bytes.c_str()));
    const auto found = document.select_node(("//path[@id='" + id + "']").c_str());
    std::istringstream in(found.node().attribute("d").value());
    std::vector<Eigen::RowVector2d> points;
    isClosed = false;
    for (std::string word; in >> word;) {
        isClosed = word == "Z";
        const auto comma = word.find(',');
        if (comma != std::string::npos) {
            points.emplace_back(std::stod(word.substr(0, comma)),
                                -std::stod(word.substr(comma + 1)));
        }
    }
    Points2 line(static_cast<Eigen::Index>(points.size()), 2);
    for (std::size_t k = 0; k < points.size(); ++k) {
        line.row(static_cast<Eigen::Index>(k)) = points[k];
    }
    return line;
}

TEST(HalfPatternFiles, ShowOneHalfAndItsFold) {
    const MirroredPattern made = byHalves("samples/tshirt.obj", true);
    const LaidOutPattern laid = cutAndPlace(made.whole);
    const Drawing drawing = draw(laid.pattern, laid.marker);
    const std::string svg = writeSvg(drawing);
    const test::DxfFile dxf(writePlainDxf(drawing));
    EXPECT_TRUE(dxf.faults.empty());
    EXPECT_EQ(laid.whole.copies.size(), made.whole.pieces.size());
    EXPECT_EQ(laid.marker.copies.size(), made.whole.pieces.size() - 1);
    EXPECT_LT(laid.marker.width * laid.marker.height, laid.whole.width * laid.whole.height);
    for (std::size_t p = 0; p < laid.pattern.pieces.size(); ++p) {
        const PatternPiece& piece = laid.pattern.pieces[p];
        SCOPED_TRACE(piece.name);
        const std::string id = "piece-" + piece.slug;
        const auto text = std::ranges::find(drawing.texts, id + "-name", &DrawnText::id);
        bool isClosed = false;
        const Points2 line = svgPath(svg, id + "-cut", isClosed);
        ASSERT_EQ(line.rows(), piece.outline.rows());
        if (piece.cutAs == CutAs::Image) {
            EXPECT_EQ(text, drawing.texts.end());
            EXPECT_EQ(svg.find(id + "-"), std::string::npos);
            continue;
        }
        EXPECT_TRUE(isClosed);
        EXPECT_NEAR(perimeterOf(line), perimeterOf(piece.outline), 1e-3 * perimeterOf(line));
        const double part = piece.cutAs == CutAs::OnFold ? 0.5 : 1;
        EXPECT_NEAR(areaOf(line) / areaOf(made.whole.pieces[p].outline), part, 1e-5);
        const bool hasMark = svg.find("\"" + id + "--fold\"") != std::string::npos;
        EXPECT_EQ(hasMark, piece.cutAs == CutAs::OnFold);
        ASSERT_NE(text, drawing.texts.end());
        EXPECT_EQ(text->lines[1], hasMark ? "cut 1 on fold" : "cut 1 pair");
    }
}

TEST(HalfPatternFiles, AreAsBeforeWhereNothingIsByHalf) {
    MirroredPattern made = byHalves("samples/tshirt.obj", false);
    for (PatternPiece& piece : made.whole.pieces) {
        piece.byHalf = false;
    }
    const LaidOutPattern laid = cutAndPlace(made.whole);
    EXPECT_EQ(writeSvg(draw(laid.pattern, laid.marker)),
              writeSvg(draw(made.whole, placeCopies(made.whole))));
    EXPECT_EQ(writeReport(made.garment, made.results, laid.pattern),
              writeReport(made.garment, made.results, made.whole));
    EXPECT_EQ(laid.marker.width, laid.whole.width);
}

TEST(HalfPatternFiles, SeamsHaveNoTickWhereTheyCrossTheFold) {
    const MirroredPattern made = byHalves("tube", true);
    for (const PatternPiece& piece : asCut(made.whole).pieces) {
        if (piece.cutAs != CutAs::OnFold) {
            continue;
        }
        int parted = 0;
        for (const SeamLine& seam : piece.seams) {
            parted += seam.isAtFold[0] ? 1 : 0;
            parted += seam.isAtFold[1] ? 1 : 0;
        }
        EXPECT_EQ(parted, 2) << piece.name;  // free edges, at its top and at its bottom
        for (const bool isMirrored : {false, true}) {
            PatternPiece sewn = piece;
            for (SeamLine& seam : sewn.seams) {
                seam.kind = SeamKind::Seam;
            }
            const Placement placement{{0, 0}, 0.3, isMirrored};
            const Chord fold = foldOf(piece);
            for (const SeamMark& mark : seamMarks(sewn, placement)) {
                for (const auto& tick : mark.ticks) {
                    for (const Eigen::Vector2d& end : {fold.from, fold.to}) {
                        EXPECT_FALSE(tick && (tick->from - placement.applied(end)).norm() < 1);
                    }
                }
            }
        }
    }
}

TEST(HalfPatternWords, SayHowManyAreCut) {
    Cutting cutting;
    const auto note = [&cutting](CutAs as) { return cuttingNote(cutting, {}, as); };
    EXPECT_EQ(note(CutAs::Whole), "");
    EXPECT_EQ(note(CutAs::OnFold), "cut 1 on fold");
    EXPECT_EQ(note(CutAs::Pair), "cut 1 pair");
    cutting.mirroredPair = true;
    EXPECT_EQ(note(CutAs::OnFold), "cut 2 on fold");
    EXPECT_EQ(note(CutAs::Pair), "cut 1 pair");
    cutting.quantity = 3;
    EXPECT_EQ(note(CutAs::OnFold), "cut 6 on fold");
    EXPECT_EQ(note(CutAs::Pair), "cut 3 pairs");
}

TEST(DrawnMirrors, EitherOfAPairAsksForIt) {
    MirroredPattern made = byHalves("tube", false);
    for (const int asks : {1, 3}) {
        for (PatternPiece& piece : made.whole.pieces) {
            piece.byHalf = &piece == &made.whole.pieces[static_cast<std::size_t>(asks)];
        }
        const Pattern cut = asCut(made.whole);
        EXPECT_EQ(cut.pieces[0].cutAs, CutAs::Whole);
        EXPECT_NE(cut.pieces[1].cutAs, CutAs::Whole);
        EXPECT_NE(cut.pieces[3].cutAs, CutAs::Whole);
        EXPECT_NE(cut.pieces[1].cutAs, cut.pieces[3].cutAs);
    }
}

TEST(DrawnMirrors, NothingIsCalledAHalfThatIsNone) {
    const MirroredPattern exact = byHalves("tube", true, Mirror::None);
    for (const PatternPiece& piece : asCut(exact.whole).pieces) {
        EXPECT_EQ(piece.cutAs, CutAs::Whole) << piece.name;  // as the cloth hangs
    }
    // With a hole, whose rim is not drawn symmetric.
    MirroredPattern made = byHalves("tube", false);
    auto holed = std::make_shared<PieceResult>(*made.results[0]);
    auto piece = std::make_shared<Piece>(*holed->piece);
    piece->holes = {{0, 1, 2}};
    holed->piece = piece;
    made.results[0] = holed;
    EXPECT_EQ(drawnMirrors(made.results)[0], DrawnMirror{});
    EXPECT_TRUE(drawnMirrors(made.results)[2].isSymmetric);
    // One of a pair that could not be drawn.
    auto failed = std::make_shared<PieceResult>(*made.results[1]);
    failed->flat->line.reset();
    made.results[1] = failed;
    EXPECT_EQ(drawnMirrors(made.results)[3], DrawnMirror{});
}

}  // namespace
}  // namespace toile
