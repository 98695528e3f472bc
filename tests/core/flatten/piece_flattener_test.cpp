// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <memory>
#include <random>
#include <string>

#include <gtest/gtest.h>

#include "core/flatten/base/match_versions.h"
#include "core/flatten/flatten.h"
#include "core/quality/measures.h"
#include "core/quality/piece_quality.h"
#include "tests/core/support/piece_edits.h"
#include "tests/core/support/random_piece.h"
#include "tests/core/support/shapes.h"
#include "tests/core/support/turned_triangles.h"

namespace toile {
namespace {

using PiecePointer = std::shared_ptr<const Piece>;

FlattenOptions by(Method method) {
    FlattenOptions options;
    options.method = method;
    return options;
}

double extentOf(const Points2& Q) {
    return (Q.colwise().maxCoeff() - Q.colwise().minCoeff()).norm();
}

/// Edits of every kind, each of the version before, by chance.
class Editor {
public:
    Editor(PiecePointer original, unsigned seed) : original_(std::move(original)), random_(seed) {}

    PiecePointer next() {
        switch (below(5)) {
            case 0: {
                const int length = 2 + below(8);
                cuts_.push_back(test::dartAlongEdges(*original_, rim(), length));
                break;
            }
            case 1: {
                const int length = 2 + below(8);
                cuts_.push_back(test::straightDart(*original_, rim(), length));
                break;
            }
            case 2:
                if (!cuts_.empty()) {
                    cuts_.erase(cuts_.begin() + below(static_cast<int>(cuts_.size())));
                }
                break;
            case 3:
                move(original_->boundary[rim()]);
                break;
            default:
                move(below(static_cast<int>(original_->mesh.V.rows())));
        }
        return cuts_.empty() ? original_ : test::opened(*original_, cuts_);
    }

private:
    int below(int bound) { return std::uniform_int_distribution<int>(0, bound - 1)(random_); }
    int rim() { return below(static_cast<int>(original_->boundary.size())); }

    /// Drags a vertex; the cuts stay where they are in their triangles.
    void move(int vertex) {
        const Points3& V = original_->mesh.V;
        const double edge =
            (V.row(original_->mesh.F(0, 0)) - V.row(original_->mesh.F(0, 1))).norm();
        const int across = below(3) - 1, along = below(3) - 1;
        original_ =
            test::dragged(*original_, vertex, 0.1 * edge * Eigen::RowVector3d(along, across, 1));
    }

    PiecePointer original_;
    std::vector<PathPolyline> cuts_;
    std::mt19937 random_;
};

bool hasFlatTriangle(const Piece& piece, const Points2& Q) {
    const Eigen::VectorXd areas = triangleAreas2d(Q, piece.mesh.F);
    return areas.cwiseAbs().minCoeff() <= 1e-12 * areas.cwiseAbs().maxCoeff();
}

void expectAsCold(PieceFlattener& flattener, const PiecePointer& piece, Method method,
                  double tolerance = 1e-9) {
    if (piece->defect) {
        return;  // a cut that separates a corner, or leaves no disk, is another test's
    }
    const auto cold = flatten(*piece, by(method), Progress());
    const auto again = flattener.flatten(piece, by(method), Progress());
    ASSERT_EQ(again.ok(), cold.ok());
    if (!cold) {
        EXPECT_EQ(again.error().code, cold.error().code);
        return;
    }
    if (again->delaunayFlips != cold->delaunayFlips) {
        // Which weights do better is a matter of rounding where a triangle has no area.
        EXPECT_TRUE(hasFlatTriangle(*piece, again->delaunayFlips > 0 ? again->Q : cold->Q));
        return;
    }
    EXPECT_LE((again->Q - cold->Q).lpNorm<Eigen::Infinity>(), tolerance * extentOf(cold->Q));
}

TEST(PieceFlattener, GivesWhatAColdSolveGivesAfterEveryEdit) {
    for (const Method method : {Method::Curvature, Method::Wang2005}) {
        for (unsigned seed = 0; seed < 6; ++seed) {
            SCOPED_TRACE(std::string(name(method)) + ", seed " + std::to_string(seed));
            const bool isLarge = seed == 0;
            Editor editor(test::originalPiece(isLarge ? test::bentPanel(90) : test::bentPanel(20)),
                          seed);
            PieceFlattener flattener;
            for (int k = 0; k < (isLarge ? 12 : 40); ++k) {
                expectAsCold(flattener, editor.next(), method);
            }
        }
    }
}

TEST(PieceFlattener, GivesWhatAColdSolveGivesOnPiecesOfEveryKind) {
    for (unsigned seed = 0; seed < 60; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Editor editor(test::originalPiece(test::randomPiece(seed)), seed);
        PieceFlattener flattener;
        for (int k = 0; k < 6; ++k) {
            expectAsCold(flattener, editor.next(), Method::Curvature);
        }
    }
}

TEST(PieceFlattener, GivesWhatAColdSolveGivesWhereTrianglesFlip) {
    for (const Method method : {Method::Curvature, Method::Wang2005}) {
        int turned = 0;
        for (unsigned seed = 0; seed < 3; ++seed) {
            SCOPED_TRACE(std::string(name(method)) + ", seed " + std::to_string(seed));
            MeshArrays rough = test::planeGrid(30, 16, 20);
            std::mt19937 random(seed);
            const auto noise = [&random] { return 2.0 * random() / std::mt19937::max() - 1; };
            for (int v = 0; v < rough.V.rows(); ++v) {
                const bool isInside = v % 31 > 0 && v % 31 < 30 && v / 31 > 0 && v / 31 < 16;
                rough.V.row(v) +=
                    Eigen::RowVector3d(6 * noise(), 6 * noise(), isInside ? 60 * noise() : 0);
            }
            Editor editor(test::originalPiece(std::move(rough)), seed);
            PieceFlattener flattener;
            for (int k = 0; k < 8; ++k) {
                const PiecePointer piece = editor.next();
                expectAsCold(flattener, piece, method);
                const auto flat = flatten(*piece, by(method), Progress());
                turned += flat && flat->delaunayFlips > 0 ? 1 : 0;
            }
        }
        EXPECT_GT(turned, 5);
    }
}

TEST(PieceFlattener, GivesTheEnergyOfAColdSolveWithinItsTolerance) {
    for (const Quality quality : {Quality::Standard, Quality::Fine}) {
        FlattenOptions options = by(Method::Isometric);
        options.quality = quality;
        const double tolerance = quality == Quality::Standard ? 2e-3 : 1e-4;
        for (unsigned seed = 0; seed < 3; ++seed) {
            SCOPED_TRACE("seed " + std::to_string(seed));
            Editor editor(test::originalPiece(test::bentPanel(14)), seed);
            PieceFlattener flattener;
            for (int k = 0; k < 8; ++k) {
                const PiecePointer piece = editor.next();
                if (piece->defect) {
                    continue;
                }
                const auto cold = flatten(*piece, options, Progress());
                const auto again = flattener.flatten(piece, options, Progress());
                ASSERT_TRUE(cold);
                ASSERT_TRUE(again);
                const PieceQuality expected = measure(*piece, cold->Q);
                const PieceQuality found = measure(*piece, again->Q);
                EXPECT_EQ(found.flippedTriangles, 0);
                EXPECT_LE(found.maxBoundaryLengthError, 1e-9);
                EXPECT_EQ(found.outlineCrossings > 0, expected.outlineCrossings > 0);
                EXPECT_LE(*found.symmetricDirichlet - 1,
                          (1 + tolerance) * (*expected.symmetricDirichlet - 1));
            }
        }
    }
}

TEST(PieceFlattener, NeedsFewerStepsAfterASmallEdit) {
    const PiecePointer cap = test::originalPiece(test::sphericalCap(30, 90, 2.4));
    PieceFlattener flattener;
    ASSERT_TRUE(flattener.flatten(cap, by(Method::Isometric), Progress()));
    const PiecePointer moved = test::dragged(*cap, test::deepestVertex(*cap), {0.1, 0.2, 0.1});
    const auto again = flattener.flatten(moved, by(Method::Isometric), Progress());
    const auto cold = flatten(*moved, by(Method::Isometric), Progress());
    ASSERT_TRUE(again);
    ASSERT_TRUE(cold);
    EXPECT_LT(again->interiorIterations, cold->interiorIterations);
}

TEST(PieceFlattener, KeepsWhatIsometricCanUseUntilItIsReset) {
    const PiecePointer panel = test::originalPiece(test::bentPanel(30));
    PieceFlattener flattener;
    EXPECT_EQ(flattener.keptBytes(), 0U);
    ASSERT_TRUE(flattener.flatten(panel, by(Method::Isometric), Progress()));
    EXPECT_GT(flattener.keptBytes(), 0U);
    expectAsCold(flattener, panel, Method::Wang2005);
    expectAsCold(flattener, panel, Method::Convex);
    flattener = PieceFlattener();
    EXPECT_EQ(flattener.keptBytes(), 0U);
}

TEST(PieceFlattener, FillsHolesAsAColdSolveDoes) {
    MeshArrays panel = test::bentPanel(24);
    Triangles without(panel.F.rows() - 8, 3);
    Eigen::Index kept = 0;
    for (int f = 0; f < panel.F.rows(); ++f) {  // a hole of two squares by two
        const int square = f / 2;
        const bool isHole = std::abs(square % 24 - 11.5) < 1 && std::abs(square / 24 - 11.5) < 1;
        if (!isHole) {
            without.row(kept++) = panel.F.row(f);
        }
    }
    ASSERT_EQ(kept, without.rows());
    panel.F = without;
    // The vertex in the middle of the hole goes.
    const int middle = 12 * 25 + 12;
    panel.V.row(middle) = panel.V.row(panel.V.rows() - 1);
    panel.F = panel.F.unaryExpr([&](int v) -> int { return v == panel.V.rows() - 1 ? middle : v; });
    panel.V.conservativeResize(panel.V.rows() - 1, 3);
    Editor editor(test::originalPiece(panel), 3);
    PieceFlattener flattener;
    for (int k = 0; k < 12; ++k) {
        expectAsCold(flattener, editor.next(), Method::Curvature);
    }
}

/// The piece with one vertex drawn so near to an edge opposite that the triangle between is a
/// needle: the cotangent of its sharp angles.
PiecePointer withNeedle(const Piece& piece, double cotangent) {
    const int v = test::deepestVertex(piece);
    for (int f = 0; f < piece.mesh.F.rows(); ++f) {
        for (int k = 0; k < 3; ++k) {
            if (piece.mesh.F(f, k) != v) {
                continue;
            }
            const Eigen::RowVector3d a = piece.mesh.V.row(piece.mesh.F(f, (k + 1) % 3));
            const Eigen::RowVector3d b = piece.mesh.V.row(piece.mesh.F(f, (k + 2) % 3));
            const Eigen::RowVector3d middle = (a + b) / 2;
            const Eigen::RowVector3d at = piece.mesh.V.row(v);
            const double height = (b - a).norm() / 2 / cotangent;
            return test::dragged(piece, v, middle + height * (at - middle).normalized() - at);
        }
    }
    return nullptr;
}

TEST(PieceFlattener, SucceedsWhereAColdSolveDoesWhenANeedleComesIn) {
    for (const int side : {12, 40}) {
        const PiecePointer panel = test::originalPiece(test::bentPanel(side));
        for (const Method method : {Method::Curvature, Method::Wang2005}) {
            for (int exponent = 2; exponent <= 16; ++exponent) {
                SCOPED_TRACE("cotangent 1e" + std::to_string(exponent));
                const double cotangent = std::pow(10.0, exponent);
                const PiecePointer needle = withNeedle(*panel, cotangent);
                PieceFlattener flattener;
                ASSERT_TRUE(flattener.flatten(panel, by(method), Progress()));
                // Rounding of the large weights is all that the other vertices' have to say there.
                expectAsCold(flattener, needle, method, std::max(1e-9, 1e-15 * cotangent));
                expectAsCold(flattener, panel, method);
            }
        }
    }
}

TEST(PieceFlattener, RepeatsTheFiguresOfTheStart) {
    const PiecePointer saddle = test::originalPiece(test::saddle(16, 200, 1.2));
    PieceFlattener flattener;
    const auto first = flattener.flatten(saddle, by(Method::Isometric), Progress());
    ASSERT_TRUE(first);
    EXPECT_GT(first->closureGap, 0);
    const PiecePointer moved =
        test::dragged(*saddle, test::deepestVertex(*saddle), {0.1, 0.2, 0.1});
    const auto again = flattener.flatten(moved, by(Method::Isometric), Progress());
    ASSERT_TRUE(again);
    EXPECT_EQ(again->boundaryIterations, first->boundaryIterations);
    EXPECT_EQ(again->boundarySolver, first->boundarySolver);
    EXPECT_EQ(again->closureGap, first->closureGap);
    EXPECT_EQ(again->delaunayFlips, first->delaunayFlips);
}

TEST(PieceFlattener, BeginsAnewWhereTheCarriedPositionsAreStrainedMuch) {
    const PiecePointer panel = test::originalPiece(test::bentPanel(20));
    PieceFlattener flattener;
    ASSERT_TRUE(flattener.flatten(panel, by(Method::Isometric), Progress()));
    MeshArrays pulled = panel->mesh;
    pulled.V.col(0) *= 3;  // the same vertices and triangles, another shape
    const PiecePointer other = test::originalPiece(std::move(pulled));
    const auto cold = flatten(*other, by(Method::Isometric), Progress());
    const Progress whole;
    const Progress half(whole, 0.5);
    const auto again = flattener.flatten(other, by(Method::Isometric), half);
    ASSERT_TRUE(cold);
    ASSERT_TRUE(again);
    EXPECT_TRUE((again->Q.array() == cold->Q.array()).all());
    EXPECT_LE(whole.fraction(), 0.5 + 1e-12);
}

TEST(PieceFlattener, AnErrorLeavesWhatIsKept) {
    const PiecePointer panel = test::originalPiece(test::bentPanel(20));
    PieceFlattener flattener;
    ASSERT_TRUE(flattener.flatten(panel, by(Method::Isometric), Progress()));
    const std::size_t kept = flattener.keptBytes();
    EXPECT_FALSE(
        flattener.flatten(test::asPiece(test::tube(8, 3)), by(Method::Isometric), Progress()));
    Progress cancelled;
    cancelled.cancel();
    EXPECT_FALSE(flattener.flatten(panel, by(Method::Isometric), cancelled));
    EXPECT_EQ(flattener.keptBytes(), kept);
}

TEST(MatchVersions, TellsTheSidesOfACutApart) {
    const PiecePointer panel = test::originalPiece(test::bentPanel(16));
    for (const bool isStraight : {false, true}) {
        const auto path =
            isStraight ? test::straightDart(*panel, 5, 6) : test::dartAlongEdges(*panel, 5, 6);
        const PiecePointer cut = test::opened(*panel, {path});
        const VersionMatch opened = matchVersions(*cut, *panel);
        ASSERT_TRUE(opened.complete);
        const auto flatBefore = flatten(*panel, by(Method::Curvature), Progress());
        const auto carried = carriedOver(opened, *panel, flatBefore->Q);
        ASSERT_TRUE(carried);
        EXPECT_EQ(test::turnedTriangles(*carried, cut->mesh.F), 0);
        // A second edit elsewhere: everything finds itself, each side its own.
        const PiecePointer moved = test::dragged(*cut, cut->boundary.back(), {1, 1, 1});
        const VersionMatch same = matchVersions(*moved, *cut);
        for (std::size_t v = 0; v < same.vertex.size(); ++v) {
            EXPECT_EQ(same.vertex[v], static_cast<int>(v));
        }
        const PiecePointer both = test::opened(*panel, {path, test::dartAlongEdges(*panel, 40, 4)});
        const VersionMatch again = matchVersions(*both, *cut);
        ASSERT_TRUE(again.complete);
        const auto flatCut = flatten(*cut, by(Method::Curvature), Progress());
        const auto onBoth = carriedOver(again, *cut, flatCut->Q);
        ASSERT_TRUE(onBoth);
        EXPECT_EQ(test::turnedTriangles(*onBoth, both->mesh.F), 0);
    }
}

TEST(MatchVersions, TakesAFaceOfTheFileWithVeryManyTriangles) {
    Piece polygon = *test::originalPiece(test::bentPanel(16));
    std::fill(polygon.sourceFace.begin(), polygon.sourceFace.end(), 0);
    const auto before = std::make_shared<const Piece>(polygon);
    const PiecePointer cut = test::opened(*before, {test::dartAlongEdges(*before, 5, 6)});
    const VersionMatch match = matchVersions(*cut, *before);
    int matched = 0;
    for (std::size_t v = 0; v < match.vertex.size(); ++v) {
        if (match.vertex[v] >= 0) {
            ++matched;
            EXPECT_EQ(cut->sourceVertex[v], before->sourceVertex[match.vertex[v]]);
        }
    }
    EXPECT_GT(matched, 0);
}

TEST(MatchVersions, FindsNothingInAnotherPiece) {
    const auto match = matchVersions(*test::asPiece(test::saddle(5, 10, 1)),
                                     *test::originalPiece(test::bentPanel(5)));
    EXPECT_FALSE(match.complete);
}

}  // namespace
}  // namespace toile
