// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <memory>
#include <string>

#include <gtest/gtest.h>

#include "core/base/sanitized.h"
#include "core/base/units.h"
#include "core/flatten/flatten.h"
#include "core/quality/measures.h"
#include "core/quality/piece_quality.h"
#include "tests/core/support/random_piece.h"
#include "tests/core/support/shapes.h"

namespace toile {
namespace {

constexpr unsigned kSeeds = 1000, kSeedsOfAShard = 50;
const unsigned kQuickShards = isSanitized() ? 1 : 3;
const unsigned kShards = isSanitized() ? 1 : kSeeds / kSeedsOfAShard;
constexpr std::array kMethods = {Method::Wang2005, Method::Curvature, Method::Isometric};
constexpr std::array kSolvers = {BoundarySolver::Newton, BoundarySolver::Slcp};

Result<FlatPiece> flatBy(const Piece& piece, Method method, BoundarySolver solver) {
    FlattenOptions options;
    options.method = method;
    options.boundarySolver = solver;
    Progress progress;
    return flatten(piece, options, progress);
}

TEST(RandomPieces, AreDisksOfEverySize) {
    Eigen::Index fewest = 1000;
    Eigen::Index most = 0;
    for (unsigned seed = 0; seed < kSeeds; ++seed) {
        const auto piece = test::asPiece(test::randomPiece(seed));
        ASSERT_FALSE(piece->defect) << seed << ": " << sentence(*piece->defect);
        fewest = std::min(fewest, piece->mesh.F.rows());
        most = std::max(most, piece->mesh.F.rows());
    }
    EXPECT_LT(fewest, 40);
    EXPECT_GT(most, 500);
}

/// A stretch of the seeds: several processors share the work.
class ShardOfRandomPieces : public testing::TestWithParam<unsigned> {
protected:
    unsigned first() const { return GetParam() * kSeedsOfAShard; }
    unsigned end() const { return first() + kSeedsOfAShard; }
};

INSTANTIATE_TEST_SUITE_P(RandomPieces, ShardOfRandomPieces, testing::Range(0U, kQuickShards));
INSTANTIATE_TEST_SUITE_P(RandomPiecesSlow, ShardOfRandomPieces,
                         testing::Range(kQuickShards, kShards));

TEST_P(ShardOfRandomPieces, KeepTheLengthsOfTheirOutlines) {
    for (unsigned seed = first(); seed < end(); ++seed) {
        const auto piece = test::asPiece(test::randomPiece(seed));
        const Eigen::VectorXd lengths = boundaryLengths3d(piece->mesh.V, piece->boundary);
        for (const Method method : kMethods) {
            for (const BoundarySolver solver : kSolvers) {
                SCOPED_TRACE("seed " + std::to_string(seed) + " " + std::string(name(method)) +
                             " " + std::string(name(solver)));
                const auto flat = flatBy(*piece, method, solver);
                ASSERT_TRUE(flat) << sentence(flat.error());
                ASSERT_TRUE(flat->Q.allFinite());
                EXPECT_LE(flat->closureGap, kClosureTolerance);
                EXPECT_LE(
                    maxRelativeLengthError(lengths, boundaryLengths2d(flat->Q, piece->boundary)),
                    1e-9);
            }
        }
    }
}

bool wasMovedApart(const FlatPiece& flat) {
    return std::any_of(flat.notes.begin(), flat.notes.end(),
                       [](const Error& note) { return note.code == ErrorCode::OutlineUncrossed; });
}

/// Worse than its start in distortion only where it moved a crossing outline apart.
TEST_P(ShardOfRandomPieces, NeverFlipByIsometricAndAreNeverWorse) {
    for (unsigned seed = first(); seed < end(); ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        const auto piece = test::asPiece(test::randomPiece(seed));
        const auto isometric = flatBy(*piece, Method::Isometric, BoundarySolver::Newton);
        ASSERT_TRUE(isometric) << sentence(isometric.error());
        const PieceQuality quality = measure(*piece, isometric->Q);
        EXPECT_EQ(quality.flippedTriangles, 0);
        ASSERT_TRUE(quality.symmetricDirichlet);
        const auto curvature = flatBy(*piece, Method::Curvature, BoundarySolver::Newton);
        ASSERT_TRUE(curvature);
        const auto limit = measure(*piece, curvature->Q).symmetricDirichlet;  // none with flips
        if (limit && !wasMovedApart(*isometric)) {
            EXPECT_LE(*quality.symmetricDirichlet, *limit * (1 + 1e-9));
        }
    }
}

}  // namespace
}  // namespace toile
