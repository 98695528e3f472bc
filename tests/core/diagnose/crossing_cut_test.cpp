// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/diagnose/crossing_cut.h"

#include <algorithm>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "core/flatten/base/flat_notes.h"
#include "core/flatten/flatten.h"
#include "core/quality/measures.h"
#include "tests/core/support/flat_of.h"
#include "tests/core/support/flat_trouble.h"
#include "tests/core/support/shapes.h"

namespace toile {
namespace {

using test::flatOf;

std::optional<CrossingCut> cutOf(const Piece& piece, const Points2& Q) {
    return cutForCrossings(piece, Q, findOutlineCrossings(Q, piece.boundary));
}

/// What is said of the crossings, the search for a cut done.
std::string statedOf(const Piece& piece, const Points2& Q, const Progress& progress = Progress()) {
    const auto crossings = findOutlineCrossings(Q, piece.boundary);
    const auto note = crossingNote(piece, Q, crossings);
    Problems notes;
    if (note) {
        notes.push_back(*note);
    }
    nameCrossingCut(piece, Q, crossings, progress, notes);
    return notes.empty() ? "" : notes.front().detail;
}

/// A way through the inside from outline to outline, its length true.
void expectIsACut(const Piece& piece, const CrossingCut& cut) {
    const std::set<int> rim(piece.boundary.begin(), piece.boundary.end());
    ASSERT_GE(cut.path.size(), 2);
    EXPECT_TRUE(rim.contains(cut.path.front()) && rim.contains(cut.path.back()));
    double length = 0;
    for (std::size_t k = 1; k < cut.path.size(); ++k) {
        const int v = std::min(cut.path[k - 1], cut.path[k]);
        const int w = std::max(cut.path[k - 1], cut.path[k]);
        int uses = 0;
        for (int e = 0; e < piece.table.edges.rows(); ++e) {
            if (piece.table.edges(e, 0) == v && piece.table.edges(e, 1) == w) {
                uses = piece.table.useStart[e + 1] - piece.table.useStart[e];
            }
        }
        EXPECT_EQ(uses, 2) << "an edge inside the piece";
        EXPECT_TRUE(k + 1 == cut.path.size() || !rim.contains(cut.path[k]));
        length += (piece.mesh.V.row(v) - piece.mesh.V.row(w)).norm();
    }
    EXPECT_NEAR(cut.length3d, length, 1e-9 * length);
}

/// The two parts, flattened for themselves.
Pieces partsOf(const Piece& piece, const CrossingCut& cut) {
    std::set<std::pair<int, int>> walls;
    for (std::size_t k = 1; k < cut.path.size(); ++k) {
        walls.insert(std::minmax(cut.path[k - 1], cut.path[k]));
    }
    const int faces = static_cast<int>(piece.mesh.F.rows());
    std::vector<int> part(faces, -1);
    Pieces parts;
    for (int seed = 0; seed < faces; ++seed) {
        if (part[seed] >= 0) {
            continue;
        }
        std::vector<int> here{seed};
        part[seed] = static_cast<int>(parts.size());
        for (std::size_t next = 0; next < here.size(); ++next) {
            for (int k = 0; k < 3; ++k) {
                const int e = piece.table.faceEdges(here[next], k);
                if (walls.contains({piece.table.edges(e, 0), piece.table.edges(e, 1)})) {
                    continue;
                }
                for (int u = piece.table.useStart[e]; u < piece.table.useStart[e + 1]; ++u) {
                    const int g = piece.table.use[u] / 3;
                    if (part[g] < 0) {
                        part[g] = part[seed];
                        here.push_back(g);
                    }
                }
            }
        }
        MeshArrays mesh{{}, Triangles(static_cast<int>(here.size()), 3)};
        std::map<int, int> index;
        for (std::size_t f = 0; f < here.size(); ++f) {
            for (int k = 0; k < 3; ++k) {
                const int v = piece.mesh.F(here[f], k);
                mesh.F(static_cast<int>(f), k) =
                    index.emplace(v, static_cast<int>(index.size())).first->second;
            }
        }
        mesh.V.resize(static_cast<int>(index.size()), 3);
        for (const auto& [old, now] : index) {
            mesh.V.row(now) = piece.mesh.V.row(old);
        }
        parts.push_back(test::asPiece(mesh));
    }
    return parts;
}

void expectPartsLieFlat(const Piece& piece, const CrossingCut& cut, Method method) {
    const auto parts = partsOf(piece, cut);
    ASSERT_EQ(parts.size(), 2);
    for (const auto& part : parts) {
        ASSERT_FALSE(part->defect) << sentence(*part->defect);
        EXPECT_EQ(outlineCrossings(flatOf(*part, method), part->boundary), 0);
    }
}

TEST(CrossingCut, AFlounceIsCutAcrossAboutHalfWay) {
    for (const double turn : {400.0, 420.0, 500.0, 640.0}) {
        SCOPED_TRACE(turn);
        const auto piece = test::asPiece(test::flounce(turn, 80, 200, 72, 5));
        const Points2 Q = flatOf(*piece, Method::Curvature);
        const auto cut = cutOf(*piece, Q);
        ASSERT_TRUE(cut);
        expectIsACut(*piece, *cut);
        EXPECT_TRUE(cut->resolves);
        EXPECT_NEAR(cut->length3d, 120, 1e-6);  // straight across
        const auto parts = partsOf(*piece, *cut);
        ASSERT_EQ(parts.size(), 2);
        const double share =
            triangleAreas3d(parts[0]->mesh).sum() / triangleAreas3d(piece->mesh).sum();
        EXPECT_NEAR(share, 0.5, 0.05);
        expectPartsLieFlat(*piece, *cut, Method::Curvature);
    }
}

TEST(CrossingCut, TwoTurnsAndMoreNeedMoreThanOneCut) {
    const auto piece = test::asPiece(test::flounce(800, 80, 200, 96, 4));
    const Points2 Q = flatOf(*piece, Method::Curvature);
    const auto cut = cutOf(*piece, Q);
    ASSERT_TRUE(cut);
    expectIsACut(*piece, *cut);
    EXPECT_FALSE(cut->resolves);
    EXPECT_NE(statedOf(*piece, Q).find("one cut is not enough"), std::string::npos);
}

TEST(CrossingCut, ASaddlesSlitIsCutOn) {
    for (const Method method : {Method::Wang2005, Method::Curvature}) {
        for (const double bend : {0.3, 1.0, 2.0}) {
            SCOPED_TRACE(bend);
            const auto piece = test::asPiece(test::saddleWithSlit(16, 200, bend));
            const Points2 Q = flatOf(*piece, method);
            ASSERT_FALSE(outlineIsSimple(Q, piece->boundary));
            const auto cut = cutOf(*piece, Q);
            ASSERT_TRUE(cut);
            expectIsACut(*piece, *cut);
            EXPECT_TRUE(cut->resolves);
            EXPECT_LT(cut->length3d, 320);
        }
    }
}

TEST(CrossingCut, ALongCutIsNotWorthItForEarsOfARaggedEdge) {
    // Two ears on one edge of a strip, with more than a straight angle each: they fold over the
    // strip by a few millimetres, and one cut between them would take off half of it.
    MeshArrays mesh = test::planeGrid(40, 4, 5);
    for (const int column : {10, 30}) {
        const auto rim = [&](int k) { return 4 * 41 + k; };
        const Eigen::RowVector3d at = mesh.V.row(rim(column));
        ASSERT_DOUBLE_EQ(at.y(), 20);
        const int n = static_cast<int>(mesh.V.rows()), f = static_cast<int>(mesh.F.rows());
        mesh.V.conservativeResize(n + 2, 3);
        mesh.V.row(n) = at + Eigen::RowVector3d(-0.5, 0.5, 4);
        mesh.V.row(n + 1) = at + Eigen::RowVector3d(4, 0, -3);
        mesh.F.conservativeResize(f + 2, 3);
        mesh.F.row(f) << rim(column), rim(column + 1), n;
        mesh.F.row(f + 1) << rim(column), n, n + 1;
    }
    const auto piece = test::asPiece(mesh);
    ASSERT_FALSE(piece->defect) << sentence(*piece->defect);
    const Points2 Q = flatOf(*piece, Method::Natural);
    ASSERT_EQ(outlineCrossings(Q, piece->boundary), 2);
    const auto cut = cutOf(*piece, Q);
    ASSERT_TRUE(cut);
    EXPECT_GT(cut->length3d, 40);
    EXPECT_LT(cut->folded3d, 40);
    EXPECT_FALSE(cut->isWorthIt());
    EXPECT_NE(statedOf(*piece, Q).find("smooth the edge there"), std::string::npos);
    const auto flounce = test::asPiece(test::flounce(500, 80, 200, 72, 5));
    EXPECT_TRUE(cutOf(*flounce, flatOf(*flounce, Method::Curvature))->isWorthIt());
}

TEST(CrossingCut, IsTheSameAgainAndScalesAlong) {
    const MeshArrays mesh = test::flounce(430, 80, 200, 60, 4);
    const auto piece = test::asPiece(mesh);
    const Points2 Q = flatOf(*piece, Method::Curvature);
    const auto cut = cutOf(*piece, Q);
    ASSERT_TRUE(cut);
    EXPECT_EQ(cutOf(*piece, Q)->path, cut->path);
    MeshArrays large = mesh;
    large.V *= 1024;
    EXPECT_EQ(cutOf(*test::asPiece(large), Points2(1024 * Q))->path, cut->path);
}

TEST(CrossingCut, ACancelledSearchGivesAtMostAnUntestedCut) {
    const auto piece = test::asPiece(test::flounce(500, 80, 200, 72, 5));
    const Points2 Q = flatOf(*piece, Method::Curvature);
    Progress progress;
    progress.cancel();
    const auto cut = cutForCrossings(*piece, Q, findOutlineCrossings(Q, piece->boundary), progress);
    EXPECT_FALSE(cut && cut->resolves);
    const std::string said = statedOf(*piece, Q, progress);
    EXPECT_NE(said.find("crossing"), std::string::npos) << said;
    EXPECT_EQ(said.find("cut"), std::string::npos) << said;
    EXPECT_NE(statedOf(*piece, Q).find("cut it from"), std::string::npos);
}

TEST(CrossingCut, TheSearchInALargeOutlineWithoutASingleCutGivesTheBest) {
    const auto piece = test::asPiece(test::flounce(800, 80, 200, 2500, 4));
    const Points2 Q = flatOf(*piece, Method::Curvature);
    const auto cut = cutOf(*piece, Q);
    ASSERT_TRUE(cut);
    EXPECT_FALSE(cut->resolves);
}

TEST(CrossingCut, WithoutAnInsideOnlyEdgesAcrossAreLeft) {
    const auto square = test::asPiece(test::planeGrid(1, 1, 10));
    Points2 bowTie(4, 2);
    for (int i = 0; i < 4; ++i) {
        bowTie.row(square->boundary[i]) << (i == 1 || i == 2 ? 10 : 0), (i % 2 == 0 ? 0 : 10);
    }
    const auto cut = cutOf(*square, bowTie);
    ASSERT_TRUE(cut);
    EXPECT_EQ(cut->path.size(), 2);
    MeshArrays one = test::planeGrid(1, 1, 10);
    one.F.conservativeResize(1, 3);
    one.V.row(2) = one.V.row(3);  // corners 0, 1 and 3
    one.V.conservativeResize(3, 3);
    one.F << 0, 1, 2;
    const auto triangle = test::asPiece(std::move(one));
    ASSERT_FALSE(triangle->defect);
    EXPECT_FALSE(cutForCrossings(*triangle, bowTie, {{0, 2, {0, 0}}}));
}

}  // namespace
}  // namespace toile
