// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/core/toile/mirror_images.h"

#include <limits>

#include <gtest/gtest.h>

#include "core/pattern/fair_outline.h"
#include "core/seam/seam_measure.h"

namespace toile::test {
namespace {

constexpr double kMirrorImage = 1e-9, kSameSeam = 1e-6;  // mm

Points2 imageOf(const Points2& points) {
    Points2 image = points.colwise().reverse();
    image.col(0) *= -1;
    return image;
}

Points2 rolled(const Points2& points, Eigen::Index by) {
    Points2 rolled(points.rows(), 2);
    rolled << points.bottomRows(points.rows() - by), points.topRows(by);
    return rolled;
}

/// The shift at which the points of two closed lines lie alike about their means.
Eigen::Index shiftOf(const Points2& points, const Points2& onto) {
    const auto radii = [](const Points2& of) -> Eigen::VectorXd {
        return (of.rowwise() - of.colwise().mean()).rowwise().norm();
    };
    const Eigen::VectorXd a = radii(points), b = radii(onto);
    const Eigen::Index n = a.size();
    Eigen::Index best = 0;
    double least = std::numeric_limits<double>::infinity();
    for (Eigen::Index by = 0; by < n; ++by) {
        const double off = (a.tail(n - by) - b.head(n - by)).squaredNorm() +
                           (a.head(by) - b.tail(by)).squaredNorm();
        if (off < least) {
            best = by;
            least = off;
        }
    }
    return best;
}

/// How far a line's mirror image lies from another, once it is laid over it, mm.
double apart(const FlatLine& line, const FlatLine& other) {
    if (line.points.rows() != other.points.rows()) {
        return std::numeric_limits<double>::infinity();
    }
    const Points2 image = imageOf(line.points);
    const Points2 shifted = rolled(image, shiftOf(image, other.points));
    return (laidOver(shifted, other.points) - other.points).rowwise().norm().maxCoeff();
}

}  // namespace

std::vector<bool> areMirrored(const PieceResults& results) {
    std::vector<bool> is(results.size());
    for (std::size_t p = 0; p < is.size(); ++p) {
        is[p] = results[p]->plan && results[p]->plan->mirrored;
    }
    return is;
}

void expectMirrorImages(const Garment& garment, const Symmetry& symmetry,
                        const PieceResults& results) {
    const std::vector<bool> is = areMirrored(results);
    for (std::size_t p = 0; p < is.size(); ++p) {
        if (is[p]) {
            const auto other = static_cast<std::size_t>(symmetry.pieces.counterpart[p]);
            ASSERT_TRUE(results[p]->flat->line) << garment.pieces[p]->name;
            EXPECT_LT(apart(*results[p]->flat->line, *results[other]->flat->line), kMirrorImage)
                << garment.pieces[p]->name;
        }
    }
}

void expectLengths(const Garment& garment, const PieceResults& results) {
    for (const auto& result : results) {
        ASSERT_TRUE(result->flat) << result->piece->name;
        EXPECT_LE(result->quality->maxTargetLengthError, 1e-9) << result->piece->name;
        EXPECT_EQ(result->quality->flippedTriangles, 0) << result->piece->name;
        for (const Error& note : result->flat->notes) {
            EXPECT_NE(note.code, ErrorCode::LineNotDrawn) << result->piece->name;
        }
    }
    for (const Seam& seam : garment.seams.seams) {
        if (seam.kind == SeamKind::Free || seam.left.loop != 0 || seam.right.loop != 0) {
            continue;
        }
        const PieceResult& left = *results[seam.left.piece];
        const PieceResult& right = *results[seam.right.piece];
        const SeamMeasure measure =
            measureSeam(seam, *left.piece, *left.flat, *right.piece, *right.flat);
        const double ratio = seam.length3d[1] / seam.length3d[0];
        EXPECT_NEAR(measure.length2dRight, ratio * measure.length2dLeft, kSameSeam) << seam.name;
    }
}

}  // namespace toile::test
