// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/assemble/join_pieces.h"

#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <random>
#include <utility>

#include <gtest/gtest.h>

#include "core/quality/measures.h"
#include "tests/core/support/shapes.h"

namespace toile {
namespace {

using Points = std::vector<Eigen::Vector3d>;

/// A piece that knows where it comes from; vertex v stands for position `first` + v of the file.
std::shared_ptr<const Piece> sourced(MeshArrays mesh, const std::string& name, int first = 0) {
    auto piece = std::make_shared<Piece>(makePiece(name, std::move(mesh)));
    for (int v = 0; v < piece->mesh.V.rows(); ++v) {
        piece->sourceVertex.push_back(first + v);
    }
    for (int f = 0; f < piece->mesh.F.rows(); ++f) {
        piece->sourceFace.push_back(first + f);
    }
    return piece;
}

/// The faces of a mesh whose middle the rule puts in `part`, with the vertices they use.
template <class Rule>
std::shared_ptr<const Piece> partOf(const MeshArrays& mesh, const std::string& name,
                                    const Rule& rule) {
    Piece part;
    std::map<int, int> number;
    std::vector<Eigen::RowVector3d> V;
    std::vector<Eigen::RowVector3i> F;
    std::vector<int> sourceVertex, sourceFace;
    for (int f = 0; f < mesh.F.rows(); ++f) {
        Eigen::Vector3d middle = Eigen::Vector3d::Zero();
        for (int k = 0; k < 3; ++k) {
            middle += mesh.V.row(mesh.F(f, k)).transpose() / 3;
        }
        if (!rule(middle)) {
            continue;
        }
        Eigen::RowVector3i face;
        for (int k = 0; k < 3; ++k) {
            const int v = mesh.F(f, k);
            const auto [entry, isNew] = number.emplace(v, static_cast<int>(V.size()));
            if (isNew) {
                V.emplace_back(mesh.V.row(v));
                sourceVertex.push_back(v);
            }
            face[k] = entry->second;
        }
        F.push_back(face);
        sourceFace.push_back(f);
    }
    MeshArrays arrays{Points3(V.size(), 3), Triangles(F.size(), 3)};
    for (std::size_t i = 0; i < V.size(); ++i) {
        arrays.V.row(static_cast<Eigen::Index>(i)) = V[i];
    }
    for (std::size_t i = 0; i < F.size(); ++i) {
        arrays.F.row(static_cast<Eigen::Index>(i)) = F[i];
    }
    part = makePiece(name, std::move(arrays));
    part.sourceVertex = std::move(sourceVertex);
    part.sourceFace = std::move(sourceFace);
    return std::make_shared<const Piece>(std::move(part));
}

MeshArrays cap() {
    return test::sphericalCap(8, 100, std::numbers::pi / 3);
}

bool isRight(const Eigen::Vector3d& p) {
    return p.x() > 0;
}

bool isLeft(const Eigen::Vector3d& p) {
    return p.x() <= 0;
}

/// Along the rim that both halves of a mesh have in common, from one end to the other.
Points commonRim(const Piece& a, const Piece& b) {
    Points rim;
    for (const int v : a.boundary) {
        for (const int w : b.boundary) {
            if (a.mesh.V.row(v) == b.mesh.V.row(w)) {
                rim.emplace_back(a.mesh.V.row(v).transpose());
            }
        }
    }
    // The outline may begin in the middle of it.
    for (std::size_t i = 1; i < rim.size(); ++i) {
        if ((rim[i] - rim[i - 1]).norm() > 60) {
            std::rotate(rim.begin(), rim.begin() + static_cast<std::ptrdiff_t>(i), rim.end());
        }
    }
    return rim;
}

double areaOf(const Piece& piece) {
    return triangleAreas3d(piece.mesh).sum();
}

/// Vertex by vertex and face by face the piece is a part of the mesh it came from.
void expectSourcesHold(const Piece& piece, const MeshArrays& source) {
    ASSERT_EQ(static_cast<Eigen::Index>(piece.sourceVertex.size()), piece.mesh.V.rows());
    ASSERT_EQ(static_cast<Eigen::Index>(piece.sourceFace.size()), piece.mesh.F.rows());
    for (Eigen::Index v = 0; v < piece.mesh.V.rows(); ++v) {
        EXPECT_EQ(piece.mesh.V.row(v), source.V.row(piece.sourceVertex[v]));
    }
    for (Eigen::Index f = 0; f < piece.mesh.F.rows(); ++f) {
        for (int k = 0; k < 3; ++k) {
            EXPECT_EQ(piece.sourceVertex[piece.mesh.F(f, k)], source.F(piece.sourceFace[f], k));
        }
    }
}

TEST(JoinPieces, HandOnPiecesWithoutJoinsByPointer) {
    const Pieces pieces{sourced(test::planeGrid(2, 2, 10), "a"), sourced(test::tube(8, 2), "b")};
    const JoinedPieces joined = joinPieces(pieces, {});
    EXPECT_EQ(joined.pieces, pieces);
    EXPECT_TRUE(joined.joins.empty());
    EXPECT_TRUE(joined.problems.empty());
}

TEST(JoinPieces, MakeTheCapOfItsHalvesAgain) {
    const MeshArrays whole = cap();
    const Pieces halves{partOf(whole, "left", isLeft), partOf(whole, "right", isRight)};
    const Points rim = commonRim(*halves[0], *halves[1]);
    ASSERT_GE(rim.size(), 5U);
    for (const Points& points : {rim, Points(rim.rbegin(), rim.rend())}) {
        const JoinedPieces joined = joinPieces(halves, {{"left / right", points}});
        ASSERT_TRUE(joined.problems.empty()) << sentence(joined.problems[0]);
        ASSERT_EQ(joined.pieces.size(), 1U);
        const Piece& made = *joined.pieces[0];
        EXPECT_EQ(made.name, "left + right");
        EXPECT_FALSE(made.defect);
        EXPECT_TRUE(made.holes.empty());
        EXPECT_EQ(made.mesh.V.rows(), whole.V.rows());
        EXPECT_EQ(made.mesh.F.rows(), whole.F.rows());
        EXPECT_EQ(made.boundary.size(), test::asPiece(whole)->boundary.size());
        EXPECT_NEAR(areaOf(made), triangleAreas3d(whole).sum(), 1e-9);
        expectSourcesHold(made, whole);
        ASSERT_EQ(joined.joins.size(), 1U);
        EXPECT_EQ(joined.joins[0].name, "left / right");
        EXPECT_EQ(joined.joins[0].piece, "left + right");
        double length = 0;
        for (std::size_t i = 1; i < rim.size(); ++i) {
            length += (rim[i] - rim[i - 1]).norm();
        }
        EXPECT_NEAR(joined.joins[0].length, length, 1e-9);
    }
}

TEST(JoinPieces, OnlyAlongThePointsGiven) {
    const MeshArrays whole = test::planeGrid(8, 8, 10);
    const Pieces halves{
        partOf(whole, "left", [](const Eigen::Vector3d& p) { return p.x() < 40; }),
        partOf(whole, "right", [](const Eigen::Vector3d& p) { return p.x() > 40; })};
    const JoinedPieces joined = joinPieces(halves, {{"upper", {{40, 80, 0}, {40, 30, 0}}}});
    ASSERT_EQ(joined.pieces.size(), 1U);
    EXPECT_NEAR(joined.joins[0].length, 50, 1e-9);
    EXPECT_FALSE(joined.pieces[0]->defect);
    // The outline of the square, and both sides of what stays open.
    EXPECT_EQ(joined.pieces[0]->boundary.size(), 32U + 6U);

    // The rest is then a slit of one piece, closed like a dart.
    const UserJoin lower{"lower", {{40, 0, 0}, {40, 30, 0}}};
    const JoinedPieces closed = joinPieces(halves, {{"upper", {{40, 80, 0}, {40, 30, 0}}}, lower});
    ASSERT_TRUE(closed.problems.empty()) << sentence(closed.problems[0]);
    ASSERT_EQ(closed.pieces.size(), 1U);
    EXPECT_EQ(closed.pieces[0]->name, "left + right");
    EXPECT_EQ(closed.pieces[0]->mesh.V.rows(), whole.V.rows());
    EXPECT_EQ(closed.pieces[0]->boundary.size(), 32U);
    expectSourcesHold(*closed.pieces[0], whole);
}

TEST(JoinPieces, CloseATubeAndSayThatItIsNoDisk) {
    // A strip bent until its two ends meet: the last column has the places of the first.
    MeshArrays strip = test::planeGrid(12, 4, 10);
    for (Eigen::Index v = 0; v < strip.V.rows(); ++v) {
        const int column = static_cast<int>(std::lround(strip.V(v, 0) / 10)) % 12;
        const double angle = column * std::numbers::pi / 6;
        strip.V.row(v) << 20 * std::cos(angle), strip.V(v, 1), -20 * std::sin(angle);
    }
    const Pieces pieces{sourced(strip, "sleeve")};
    ASSERT_FALSE(pieces[0]->defect);
    const JoinedPieces joined = joinPieces(pieces, {{"underarm", {{20, 0, 0}, {20, 40, 0}}}});
    ASSERT_TRUE(joined.problems.empty()) << sentence(joined.problems[0]);
    ASSERT_EQ(joined.pieces.size(), 1U);
    EXPECT_EQ(joined.pieces[0]->name, "sleeve");
    EXPECT_EQ(joined.pieces[0]->mesh.V.rows(), 12 * 5);
    ASSERT_TRUE(joined.pieces[0]->defect);
    EXPECT_EQ(joined.pieces[0]->defect->code, ErrorCode::SeveralLoops);
    EXPECT_NEAR(joined.joins[0].length, 40, 1e-9);
}

TEST(JoinPieces, TakeTheWholeOfAClosedSeam) {
    const MeshArrays whole = cap();  // around +y: its middle is a lid with one closed seam
    const double height = 100 * std::cos(std::numbers::pi / 6);
    const auto lid = partOf(whole, "lid", [&](const Eigen::Vector3d& p) { return p.y() > height; });
    const auto ring =
        partOf(whole, "ring", [&](const Eigen::Vector3d& p) { return p.y() <= height; });
    Points round;
    for (const int v : lid->boundary) {
        round.emplace_back(lid->mesh.V.row(v).transpose());
    }
    round.push_back(round.front());
    const JoinedPieces joined = joinPieces({ring, lid}, {{"lid", round}});
    ASSERT_TRUE(joined.problems.empty()) << sentence(joined.problems[0]);
    ASSERT_EQ(joined.pieces.size(), 1U);
    EXPECT_FALSE(joined.pieces[0]->defect);
    EXPECT_TRUE(joined.pieces[0]->holes.empty());
    EXPECT_EQ(joined.pieces[0]->mesh.V.rows(), whole.V.rows());
    expectSourcesHold(*joined.pieces[0], whole);
}

TEST(JoinPieces, GrowOneAfterTheOther) {
    const MeshArrays whole = test::planeGrid(9, 3, 10);
    Pieces strips;
    for (int k = 0; k < 3; ++k) {
        strips.push_back(partOf(whole, "abc" + std::to_string(k), [k](const Eigen::Vector3d& p) {
            return p.x() > 30 * k && p.x() < 30 * (k + 1);
        }));
    }
    const UserJoin first{"first", {{30, 0, 0}, {30, 30, 0}}};
    const UserJoin second{"second", {{60, 30, 0}, {60, 0, 0}}};
    for (const auto& joins : {std::vector{first, second}, std::vector{second, first}}) {
        const JoinedPieces joined = joinPieces(strips, joins);
        ASSERT_EQ(joined.pieces.size(), 1U);
        EXPECT_EQ(joined.pieces[0]->boundary.size(), 24U);
        EXPECT_EQ(joined.joins.size(), 2U);
        expectSourcesHold(*joined.pieces[0], whole);
    }
    // One alone leaves the third as it is.
    const JoinedPieces one = joinPieces(strips, {second});
    ASSERT_EQ(one.pieces.size(), 2U);
    EXPECT_EQ(one.pieces[0], strips[0]);
    EXPECT_EQ(one.pieces[1]->name, "abc1 + abc2");
}

/// A quilt: every join meets pieces that earlier ones have made, and the last ones close the slits
/// that are left between them.
TEST(JoinPieces, MakeAQuiltWholeInAnyOrder) {
    const int side = 5;
    const MeshArrays whole = test::planeGrid(2 * side, 2 * side, 10);
    Pieces patches;
    std::vector<UserJoin> joins;
    for (int k = 0; k < side * side; ++k) {
        const double x = 20.0 * (k % side), y = 20.0 * (k / side);
        patches.push_back(partOf(whole, "patch " + std::to_string(k), [=](const auto& p) {
            return p.x() > x && p.x() < x + 20 && p.y() > y && p.y() < y + 20;
        }));
        if (x > 0) {
            joins.push_back({"x" + std::to_string(k), {{x, y, 0}, {x, y + 10, 0}, {x, y + 20, 0}}});
        }
        if (y > 0) {
            joins.push_back({"y" + std::to_string(k), {{x, y, 0}, {x + 10, y, 0}, {x + 20, y, 0}}});
        }
    }
    std::mt19937 random(4);
    for (int round = 0; round < 5; ++round) {
        for (std::size_t i = joins.size(); i > 1; --i) {
            std::swap(joins[i - 1], joins[random() % i]);
        }
        Progress progress;
        const JoinedPieces joined = joinPieces(patches, joins, progress);
        EXPECT_EQ(progress.fraction(), 1);
        ASSERT_EQ(joined.pieces.size(), 1U);
        EXPECT_EQ(joined.pieces[0]->mesh.V.rows(), whole.V.rows());
        EXPECT_EQ(joined.pieces[0]->boundary.size(), 8U * side);
        expectSourcesHold(*joined.pieces[0], whole);
    }
}

TEST(JoinPieces, CanBeCancelled) {
    const MeshArrays whole = cap();
    const Pieces halves{partOf(whole, "left", isLeft), partOf(whole, "right", isRight)};
    Progress progress;
    progress.cancel();
    const UserJoin join{"left / right", commonRim(*halves[0], *halves[1])};
    EXPECT_TRUE(joinPieces(halves, {join}, progress).joins.empty());
    EXPECT_EQ(progress.fraction(), 0);
}

TEST(JoinPieces, OutliveASmallChangeOfTheMesh) {
    const MeshArrays whole = test::planeGrid(8, 8, 10);
    const Pieces halves{
        partOf(whole, "left", [](const Eigen::Vector3d& p) { return p.x() < 40; }),
        partOf(whole, "right", [](const Eigen::Vector3d& p) { return p.x() > 40; })};
    const JoinedPieces joined = joinPieces(halves, {{"a", {{41, 1, 2}, {39, 40, 1}, {40, 79, 0}}}});
    ASSERT_EQ(joined.pieces.size(), 1U);
    EXPECT_NEAR(joined.joins[0].length, 80, 1e-9);
}

TEST(JoinPieces, RefuseWithAReasonAndLeaveThePiecesAlone) {
    const MeshArrays left = test::planeGrid(4, 4, 10);
    const auto moved = [](MeshArrays mesh, double x, double y, double z) {
        mesh.V.rowwise() += Eigen::RowVector3d(x, y, z);
        return mesh;
    };
    const Points between{{40, 0, 0}, {40, 40, 0}};
    const auto expectRefused = [&](const Pieces& pieces, const Points& points, const char* word) {
        const JoinedPieces joined = joinPieces(pieces, {{"seam", points}});
        EXPECT_EQ(joined.pieces, pieces) << word;
        EXPECT_TRUE(joined.joins.empty()) << word;
        ASSERT_EQ(joined.problems.size(), 1U) << word;
        EXPECT_EQ(joined.problems[0].code, ErrorCode::JoinImpossible);
        EXPECT_EQ(joined.problems[0].subject.name, "seam");
        EXPECT_NE(joined.problems[0].detail.find(word), std::string::npos)
            << joined.problems[0].detail;
    };
    const auto a = sourced(left, "a");
    const auto b = sourced(moved(left, 40, 0, 0), "b");
    ASSERT_EQ(joinPieces({a, b}, {{"seam", between}}).pieces.size(), 1U);  // the control

    expectRefused({a, b}, {{40, 0, 0}}, "2 points");
    expectRefused({a, b}, {{40, 0, 0}, {std::nan(""), 0, 0}}, "not finite");
    expectRefused({a, b}, {{400, 0, 0}, {400, 40, 0}}, "mm from the nearest edge");
    expectRefused({a, b}, {{4e100, 0, 0}, {4e100, 40, 0}}, " 4.00e+100 mm from the nearest");
    expectRefused({a, b}, {{1e300, 0, 0}, {1e300, 40, 0}}, "mm from the nearest edge");
    expectRefused({}, between, "no piece");
    expectRefused({sourced(test::octahedron(), "ball")}, between, "no piece has an edge");
    // Sampled otherwise, a little apart, or one of them alone.
    expectRefused({a, sourced(moved(test::planeGrid(4, 5, 8), 40, 0, 0), "b")}, between,
                  "one to one");
    expectRefused({a, sourced(moved(left, 40.5, 0, 0), "b")}, between, "one to one");
    expectRefused({a}, between, "one to one");
    // A third layer on the same line.
    MeshArrays upright = moved(left, 40, 0, 0);
    for (Eigen::Index v = 0; v < upright.V.rows(); ++v) {
        const Eigen::RowVector3d old = upright.V.row(v);
        upright.V.row(v) << 40, old.y(), old.x() - 40;
    }
    expectRefused({a, b, sourced(upright, "c")}, between, "more than two edges");
    // Of another file.
    auto foreign = std::make_shared<Piece>(*b);
    foreign->file = 1;
    expectRefused({a, foreign}, between, "different files");
}

TEST(JoinPieces, RefuseWhatWouldBeNoSurface) {
    // A folded strip, its two short ends on each other but for one edge that would be doubled: the
    // two triangles of a square folded along their diagonal.
    MeshArrays leaf;
    leaf.V.resize(4, 3);
    leaf.V << 0, 0, 0, 10, 0, 0, 10, 10, 0, 10, 0, 0;
    leaf.F.resize(2, 3);
    leaf.F << 0, 1, 2, 0, 2, 3;
    const JoinedPieces joined =
        joinPieces({sourced(leaf, "leaf")}, {{"edge", {{10, 0, 0}, {10, 10, 0}}}});
    EXPECT_EQ(joined.pieces.size(), 1U);
    EXPECT_EQ(joined.problems.size() + joined.joins.size(), 1U);
    for (const auto& piece : joined.pieces) {
        EXPECT_GE(piece->mesh.V.rows(), 4);
    }
}

}  // namespace
}  // namespace toile
