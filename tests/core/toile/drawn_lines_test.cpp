// SPDX-License-Identifier: GPL-3.0-or-later
// Outlines drawn as fair lines, through the whole pipeline.
#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "core/flatten/base/outline_targets.h"
#include "core/geometry/line.h"
#include "core/pattern/fair_outline.h"
#include "core/pattern/trueing.h"
#include "core/seam/find_seams.h"
#include "core/seam/seam_measure.h"
#include "core/toile/garment_flattener.h"
#include "core/toile/pipeline.h"
#include "tests/core/support/line_figures.h"
#include "tests/core/support/shapes.h"
#include "tests/core/support/shared_data.h"

namespace toile {
namespace {

LineSettings fair(double tolerance = 1) {
    LineSettings lines;
    lines.fairing = Fairing{tolerance};
    return lines;
}

Garment loaded(const std::string& name) {
    Progress progress;
    auto garment = loadGarment({test::dataFile(name)}, {}, progress);
    EXPECT_TRUE(garment);
    return garment ? std::move(*garment) : Garment{};
}

PieceResults flattened(const Garment& garment, const LineSettings& lines = {},
                       Method method = Method::Isometric) {
    Progress progress;
    return flattenGarment(garment, {method}, progress, 0, lines);
}

class DrawnLines : public testing::TestWithParam<const char*> {};

TEST_P(DrawnLines, KeepAllLengthsAndBounds) {
    TOILE_NEEDS_SHARED(test::dataFile(GetParam()));
    const Garment garment = loaded(GetParam());
    const PieceResults drawn = flattened(garment, fair());
    for (const auto& result : drawn) {
        ASSERT_TRUE(result->flat) << result->piece->name;
        ASSERT_TRUE(result->flat->line) << result->piece->name;
        EXPECT_LE(result->flat->line->farthest, 1 + 1e-9) << result->piece->name;
        EXPECT_LE(result->quality->maxTargetLengthError, 1e-9) << result->piece->name;
        EXPECT_EQ(result->quality->flippedTriangles, 0) << result->piece->name;
        EXPECT_LE(result->quality->outlineCrossings, result->exact->quality->outlineCrossings);
        const Points2 vertices = result->flat->Q(result->piece->boundary, Eigen::all);
        EXPECT_EQ(vertices, verticesOn(*result->flat->line, *result->piece));
    }
    for (const Seam& seam : garment.seams.seams) {
        if (seam.kind != SeamKind::Free && seam.left.loop == 0 && seam.right.loop == 0) {
            const PieceResult& left = *drawn[seam.left.piece];
            const PieceResult& right = *drawn[seam.right.piece];
            const SeamMeasure measure =
                measureSeam(seam, *left.piece, *left.flat, *right.piece, *right.flat);
            EXPECT_NEAR(measure.length2dLeft, seam.length3d[0], 1e-6) << seam.name;
            EXPECT_NEAR(measure.length2dRight, seam.length3d[1], 1e-6) << seam.name;
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Garments, DrawnLines,
                         testing::Values("samples/bodice.obj", "samples/trousers.obj",
                                         "samples/tshirt.obj", "garments/tee_sim.obj",
                                         "garments/dress.obj", "garments/polo.obj",
                                         "garments/longsleeve.obj", "garments/tshirt.obj"));

/// How much more uneven than the designer's panels fair lines may be, and how much further from
/// them than the exact outlines.
struct Bar {
    const char* garment;
    double variation;
};

class FairLines : public testing::TestWithParam<Bar> {};

TEST_P(FairLines, AreAsEvenAsTheDesignersAndAsNear) {
    TOILE_NEEDS_SHARED(test::dataFile(GetParam().garment));
    const Garment garment = loaded(GetParam().garment);
    const PieceResults drawn = flattened(garment, fair());
    PieceResults exact;
    for (const auto& result : drawn) {
        exact.push_back(result->exact);
    }
    const auto segments = findSegments(garment, exact, {});
    test::Variation designer, before, after;
    double squaresBefore = 0, squaresAfter = 0;
    for (std::size_t p = 0; p < drawn.size(); ++p) {
        const Piece& piece = *drawn[p]->piece;
        ASSERT_TRUE(piece.reference);
        const std::set<int> cuts = test::referenceCuts(garment, p, segments[p]);
        const Points2 reference = (*piece.reference)(piece.boundary, Eigen::all);
        const Points2 was = exact[p]->flat->Q(piece.boundary, Eigen::all);
        const Points2 is = drawn[p]->flat->Q(piece.boundary, Eigen::all);
        designer.add(reference, cuts);
        before.add(was, cuts);
        after.add(is, cuts);
        const auto n = static_cast<double>(piece.boundary.size());
        squaresBefore += n * std::pow(fitToReference(was, reference).rms, 2);
        squaresAfter += n * std::pow(fitToReference(is, reference).rms, 2);
    }
    RecordProperty("exact over designer", std::to_string(before.sum / designer.sum));
    RecordProperty("fair over designer", std::to_string(after.sum / designer.sum));
    EXPECT_LE(after.sum, GetParam().variation * designer.sum);
    EXPECT_LE(std::sqrt(squaresAfter), 1.02 * std::sqrt(squaresBefore));
}

INSTANTIATE_TEST_SUITE_P(Garments, FairLines,
                         testing::Values(Bar{"garments/tee_sim.obj", 1.2},
                                         Bar{"garments/dress.obj", 1.2},
                                         Bar{"garments/polo.obj", 1.2},
                                         Bar{"garments/longsleeve.obj", 1.3},
                                         Bar{"garments/tshirt.obj", 1.2}),
                         [](const auto& test) {
                             const std::string path = test.param.garment;
                             return path.substr(9, path.find('.') - 9);
                         });

/// What is left of a kink on the lines as they are drawn, radians.
double drawnKink(const SeamEnd& end, const std::vector<OutlineSegments>& segments,
                 const PieceResults& drawn) {
    double kink = std::numbers::pi;
    for (const OutlineCorner& corner : {end.left, end.right}) {
        const FlatLine& line = *drawn[corner.piece]->flat->line;
        const double at = segments[corner.piece].turnPoints[corner.point].at;
        const auto node =
            std::ranges::min_element(line.arc, {}, [at](double arc) { return std::abs(arc - at); });
        kink -= geometry::Line::closed(line.points)
                    .turnAt(static_cast<int>(node - line.arc.begin()) %
                            static_cast<int>(line.points.rows()));
    }
    return std::remainder(kink, 2 * std::numbers::pi);
}

TEST_P(DrawnLines, RunSmoothlyOverTheEndsOfSeamsWhereTrued) {
    TOILE_NEEDS_SHARED(test::dataFile(GetParam()));
    const Garment garment = loaded(GetParam());
    LineSettings lines = fair();
    lines.trueBelow = kProposedTrueing;
    const PieceResults drawn = flattened(garment, lines);
    PieceResults exact;
    for (const auto& result : drawn) {
        exact.push_back(result->exact);
        EXPECT_EQ(result->quality->flippedTriangles, 0);
        EXPECT_LE(result->quality->maxTargetLengthError, 1e-9);
    }
    const auto segments = findSegments(garment, exact, lines);
    double worstBefore = 0;
    int asked = 0;
    for (const SeamEnd& end : findSeamEnds(garment, segments, lines)) {
        if (end.isTrued) {
            ++asked;
            worstBefore = std::max(worstBefore, std::abs(end.kink));
            EXPECT_NEAR(drawnKink(end, segments, drawn), 0, 1e-9)
                << garment.seams.seams[end.seam].name;
        }
    }
    EXPECT_GT(asked, 0);
    EXPECT_LE(worstBefore, kProposedTrueing);
}

TEST(DrawnLinesOfAllMethods, AreAsLongAsTheirExactOutlines) {
    const Garment garment = loaded("samples/bodice.obj");
    for (const MethodTraits& method : allMethods()) {
        for (const auto& result : flattened(garment, fair(), method.method)) {
            ASSERT_TRUE(result->flat && result->flat->line) << method.name;
            const Eigen::VectorXd exact =
                boundaryLengths2d(result->exact->flat->Q, result->piece->boundary);
            EXPECT_NEAR(result->quality->perimeter2d, exact.sum(), 1e-9 * exact.sum());
            EXPECT_LE(result->quality->flippedTriangles, result->exact->quality->flippedTriangles)
                << method.name;
        }
    }
}

TEST(DrawnLinesOfSmallPieces, AreDrawnToo) {
    // A triangle, a square and a button's disc of half a millimetre.
    for (const double size : {1e-3, 0.5, 30.0, 3e4}) {
        Garment garment;
        garment.pieces = {test::asPiece(test::sphericalCap(6, 0.3 * size, 0.5), "button"),
                          test::asPiece(test::planeGrid(1, 1, size), "square")};
        garment.seams = findSeams(garment.pieces);
        for (const auto& result : flattened(garment, fair())) {
            ASSERT_TRUE(result->flat) << size;
            EXPECT_EQ(result->quality->flippedTriangles, 0) << size;
            EXPECT_EQ(result->quality->outlineCrossings, 0) << size;
            EXPECT_LE(result->quality->maxTargetLengthError, 1e-8) << size;
        }
    }
}

TEST(DrawnLinesWhileOneEdits, AreThoseOfOneCall) {
    const Garment garment = loaded("samples/bodice.obj");
    LineSettings lines = fair();
    lines.trueBelow = kProposedTrueing;
    GarmentFlattener flattener;
    Progress progress;
    const PieceResults first = flattener.flatten(garment, {}, progress, 0, {}, lines);
    Progress one;
    const PieceResults whole = flattenGarment(garment, {}, one, 1, lines);
    for (std::size_t p = 0; p < first.size(); ++p) {
        EXPECT_EQ(first[p]->flat->Q, whole[p]->flat->Q);
        EXPECT_EQ(first[p]->flat->line->points, whole[p]->flat->line->points);
    }

    // The same again is handed on.
    const PieceResults again = flattener.flatten(garment, {}, progress, 0, first, lines);
    EXPECT_EQ(again, first);
    // Of another tolerance only the lines are drawn anew; without fair lines nothing is.
    lines.fairing->tolerance = 0.5;
    const PieceResults other = flattener.flatten(garment, {}, progress, 0, first, lines);
    const PieceResults none = flattener.flatten(garment, {}, progress, 0, other, {});
    for (std::size_t p = 0; p < first.size(); ++p) {
        EXPECT_NE(other[p], first[p]);
        EXPECT_EQ(other[p]->exact, first[p]->exact);
        EXPECT_EQ(none[p], first[p]->exact);
    }
    // One piece alone, where a length is typed for one that is sewn to none but itself and others.
    const auto segments = findSegments(garment, none, {});
    LineSettings typed;
    typed.segments.push_back(
        {segments[0].segments[0].place, 1.01 * segments[0].segments[0].length()});
    const PieceResults longer = flattener.flatten(garment, {}, progress, 0, none, typed);
    EXPECT_NE(longer[0], none[0]);
    EXPECT_FALSE(longer[0]->targets == none[0]->targets);
    const PieceResults back = flattener.flatten(garment, {}, progress, 0, longer, {});
    Progress cold;
    const PieceResults settled = flattener.settle(garment, back, cold);
    for (std::size_t p = 0; p < first.size(); ++p) {
        EXPECT_EQ(settled[p]->flat->Q, first[p]->exact->flat->Q);
    }
}

TEST(DrawnLinesOfHoles, LeaveRimsAsLongAsTheyWere) {
    Garment garment;
    const MeshArrays sheet = test::bentPanel(20);
    garment.pieces = {test::asPiece(test::part(sheet, [](const Eigen::RowVector3d& p) -> bool {
        return (p.head<2>() - Eigen::RowVector2d(300, 300)).norm() > 90;
    }))};
    garment.seams = findSeams(garment.pieces);
    const PieceResults drawn = flattened(garment, fair());
    ASSERT_TRUE(drawn[0]->flat && drawn[0]->flat->line);
    ASSERT_EQ(drawn[0]->piece->holes.size(), 1U);
    const std::vector<int>& rim = drawn[0]->piece->holes[0];
    EXPECT_NEAR(boundaryLengths2d(drawn[0]->flat->Q, rim).sum(),
                boundaryLengths3d(drawn[0]->piece->mesh.V, rim).sum(), 1e-6);
}

}  // namespace
}  // namespace toile
