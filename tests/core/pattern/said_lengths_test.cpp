// SPDX-License-Identifier: GPL-3.0-or-later
// What lines are asked to measure, they measure; all others keep their lengths.
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "core/geometry/line.h"
#include "core/pattern/segments.h"
#include "core/pattern/target_lengths.h"
#include "core/seam/seam_measure.h"
#include "core/seam/seam_settings.h"
#include "core/toile/pipeline.h"
#include "tests/core/support/shared_data.h"

namespace toile {
namespace {

class SaidLengths : public testing::Test {
protected:
    void SetUp() override {
        Progress progress;
        garment_ = *loadGarment({test::dataFile("samples/bodice.obj")}, {}, progress);
        // The longest seam between two pieces.
        for (std::size_t s = 0; s < garment_.seams.seams.size(); ++s) {
            const Seam& seam = garment_.seams.seams[s];
            const bool isOne = seam.kind == SeamKind::Seam && seam.left.piece != seam.right.piece;
            if (isOne && (seam_ < 0 || seam.length3d[0] > sewn().length3d[0])) {
                seam_ = static_cast<int>(s);
            }
        }
        ASSERT_GE(seam_, 0);
    }

    const Seam& sewn() const { return garment_.seams.seams[static_cast<std::size_t>(seam_)]; }

    void draw(double ease, SeamPart part = {}) {
        garment_ = *easedGarment(garment_, withEase({}, sewn(), ease, part));
    }

    PieceResults flattened(const LineSettings& lines = {}, Method method = Method::Isometric) {
        Progress progress;
        return flattenGarment(garment_, {method}, progress, 0, lines);
    }

    double flatLengthOf(const SeamSide& side, const PieceResults& results) const {
        const PieceResult& result = *results[static_cast<std::size_t>(side.piece)];
        return flatLength(side, *result.piece, *result.flat);
    }

    void expectOthersUnchanged(const PieceResults& results) const {
        for (std::size_t s = 0; s < garment_.seams.seams.size(); ++s) {
            const Seam& seam = garment_.seams.seams[s];
            if (static_cast<int>(s) == seam_) {
                continue;
            }
            EXPECT_NEAR(flatLengthOf(seam.left, results), seam.length3d[0], 1e-7) << seam.name;
            if (seam.right.piece >= 0) {
                EXPECT_NEAR(flatLengthOf(seam.right, results), seam.length3d[1], 1e-7) << seam.name;
            }
        }
    }

    Garment garment_;
    int seam_ = -1;
};

TEST_F(SaidLengths, AreThoseIn3dUnlessSomethingIsSaid) {
    for (const OutlineTargets& targets : outlineTargets(garment_, {})) {
        EXPECT_EQ(targets.lengths.size(), 0);
    }
    garment_ = *easedGarment(garment_, withEase({}, sewn(), 0.05));  // stated, not drawn
    for (const OutlineTargets& targets : outlineTargets(garment_, {})) {
        EXPECT_EQ(targets.lengths.size(), 0);
    }
}

TEST_F(SaidLengths, DrawnEaseMakesTheLongerSideLonger) {
    for (const Method method : {Method::Isometric, Method::Curvature, Method::Wang2005}) {
        for (const double ease : {0.05, -0.08}) {
            draw(ease);
            const PieceResults results = flattened({}, method);
            const double left = flatLengthOf(sewn().left, results);
            const double right = flatLengthOf(sewn().right, results);
            EXPECT_NEAR(left, (1 + ease) * right, 1e-9 * left);
            EXPECT_NEAR(ease > 0 ? right : left, sewn().length3d[ease > 0 ? 1 : 0], 1e-9 * left);
            EXPECT_NEAR(measured(garment_, results, seam_)->errorMm, 0, 1e-6);
            expectOthersUnchanged(results);
        }
    }
}

TEST_F(SaidLengths, EaseIsDrawnBetweenTwoPoints) {
    const SeamPart part{0.3, 0.6};
    draw(0.04, part);
    const PieceResults results = flattened();
    const SeamSide& side = sewn().left;
    EXPECT_NEAR(flatLengthOf(side, results), 1.04 * flatLengthOf(sewn().right, results), 1e-6);
    // Vertices before and after the part are as far apart as in 3D.
    const PieceResult& result = *results[static_cast<std::size_t>(side.piece)];
    const auto from = std::min(side.start, side.end) + part.from * side.length();
    const Eigen::VectorXd& lengths = result.targets.lengths;
    const Piece& piece = *result.piece;
    const auto n = static_cast<Eigen::Index>(piece.boundary.size());
    double at = 0, changed = 0;
    for (Eigen::Index k = 0; k < n; ++k) {
        const double in3d =
            (piece.mesh.V.row(piece.boundary[(k + 1) % n]) - piece.mesh.V.row(piece.boundary[k]))
                .norm();
        const bool isOut = at + in3d < from || at > from + (part.to - part.from) * side.length();
        if (isOut) {
            EXPECT_NEAR(lengths[k], in3d, 1e-12);
        }
        changed += lengths[k] - in3d;
        at += in3d;
    }
    EXPECT_NEAR(changed, 0.04 * sewn().length3d[1] + sewn().length3d[1] - sewn().length3d[0], 1e-9);
    expectOthersUnchanged(results);
}

TEST_F(SaidLengths, ATypedLengthHoldsOnBothSidesOfItsSeam) {
    const auto segments = findSegments(garment_, flattened(), {});
    LineSettings lines;
    for (const Segment& segment : segments[static_cast<std::size_t>(sewn().left.piece)].segments) {
        if (segment.seam == seam_) {
            lines.segments.push_back({segment.place, 1.02 * segment.length()});
        }
    }
    ASSERT_FALSE(lines.segments.empty());
    for (const bool isFair : {false, true}) {
        lines.fairing = isFair ? std::optional(Fairing{}) : std::nullopt;
        const PieceResults results = flattened(lines);
        EXPECT_NEAR(flatLengthOf(sewn().left, results), 1.02 * sewn().length3d[0], 1e-6);
        EXPECT_NEAR(flatLengthOf(sewn().right, results), 1.02 * sewn().length3d[1], 1e-6);
        expectOthersUnchanged(results);
        for (const auto& result : results) {
            EXPECT_LE(result->quality->maxTargetLengthError, 1e-9);
            EXPECT_EQ(result->quality->flippedTriangles, 0);
        }
    }
}

TEST_F(SaidLengths, AStraightSegmentIsStraightAndAsLong) {
    const auto segments = findSegments(garment_, flattened(), {});
    const std::size_t piece = static_cast<std::size_t>(sewn().left.piece);
    LineSettings lines;
    lines.fairing = Fairing{};
    std::vector<Segment> asked;
    for (const Segment& segment : segments[piece].segments) {
        if (segment.seam == seam_) {
            lines.segments.push_back({segment.place, {}, {}, true});
            asked.push_back(segment);
        }
    }
    const PieceResults results = flattened(lines);
    const FlatLine& line = *results[piece]->flat->line;
    for (const Segment& segment : asked) {
        const Points2 drawn =
            geometry::Line::closed(line.points, line.arc).part(segment.at.start, segment.at.end);
        const Eigen::RowVector2d whole = drawn.bottomRows<1>() - drawn.topRows<1>();
        EXPECT_NEAR(whole.norm(), segment.length(), 1e-9 * segment.length());
    }
    for (const auto& result : results) {
        EXPECT_LE(result->quality->maxTargetLengthError, 1e-9);
        EXPECT_EQ(result->quality->flippedTriangles, 0);
    }
}

}  // namespace
}  // namespace toile
