// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/flatten/base/flat_notes.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include <gtest/gtest.h>

#include "core/base/text.h"
#include "core/diagnose/crossing_cut.h"
#include "core/flatten/base/piece_result.h"
#include "core/flatten/flatten.h"
#include "core/garment/garment.h"
#include "core/quality/measures.h"
#include "core/quality/piece_quality.h"
#include "core/toile/pipeline.h"
#include "tests/core/support/flat_trouble.h"
#include "tests/core/support/shapes.h"

namespace toile {
namespace {

const Error* noteOf(const FlatPiece& flat, ErrorCode code) {
    const auto found = std::ranges::find(flat.notes, code, &Error::code);
    return found == flat.notes.end() ? nullptr : &*found;
}

TEST(FlatNotes, NameTheCutThatResolvesACrossing) {
    const auto piece = test::asPiece(test::flounce(420, 80, 200, 72, 5), "flounce");
    FlattenOptions options;
    options.method = Method::Curvature;
    Progress progress;
    const auto flat = flatten(*piece, options, progress);
    ASSERT_TRUE(flat);
    const auto* note = noteOf(*flat, ErrorCode::OutlineCrosses);
    ASSERT_TRUE(note);
    EXPECT_TRUE(isNote(note->code));
    EXPECT_EQ(note->subject.name, "flounce");
    EXPECT_NE(note->detail.find(" crossings, the first at ("), std::string::npos) << note->detail;
    // The search takes seconds on large pieces: it is no part of the solve.
    EXPECT_EQ(note->detail.find("cut"), std::string::npos) << note->detail;

    Garment garment;
    garment.pieces = {piece};
    const auto result = flattenGarment(garment, options, progress).front();
    note = noteOf(*result->flat, ErrorCode::OutlineCrosses);
    ASSERT_TRUE(note);
    EXPECT_NE(note->detail.find("; cut it from ("), std::string::npos) << note->detail;
    EXPECT_NE(note->detail.find("), 120 mm"), std::string::npos) << note->detail;
    EXPECT_EQ(uncrossedNote(*piece, 2).detail, "2 crossings");
}

TEST(FlatNotes, SayNothingOfASimpleOutline) {
    const auto piece = test::asPiece(test::planeGrid(4, 3, 10));
    const Points2 Q = piece->mesh.V.leftCols(2);
    EXPECT_FALSE(crossingNote(*piece, Q, findOutlineCrossings(Q, piece->boundary)));
    EXPECT_FALSE(shortEdgesNote(*piece, Q));
    EXPECT_FALSE(degenerateNote(*piece));
    Problems notes;
    noteFlips(*piece, Q, notes);
    nameCrossingCut(*piece, Q, {}, Progress(), notes);
    EXPECT_TRUE(notes.empty());
}

TEST(FlatNotes, NameTrianglesFlippedInPlaceOfAnEarlyEnd) {
    const auto piece = test::asPiece(test::planeGrid(2, 2, 10), "yoke");
    Points2 Q = piece->mesh.V.leftCols(2);
    Q(4, 0) = 25;  // the middle, beyond the right side
    Problems notes{endedEarlyNote(*piece, "after 3 steps")};
    noteFlips(*piece, Q, notes);
    ASSERT_EQ(notes.size(), 1U);
    EXPECT_EQ(notes.front().code, ErrorCode::TrianglesFlipped);
    EXPECT_EQ(notes.front().subject.name, "yoke");
    EXPECT_EQ(notes.front().detail,
              std::to_string(measure(*piece, Q).flippedTriangles) +
                  " of 8 triangles, the worst at (13.3, 6.7, 0.0) mm; after 3 steps");
    EXPECT_EQ(sentence(notes.front()).find("as it is"), std::string::npos);
}

TEST(FlatNotes, ACollapsedTriangleIsNamedAndNotFlat) {
    const auto piece = test::asPiece(test::planeGrid(1, 1, 10), "yoke");
    PieceResult result;
    result.piece = piece;
    result.flat = FlatPiece{};
    Points2& Q = result.flat->Q = piece->mesh.V.leftCols(2);
    const auto corner = piece->mesh.F.row(0);
    const Eigen::RowVector2d base = 0.5 * (Q.row(corner[1]) + Q.row(corner[2]));
    Q.row(corner[0]) = base + 1e-13 * (Q.row(corner[0]) - base);
    ASSERT_GT(triangleAreas2d(Q, piece->mesh.F).minCoeff(), 0);
    Problems notes;
    noteFlips(*piece, Q, notes);
    ASSERT_EQ(notes.size(), 1U);
    EXPECT_EQ(notes.front().code, ErrorCode::TrianglesFlipped);
    EXPECT_TRUE(notes.front().detail.starts_with("1 of 2 triangles, at ("));
    result.quality = measure(*piece, Q);
    EXPECT_EQ(statusOf(result), "flipped");
    EXPECT_TRUE(breaksPromise(result));
}

TEST(FlatNotes, WhatIsFlippedIsNotSimplyFlat) {
    PieceResult result;
    EXPECT_EQ(statusOf(result), "failed");
    result.flat = FlatPiece{};
    result.quality = PieceQuality{};
    EXPECT_EQ(statusOf(result), "flat");
    EXPECT_FALSE(breaksPromise(result));
    result.quality->flippedTriangles = 1;
    EXPECT_EQ(statusOf(result), "flipped");
    EXPECT_TRUE(breaksPromise(result));  // of isometric
    result.options.method = Method::Curvature;
    EXPECT_EQ(statusOf(result), "flipped");
    EXPECT_FALSE(breaksPromise(result));
}

// Positions have 16 digits: an edge of 1e-9 mm on a piece of a foot has four. Here a corner whose
// triangles grow tenfold from one to the next, far from where the pattern's coordinates begin.
TEST(FlatNotes, NameBoundaryEdgesTooShortForTheirLengths) {
    constexpr int kLevels = 12;
    MeshArrays mesh{Points3::Zero(2 * kLevels + 1, 3), Triangles(2 * kLevels - 1, 3)};
    mesh.F.row(0) << 0, 1, 2;
    for (int k = 0; k < kLevels; ++k) {
        const double reach = 3e-9 * std::pow(10, k);
        mesh.V(2 * k + 1, 0) = mesh.V(2 * k + 2, 1) = -reach;
        if (k > 0) {
            mesh.F.row(2 * k - 1) << 2 * k - 1, 2 * k + 1, 2 * k + 2;
            mesh.F.row(2 * k) << 2 * k - 1, 2 * k + 2, 2 * k;
        }
    }
    const auto piece = test::asPiece(mesh, "pocket");
    ASSERT_FALSE(piece->defect) << sentence(*piece->defect);
    for (const Method method : {Method::Convex, Method::Curvature}) {
        FlattenOptions options;
        options.method = method;
        const auto flat = flatten(*piece, options, Progress());
        ASSERT_TRUE(flat) << sentence(flat.error());
        const double error = measure(*piece, flat->Q).maxBoundaryLengthError;
        ASSERT_GT(error, 1e-9);  // there are no digits for it
        const auto* note = noteOf(*flat, ErrorCode::EdgesTooShort);
        ASSERT_TRUE(note);
        EXPECT_NE(note->detail.find("off by " + scientific(error, 1)), std::string::npos)
            << note->detail;
    }
}

TEST(FlatNotes, NameTrianglesWithoutHeight) {
    MeshArrays mesh{Points3(5, 3), Triangles(3, 3)};
    mesh.V << 0, 0, 0, 30, 0, 0, 60, 0, 0, 30, 1e-6, 0, 30, 30, 0;
    mesh.F << 0, 1, 3, 0, 3, 4, 1, 2, 4;
    mesh.F.row(2) << 3, 2, 4;
    mesh.F.conservativeResize(4, 3);
    mesh.F.row(3) << 1, 2, 3;
    Piece piece = makePiece("cuff", mesh);
    ASSERT_FALSE(piece.defect) << sentence(*piece.defect);
    auto note = degenerateNote(piece);
    ASSERT_TRUE(note);
    EXPECT_EQ(note->code, ErrorCode::DegenerateTriangles);
    EXPECT_EQ(note->detail,
              "2 triangles: face 0 at (20.0, 0.0, 0.0) mm, face 3 at (40.0, 0.0, 0.0) mm");
    piece.sourceFace = {7, 8, 9, 11};  // the file's own numbers, where there is a file
    note = degenerateNote(piece);
    EXPECT_NE(note->detail.find("face 7 at"), std::string::npos) << note->detail;
    EXPECT_FALSE(degenerateNote(*test::asPiece(test::sliverGrid(6, 5, 10, 1))));
}

TEST(FlatNotes, NameAnglesThatNoOutlineHas) {
    const auto piece = test::asPiece(test::planeGrid(1, 1, 10), "square");
    Eigen::Vector4d angles(0.1, 2 * std::numbers::pi + 1e-14, 3, 1);
    EXPECT_FALSE(anglesNote(*piece, angles));
    angles[2] = -0.5;
    const auto note = anglesNote(*piece, angles);
    ASSERT_TRUE(note);
    EXPECT_EQ(note->code, ErrorCode::AnglesOutOfRange);
    EXPECT_EQ(note->detail, "1 outline vertex, -29 degrees at (10.0, 10.0, 0.0) mm");
}

}  // namespace
}  // namespace toile
