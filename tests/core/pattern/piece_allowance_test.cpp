// SPDX-License-Identifier: GPL-3.0-or-later
// Allowances and notches on the pieces of garments.
#include "core/pattern/piece_allowance.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include <gtest/gtest.h>

#include "core/formats/drawing/drawing.h"
#include "core/geometry/line.h"
#include "core/geometry/segment.h"
#include "core/pattern/half_pattern.h"
#include "core/pattern/notch_mark.h"
#include "core/quality/outline_crossings.h"
#include "core/seam/find_seams.h"
#include "core/toile/pipeline.h"
#include "tests/core/pattern/allowance_shapes.h"
#include "tests/core/seam/seam_shapes.h"
#include "tests/core/support/shapes.h"
#include "tests/core/support/shared_data.h"
#include "tests/core/symmetry/mirror_shapes.h"

namespace toile {
namespace {

constexpr double kHundredth = 0.01;  // mm, of exactness away from corners
constexpr double kWidest = 30;       // mm, usual

struct CutPattern {
    Garment garment;
    PieceResults results;
    Pattern pattern;
};

CutPattern cutPattern(Garment garment, const LineSettings& lines) {
    CutPattern made{std::move(garment), {}, {}};
    Progress progress;
    made.results = flattenGarment(made.garment, {Method::Curvature}, progress, 0, lines);
    made.pattern = makePattern(made.garment, made.results, lines, symmetryOf(made.garment, lines));
    return made;
}

LineSettings withAllowance(double seam = 10, double hem = 30) {
    LineSettings lines;
    lines.allowance = AllowanceWidths{seam, hem};
    return lines;
}

/// Two rectangles side by side, 100 and 80 wide, 200 high, sewn along x = 100.
Garment twoRectangles() {
    Garment garment;
    for (const auto& [x, width] : {std::pair(0.0, 100.0), std::pair(100.0, 80.0)}) {
        auto piece = std::make_shared<Piece>(*test::asPiece(test::rectangle(x, 0, width, 200, 4, 8),
                                                            std::string(x > 0 ? "right" : "left")));
        test::identify(*piece, garment.pieces.size() + 1);
        garment.pieces.push_back(piece);
    }
    garment.seams = findSeams(garment.pieces);
    return garment;
}

const PatternSegment& sewn(const PatternPiece& piece) {
    return *std::ranges::find(piece.segments, SeamKind::Seam, &PatternSegment::kind);
}

TEST(PieceAllowance, OfRectanglesIsALargerOne) {
    const auto made = cutPattern(twoRectangles(), withAllowance());
    // A hem is mirrored where it ends: at right angles that is the rectangle.
    EXPECT_NEAR(test::areaOf(made.pattern.pieces[0].cuttingLine), 140.0 * 260, 1e-3);
    EXPECT_NEAR(test::areaOf(made.pattern.pieces[1].cuttingLine), 120.0 * 260, 1e-3);
    EXPECT_TRUE(made.pattern.hasAllowance);
}

TEST(PieceAllowance, IsThatOfTheSegmentWhereOneIsTyped) {
    const Garment garment = twoRectangles();
    LineSettings lines = withAllowance();
    const auto usual = cutPattern(garment, lines);
    SegmentSettings& said = lines.segments.emplace_back();
    said.place = sewn(usual.pattern.pieces[0]).place;
    said.allowance = 22;
    const auto typed = cutPattern(garment, lines);
    EXPECT_NEAR(test::areaOf(typed.pattern.pieces[0].cuttingLine), 152.0 * 260, 1e-3);
    EXPECT_NEAR(test::areaOf(typed.pattern.pieces[1].cuttingLine), 120.0 * 260, 1e-3);
    said = lines.segments.front();
    lines.segments.front().corner = CornerRule::Stepped;  // the hem below ends at its own seam line
    const auto stepped = cutPattern(garment, lines);
    EXPECT_NEAR(test::areaOf(stepped.pattern.pieces[0].cuttingLine), 152.0 * 260 - 22 * (30 - 22),
                1e-3);
}

TEST(PieceAllowance, BetweenTwoSegmentsThatRoundingPartsIsThatOfOne) {
    PatternPiece piece;
    piece.segments.resize(2);
    piece.segments[0] = {.from = 0, .to = 100 - 2e-12, .allowance = 10};
    piece.segments[1] = {.from = 100, .to = 200, .allowance = 10};
    for (const double at : {99.0, 100 - 1e-12, 100.0, 200 - 1e-14, 200.0, 250.0}) {
        EXPECT_EQ(allowanceAt(piece, 200, at), at > 200 ? 0 : 10) << at;
    }
}

TEST(PieceAllowance, IsNoneWhereNobodyAsks) {
    const auto made = cutPattern(twoRectangles(), {});
    EXPECT_EQ(made.pattern.pieces[0].cuttingLine.rows(), 0);
    EXPECT_EQ(&edgeOf(made.pattern.pieces[0]), &made.pattern.pieces[0].outline);
    EXPECT_TRUE(made.pattern.pieces[0].notches.empty());
}

TEST(PieceAllowance, OfNoWidthIsTheOutline) {
    const auto made = cutPattern(twoRectangles(), withAllowance(0, 0));
    EXPECT_EQ(made.pattern.pieces[0].cuttingLine, made.pattern.pieces[0].outline);
}

TEST(PieceAllowance, AHalfAndItsImageAreTheWhole) {
    LineSettings lines = withAllowance();
    lines.mirror = Mirror::Mean;
    CutPattern made = cutPattern(test::tube4(test::draped), lines);
    int halves = 0;
    for (PatternPiece& piece : made.pattern.pieces) {
        piece.byHalf = true;
    }
    const Pattern cut = asCut(made.pattern);
    for (std::size_t p = 0; p < cut.pieces.size(); ++p) {
        const PatternPiece& half = cut.pieces[p];
        if (half.cutAs == CutAs::OnFold) {
            ++halves;
            EXPECT_NEAR(2 * test::areaOf(half.cuttingLine),
                        test::areaOf(made.pattern.pieces[p].cuttingLine), 0.5);
            const Chord fold = foldOf(half);
            EXPECT_LT(test::distanceTo(((fold.from + fold.to) / 2).transpose(), half.cuttingLine),
                      1e-5);
        } else if (half.cutAs == CutAs::Image) {
            EXPECT_EQ(half.cuttingLine.rows(), 0);
        }
    }
    EXPECT_EQ(halves, 2);
}

Points2 imageInFold(const Chord& line, const Points2& points) {
    const Eigen::RowVector2d from = line.from.transpose();
    const Eigen::RowVector2d along = (line.to - line.from).normalized().transpose();
    const Points2 rest = points.rowwise() - from;
    return (2 * (rest * along.transpose() * along) - rest).rowwise() + from;
}

/// The cutting line of the half and its mirror image make that of the whole piece.
void expectHalvesOf(const PatternPiece& whole, const PatternPiece& half) {
    constexpr double kAllowedOff = 0.05;  // mm
    ASSERT_EQ(half.cutAs, CutAs::OnFold);
    EXPECT_NEAR(2 * test::areaOf(half.cuttingLine) / test::areaOf(whole.cuttingLine), 1, 1e-6);
    const Chord fold = foldOf(half);
    const Points2 image = imageInFold(fold, half.cuttingLine);
    for (const auto& point : half.cuttingLine.rowwise()) {
        EXPECT_LT(test::distanceTo(point, whole.cuttingLine), kAllowedOff);
        const Eigen::Vector2d way = point.transpose() - fold.from;
        EXPECT_GT(geometry::cross((fold.to - fold.from).normalized(), way), -kAllowedOff);
    }
    for (const auto& point : whole.cuttingLine.rowwise()) {
        EXPECT_LT(
            std::min(test::distanceTo(point, half.cuttingLine), test::distanceTo(point, image)),
            kAllowedOff);
    }
    std::vector<int> all(static_cast<std::size_t>(half.cuttingLine.rows()));
    std::iota(all.begin(), all.end(), 0);
    EXPECT_TRUE(outlineIsSimple(half.cuttingLine, all));
}

/// A piece that is symmetric about x = 0.
/// @param left    its outline from the fold above to the fold below, by way of the left
/// @param widths  of the allowances of these edges; the last on the right may differ
PatternPiece symmetricPiece(const std::vector<Eigen::RowVector2d>& left,
                            const std::vector<double>& widths, double lastOnRight = -1) {
    const auto n = static_cast<Eigen::Index>(left.size());
    PatternPiece piece;
    piece.outline.resize(2 * n - 2, 2);
    for (Eigen::Index k = 0; k < n; ++k) {
        const Eigen::RowVector2d& point = left[static_cast<std::size_t>(k)];
        piece.outline.row(k) = point;
        if (k > 0 && k < n - 1) {
            piece.outline.row(2 * n - 2 - k) << -point.x(), point.y();
        }
    }
    double at = 0;
    for (Eigen::Index k = 0; k < 2 * n - 2; ++k) {
        PatternSegment& segment = piece.segments.emplace_back();
        segment.length = (piece.outline.row((k + 1) % (2 * n - 2)) - piece.outline.row(k)).norm();
        segment.from = at;
        at += segment.length;
        segment.to = at;
        segment.isCorner = true;
        segment.kind = SeamKind::Seam;
        segment.allowance = widths[static_cast<std::size_t>(k < n - 1 ? k : 2 * n - 3 - k)];
    }
    if (lastOnRight >= 0) {
        piece.segments.back().allowance = lastOnRight;
    }
    piece.mirror.isSymmetric = piece.byHalf = true;
    addCuttingLine(piece);
    return piece;
}

/// With an edge that meets the fold at an angle: a V neck, a pointed hem, and a yoke that has both.
const std::vector<std::vector<Eigen::RowVector2d>> kObliqueShapes{
    {{0, 220}, {-90, 300}, {-200, 290}, {-200, 0}, {0, 0}},
    {{0, 300}, {-200, 300}, {-150, 60}, {0, 0}},
    {{0, 90}, {-60, 150}, {-180, 120}, {-160, 30}, {0, -50}}};

TEST(PieceAllowance, WhereAnEdgeMeetsTheFoldAtAnAngleIsThatOfTheWhole) {
    for (const auto& left : kObliqueShapes) {
        for (const std::vector<double>& widths : std::vector<std::vector<double>>{
                 {30, 10, 15, 30}, {10, 10, 10, 10}, {7, 20, 0, 45}, {0, 0, 0, 25}}) {
            const PatternPiece whole = symmetricPiece(left, widths);
            const PatternPiece half = asCut({"", {whole}}).pieces[0];
            expectHalvesOf(whole, half);
            const Chord fold = foldOf(half), edge = foldOfEdge(half);
            EXPECT_GE((edge.to - edge.from).norm(), (fold.to - fold.from).norm() - 1e-5);
        }
    }
}

TEST(PieceAllowance, PiecesWithOtherAllowancesOnTheirRightAreNotHalved) {
    std::vector<PatternPiece> pieces{symmetricPiece(kObliqueShapes[0], {30, 10, 15, 30}),
                                     symmetricPiece(kObliqueShapes[0], {30, 10, 15, 30}, 12)};
    dropUnequalMirrors(pieces);
    EXPECT_TRUE(pieces[0].mirror.isSymmetric);
    EXPECT_FALSE(pieces[1].mirror.isSymmetric);
    EXPECT_EQ(asCut({"", {pieces[1]}}).pieces[0].cutAs, CutAs::Whole);
}

TEST(PieceNotches, AtTheFoldPointAlongIt) {
    for (const auto& left : kObliqueShapes) {
        Pattern pattern{"", {symmetricPiece(left, {30, 10, 15, 30})}};
        const double half = geometry::Line::closed(pattern.pieces[0].outline).length() / 2;
        pattern.pieces[0].notches = {{.seam = 1, .at = 0}, {.seam = 1, .at = half}};
        pattern.pieces[0].notches.push_back({.seam = 1, .at = half, .count = 2});
        const Pattern cut = asCut(pattern);
        const auto strokes = notchMarks(cut, cut.pieces[0]);
        ASSERT_EQ(strokes.size(), 3U);
        for (std::size_t n = 0; n < 3; ++n) {
            ASSERT_EQ(strokes[n].size(), 1U) << n;  // of a double notch one lies beyond the fold
            const Points2& line = strokes[n][0];
            EXPECT_NEAR(line(0, 0), n == 2 ? -4 : 0, 1e-6);
            EXPECT_NEAR(line(0, 0), line(1, 0), 1e-6);
        }
        EXPECT_NEAR(strokes[0][0](0, 1), left.front().y() + 30, 1e-6);
        EXPECT_NEAR(strokes[1][0](0, 1),
                    left.back().y() - cut.pieces[0].segments[left.size() - 2].allowance, 1e-6);
    }
}

class HalvesOfGarment : public testing::TestWithParam<const char*> {};

TEST_P(HalvesOfGarment, AndTheirImagesAreTheWholes) {
    TOILE_NEEDS_SHARED(test::dataFile(GetParam()));
    LineSettings lines = withPattern({});
    lines.mirror = Mirror::Mean;
    CutPattern made = cutPattern(test::garmentOf(GetParam()), lines);
    for (PatternPiece& piece : made.pattern.pieces) {
        piece.byHalf = true;
    }
    const Pattern cut = asCut(made.pattern);
    int halves = 0;
    for (std::size_t p = 0; p < cut.pieces.size(); ++p) {
        SCOPED_TRACE(cut.pieces[p].name);
        if (made.pattern.pieces[p].mirror.isSymmetric) {
            expectHalvesOf(made.pattern.pieces[p], cut.pieces[p]);
            ++halves;
        }
    }
    EXPECT_GT(halves, 0);
}

INSTANTIATE_TEST_SUITE_P(Garments, HalvesOfGarment,
                         testing::Values("samples/tshirt.obj", "garments/tee_sim.obj",
                                         "garments/dress.obj", "garments/polo.obj"));

/// Away from corners, and simple everywhere.
void expectStatedWidths(const Pattern& pattern) {
    int measured = 0;
    for (const PatternPiece& piece : pattern.pieces) {
        std::vector<int> all(static_cast<std::size_t>(piece.cuttingLine.rows()));
        std::iota(all.begin(), all.end(), 0);
        EXPECT_TRUE(outlineIsSimple(piece.cuttingLine, all)) << piece.name;
        const auto outline = geometry::Line::closed(piece.outline);
        for (const PatternSegment& segment : piece.segments) {
            const double length = segment.to - segment.from;
            if (length > 6 * kWidest) {
                const double at = (segment.from + segment.to) / 2;
                const double off = test::distanceTo(outline.pointAt(at), piece.cuttingLine);
                EXPECT_LE(off, segment.allowance + kHundredth) << piece.name;
                EXPECT_LT(test::outside(outline.pointAt(at), piece.cuttingLine), 1e-5);
                measured += std::abs(off - segment.allowance) < kHundredth ? 1 : 0;
                EXPECT_EQ(allowanceAt(piece, outline.length(), outline.wrap(at)),
                          segment.allowance);
            }
        }
    }
    EXPECT_GT(measured, 4);
}

/// Both sides of a seam are as long from notch to notch.
void expectNotchesOpposite(const Pattern& pattern) {
    struct Side {
        double way;  // from the notch before
        int count;
    };
    // By seam and share, the way along the outline from one notch to the next on either piece.
    std::map<std::pair<int, double>, std::vector<Side>> sides;
    for (const PatternPiece& piece : pattern.pieces) {
        std::map<int, std::vector<const PieceNotch*>> ofSeam;
        for (const PieceNotch& notch : piece.notches) {
            if (notch.reason == NotchReason::Balance && notch.hole < 0) {
                ofSeam[notch.seam].push_back(&notch);
            }
        }
        for (auto& [seam, notches] : ofSeam) {
            std::ranges::sort(notches, {}, &PieceNotch::share);
            const double length = geometry::Line::closed(piece.outline).length();
            for (std::size_t k = 1; k < notches.size(); ++k) {
                const double way =
                    std::abs(std::remainder(notches[k]->at - notches[k - 1]->at, length));
                sides[{seam, notches[k]->share}].push_back({way, notches[k]->count});
            }
        }
    }
    int pairs = 0;
    for (const auto& [place, both] : sides) {
        if (both.size() == 2) {
            ++pairs;
            EXPECT_NEAR(both[0].way, both[1].way, 1e-6) << place.first;
            EXPECT_EQ(both[0].count, both[1].count);
        }
    }
    EXPECT_GT(pairs, 0);
}

void expectMarksOnTheCuttingLine(const Pattern& pattern) {
    int marks = 0;
    for (const PatternPiece& piece : pattern.pieces) {
        const auto outline = geometry::Line::closed(piece.outline);
        const auto strokes = notchMarks(pattern, piece);
        ASSERT_EQ(strokes.size(), piece.notches.size());
        for (std::size_t n = 0; n < strokes.size(); ++n) {
            const PieceNotch& notch = piece.notches[n];
            EXPECT_EQ(strokes[n].size(), static_cast<std::size_t>(notch.count));
            const double width = allowanceAt(piece, outline.length(), notch.at);
            if (notch.reason == NotchReason::Balance && notch.hole < 0 && notch.count == 1) {
                ++marks;
                // Square to the seam line: where that is bent, nearly.
                EXPECT_LT(test::distanceTo(strokes[n][0].row(0), piece.cuttingLine), 0.3);
                EXPECT_NEAR((strokes[n][0].row(0) - outline.pointAt(notch.at)).norm(), width, 1e-9);
            }
        }
    }
    EXPECT_GT(marks, 0);
}

// By rounding a notch in the middle of a seam may be a turn further along.
TEST(PieceNotches, WhereTheFoldStartsStayOnTheHalf) {
    LineSettings lines = withAllowance();
    lines.mirror = Mirror::Mean;
    Pattern pattern = cutPattern(test::tube4(test::draped), lines).pattern;
    for (PatternPiece& piece : pattern.pieces) {
        const double length = geometry::Line::closed(piece.outline).length();
        piece.byHalf = true;
        piece.notches = {{.seam = 1, .at = 1}, {.seam = 1, .at = length - 1}};
        piece.notches.push_back({.seam = 1, .at = length - 1e-10});
    }
    int halves = 0;
    for (const PatternPiece& half : asCut(pattern).pieces) {
        if (half.cutAs == CutAs::OnFold) {
            ++halves;
            ASSERT_EQ(half.notches.size(), 2U);
            EXPECT_EQ(half.notches[0].at, 1);
            EXPECT_EQ(half.notches[1].at, 0);
        }
    }
    EXPECT_EQ(halves, 2);
}

class PatternOfGarment : public testing::TestWithParam<const char*> {};

TEST_P(PatternOfGarment, HasItsAllowancesAndNotchesWhereTheyBelong) {
    TOILE_NEEDS_SHARED(test::dataFile(GetParam()));
    const auto made = cutPattern(test::garmentOf(GetParam()), withPattern({}));
    expectStatedWidths(made.pattern);
    expectNotchesOpposite(made.pattern);
    expectMarksOnTheCuttingLine(made.pattern);
}

INSTANTIATE_TEST_SUITE_P(Garments, PatternOfGarment,
                         testing::Values("samples/bodice.obj", "samples/tshirt.obj",
                                         "garments/tee_sim.obj", "garments/dress.obj"));

TEST(PatternDrawing, HasTheSeamLineAndTheNotchesOnLayersOfTheirOwn) {
    const Garment garment = test::garmentOf("samples/tshirt.obj");
    const auto bare = cutPattern(garment, {});
    const auto made = cutPattern(garment, withPattern({}));
    const auto count = [](const Drawing& drawing, LayerKind kind) {
        return std::ranges::count(drawing.paths, kind, &DrawnPath::layer);
    };
    const Drawing without = draw(bare.pattern, placeCopies(bare.pattern));
    const Drawing with = draw(made.pattern, placeCopies(made.pattern));
    for (const LayerKind kind : {LayerKind::Sew, LayerKind::Notches}) {
        EXPECT_FALSE(hasLayer(without, kind));
        EXPECT_TRUE(hasLayer(with, kind));
    }
    const auto pieces = static_cast<std::ptrdiff_t>(made.pattern.pieces.size());
    EXPECT_EQ(count(with, LayerKind::Sew), pieces);
    EXPECT_EQ(count(with, LayerKind::Cut), count(without, LayerKind::Cut));
}

}  // namespace
}  // namespace toile
