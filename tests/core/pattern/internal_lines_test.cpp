// SPDX-License-Identifier: GPL-3.0-or-later
// What a person draws within the cloth: on the flat pieces and on the worn ones, through cuts,
// other methods and other units, and on half patterns.
#include "core/pattern/internal_lines.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <memory>
#include <numeric>

#include <gtest/gtest.h>

#include "core/assemble/file_space.h"
#include "core/cut/surface_paths.h"
#include "core/formats/drawing/drawing.h"
#include "core/pattern/half_pattern.h"
#include "core/toile/pipeline.h"
#include "tests/core/support/shapes.h"
#include "tests/core/support/shared_data.h"
#include "tests/core/symmetry/mirror_shapes.h"

namespace toile {
namespace {

using Points = std::vector<Eigen::Vector3d>;

struct Drawn {
    Garment garment;
    PieceResults results{};
    Pattern pattern{};
};

Drawn drawn(Garment garment, const LineSettings& lines, Method method = Method::Isometric) {
    Drawn made{std::move(garment)};
    FlattenOptions options;
    options.method = method;
    Progress progress;
    made.results = flattenGarment(made.garment, options, progress, 0, lines);
    made.pattern = makePattern(made.garment, made.results, lines);
    return made;
}

Garment garmentFrom(MeshArrays mesh) {
    Garment garment;
    auto piece = std::make_shared<Piece>(*test::asPiece(std::move(mesh)));
    piece->sourceVertex.resize(static_cast<std::size_t>(piece->mesh.V.rows()));
    piece->sourceFace.resize(static_cast<std::size_t>(piece->mesh.F.rows()));
    std::iota(piece->sourceVertex.begin(), piece->sourceVertex.end(), 0);
    std::iota(piece->sourceFace.begin(), piece->sourceFace.end(), 0);
    garment.pieces = {piece};
    garment.uncut = garment.pieces;
    return garment;
}

LineSettings with(Points points, bool closed = false) {
    LineSettings lines;
    lines.internalLines = {{"line", std::move(points), closed}};
    return lines;
}

Garment cutAcross(const Garment& garment, Points points) {
    LoadOptions options;
    options.seams.cuts = {{"cut", UserCut::Kind::Path, std::move(points)}};
    Progress progress;
    auto cut = cutGarment(garment, options, progress);
    EXPECT_TRUE(cut);
    return cut ? std::move(*cut) : Garment{};
}

double wornLength(const Drawn& made) {
    double length = 0;
    for (std::size_t p = 0; p < made.pattern.pieces.size(); ++p) {
        for (const PieceInternal& internal : made.pattern.pieces[p].internals) {
            length += measuredLength(made.garment.pieces[p]->mesh, {internal.way});
        }
    }
    return length;
}

int runCount(const Drawn& made) {
    int count = 0;
    for (const PatternPiece& piece : made.pattern.pieces) {
        count += static_cast<int>(piece.internals.size());
    }
    return count;
}

/// The shortest way through places of a piece, and back to the first where it is closed.
double shortestLength(const Piece& piece, const Points& points, bool closed = false) {
    const SurfaceLinks links(piece.mesh, piece.table);
    const NearestSurface nearest(piece.mesh);
    double length = 0;
    for (std::size_t i = closed ? 0 : 1; i < points.size(); ++i) {
        const auto path =
            geodesicPath(links, nearest.find(points[(i + points.size() - 1) % points.size()]),
                         nearest.find(points[i]));
        EXPECT_TRUE(path);
        length += path ? path->length : 0;
    }
    return length;
}

TEST(InternalLines, AreStraightOnWhatCanBeUnrolled) {
    const MeshArrays mesh = test::cylinderSector(16, 8, 120, 1.8, 200);
    const Eigen::Vector3d low = mesh.V.colwise().minCoeff(), high = mesh.V.colwise().maxCoeff();
    // Anywhere: the ends go to the cloth.
    const Points ends{low + 0.2 * (high - low), low + 0.85 * (high - low)};
    Garment garment = garmentFrom(mesh);
    const NearestSurface nearest(garment.pieces[0]->mesh);
    Points onCloth;
    for (const Eigen::Vector3d& end : ends) {
        onCloth.push_back(positionOf(mesh, nearest.find(end)));
    }
    const Drawn made = drawn(garment, with(onCloth));
    ASSERT_EQ(runCount(made), 1);
    const PieceInternal& line = made.pattern.pieces[0].internals[0];
    ASSERT_EQ(line.points.rows(), 2);
    EXPECT_GT(line.way.size(), 10U);
    const double flat = (line.points.row(1) - line.points.row(0)).norm();
    EXPECT_NEAR(line.length, flat, 1e-9 * flat);
    EXPECT_NEAR(wornLength(made), flat, 1e-6 * flat);
    EXPECT_NEAR(wornLength(made), shortestLength(*garment.pieces[0], onCloth), 1e-6 * flat);
    EXPECT_EQ(line.name, "line");
}

TEST(InternalLines, LoseNothingToACutAcross) {
    const Garment whole = garmentFrom(test::bentPanel(24));
    const MeshArrays& mesh = whole.pieces[0]->mesh;
    const NearestSurface nearest(mesh);
    const auto at = [&](double x, double y) -> Eigen::Vector3d {  // as bentPanel is bent
        const double u = x / 300 - 1, v = y / 300 - 1;
        const double z = 120 * std::exp(-2 * (u * u + v * v)) + 40 * u * v;
        return positionOf(mesh, nearest.find({x, y, z}));
    };
    const Points points{at(130, 140), at(480, 430)};
    const Garment cut = cutAcross(whole, {at(0, 600), at(300, 310), at(600, 0)});
    ASSERT_EQ(cut.pieces.size(), 2U);
    const Drawn made = drawn(cut, with(points));
    EXPECT_EQ(runCount(made), 2);
    const double wanted = shortestLength(*whole.pieces[0], points);
    EXPECT_NEAR(wornLength(made), wanted, 1e-6 * wanted);
    // Both ends at the cut are one place.
    ASSERT_EQ(made.pattern.pieces[0].internals.size(), 1U);
    ASSERT_EQ(made.pattern.pieces[1].internals.size(), 1U);
    const auto& one = made.pattern.pieces[0].internals[0].way;
    const auto& other = made.pattern.pieces[1].internals[0].way;
    const auto place = [&](std::size_t piece, const SurfacePoint& point) {
        return positionOf(made.garment.pieces[piece]->mesh, point);
    };
    const double gap = std::min((place(0, one.back()) - place(1, other.front())).norm(),
                                (place(0, one.front()) - place(1, other.back())).norm());
    EXPECT_LT(gap, 1e-6);
    // What the cut does not meet is as it was; and without the cut all is.
    const Drawn before = drawn(whole, with(points));
    EXPECT_EQ(runCount(before), 1);
    EXPECT_EQ(before.pattern.pieces[0].internals[0].points.rows(), 2);
}

TEST(InternalLines, GoRoundWhatIsNoCloth) {
    // An L: the straight way from arm to arm would leave it.
    const MeshArrays mesh = test::part(
        test::planeGrid(10, 10, 10),
        [](const Eigen::RowVector3d& middle) { return middle.x() < 50 || middle.y() < 50; });
    const Points points{{20, 95, 0}, {95, 20, 0}};
    const Drawn made = drawn(garmentFrom(mesh), with(points));
    ASSERT_EQ(runCount(made), 1);
    const PieceInternal& line = made.pattern.pieces[0].internals[0];
    const double wanted = 2 * std::hypot(30, 45);  // by way of the inner corner
    EXPECT_NEAR(line.length, wanted, 1e-6 * wanted);
    EXPECT_EQ(line.points.rows(), 3);
}

TEST(InternalLines, CloseUnlessACutParts) {
    const Garment whole = garmentFrom(test::planeGrid(10, 10, 10));
    const LineSettings square = with({{23, 21, 0}, {78, 21, 0}, {78, 72, 0}, {23, 72, 0}}, true);
    const double wanted = 2 * (55 + 51);
    const Drawn made = drawn(whole, square);
    ASSERT_EQ(runCount(made), 1);
    EXPECT_TRUE(made.pattern.pieces[0].internals[0].closed);
    EXPECT_EQ(made.pattern.pieces[0].internals[0].points.rows(), 4);
    EXPECT_NEAR(made.pattern.pieces[0].internals[0].length, wanted, 1e-6 * wanted);

    const Drawn parted = drawn(cutAcross(whole, {{0, 40, 0}, {100, 46, 0}}), square);
    EXPECT_EQ(runCount(parted), 2);
    EXPECT_NEAR(wornLength(parted), wanted, 1e-6 * wanted);
    for (const PatternPiece& piece : parted.pattern.pieces) {
        ASSERT_EQ(piece.internals.size(), 1U);
        EXPECT_FALSE(piece.internals[0].closed);
        EXPECT_EQ(piece.internals[0].points.rows(), 4);
    }
    // A slit inside, beside the line, changes nothing; a slit across parts it on one piece.
    const Drawn slit = drawn(cutAcross(whole, {{50, 0, 0}, {50, 50, 0}}), square);
    ASSERT_EQ(slit.garment.pieces.size(), 1U);
    EXPECT_EQ(runCount(slit), 1);
    EXPECT_FALSE(slit.pattern.pieces[0].internals[0].closed);
    EXPECT_NEAR(wornLength(slit), wanted, 1e-6 * wanted);
}

TEST(InternalLines, PointsFarFromTheClothAreNotDrawn) {
    const Garment whole = garmentFrom(test::planeGrid(10, 10, 10));
    EXPECT_EQ(runCount(drawn(whole, with({{50, 50, 40}}))), 0);
    EXPECT_EQ(runCount(drawn(whole, with({{50, 50, 40}, {20, 20, 0}}))), 0);
    EXPECT_EQ(runCount(drawn(whole, with({{50, 50, std::numeric_limits<double>::quiet_NaN()}}))),
              0);
    EXPECT_EQ(runCount(drawn(whole, with({}))), 0);
    const Drawn parted =
        drawn(whole, with({{20, 20, 0}, {30, 20, 0}, {50, 50, 40}, {60, 20, 0}, {80, 20, 0}}));
    EXPECT_EQ(runCount(parted), 2);
    EXPECT_NEAR(wornLength(parted), 30, 1e-6);
    const Drawn drill = drawn(whole, with({{33, 44, 0.1}}));
    ASSERT_EQ(runCount(drill), 1);
    EXPECT_TRUE(isDrillPoint(drill.pattern.pieces[0].internals[0]));
    EXPECT_EQ(drawnLines(drill.pattern.pieces[0].internals[0]).size(), 3U);
}

TEST(InternalLines, StayThroughMethodsAndUnits) {
    for (const Method method : {Method::Isometric, Method::Lscm, Method::Stretch}) {
        double before = 0;
        for (const LengthUnit unit : {LengthUnit::Millimetre, LengthUnit::Centimetre}) {
            LoadOptions options;
            options.unit = unit;
            Progress progress;
            auto garment = loadGarment({test::dataFile("samples/tshirt.obj")}, options, progress);
            ASSERT_TRUE(garment);
            const Piece& piece = *garment->pieces[0];
            const NearestSurface nearest(piece.mesh);
            const Eigen::Vector3d middle = piece.mesh.V.colwise().mean();
            const Eigen::Vector3d rim = piece.mesh.V.row(piece.boundary[0]);
            const Points points =
                inFileSpace(Points{positionOf(piece.mesh, nearest.find(middle)),
                                   positionOf(piece.mesh, nearest.find(0.5 * (middle + rim)))},
                            *garment);
            const Drawn made = drawn(std::move(*garment), with(points), method);
            ASSERT_EQ(runCount(made), 1);
            const PieceInternal& line = made.pattern.pieces[0].internals[0];
            EXPECT_EQ(line.points.rows(), 2);
            if (before > 0) {
                EXPECT_NEAR(line.length, 10 * before, 1e-3 * line.length);
            }
            before = line.length;
        }
    }
}

TEST(InternalLines, HalfPatternsEndAtTheFold) {
    LineSettings lines;
    lines.mirror = Mirror::Mean;
    Drawn made = drawn(test::tube4(), lines);
    const PatternPiece& front = made.pattern.pieces[0];
    ASSERT_TRUE(front.mirror.isSymmetric);
    const Piece& piece = *made.garment.pieces[0];
    const NearestSurface nearest(piece.mesh);
    const Eigen::Vector3d middle =
        positionOf(piece.mesh, nearest.find(Eigen::Vector3d(piece.mesh.V.colwise().mean())));
    const auto beside = [&](double x) -> Eigen::Vector3d {
        return positionOf(piece.mesh, nearest.find(middle + Eigen::Vector3d(x, 0, 0)));
    };
    lines.internalLines = {
        {"across", {beside(-30), beside(30)}}, {"left", {beside(-25)}}, {"right", {beside(25)}}};
    made.pattern = makePattern(made.garment, made.results, lines);
    ASSERT_EQ(made.pattern.pieces[0].internals.size(), 3U);
    const double length = made.pattern.pieces[0].internals[0].length;
    made.pattern.pieces[0].byHalf = true;
    const Pattern cut = asCut(made.pattern);
    ASSERT_EQ(cut.pieces[0].internals.size(), 2U);  // one drill point is on the other half
    const PieceInternal& half = cut.pieces[0].internals[0];
    const Chord fold = foldOf(cut.pieces[0]);
    const auto rest = leftPart(made.pattern.pieces[0].internals[0], {fold.to, fold.from});
    ASSERT_EQ(rest.size(), 1U);
    EXPECT_NEAR(half.length + rest[0].length, length, 1e-4);
    EXPECT_GT(std::min(half.length, rest[0].length), 0.3 * length);
    const Eigen::Vector2d along = (fold.to - fold.from).normalized();
    double nearestToFold = length;
    for (const auto& point : half.points.rowwise()) {
        const Eigen::Vector2d way = point.transpose() - fold.from;
        const double side = along.x() * way.y() - along.y() * way.x();
        EXPECT_GT(side, -1e-5);
        nearestToFold = std::min(nearestToFold, std::abs(side));
    }
    EXPECT_LT(nearestToFold, 1e-5);
}

TEST(InternalLines, AClosedLineIsPartedByTheFold) {
    PieceInternal square;
    square.points.resize(4, 2);
    square.points << -10, 0, 10, 0, 10, 20, -10, 20;
    square.closed = true;
    square.length = 80;
    const Chord upwards{{0, -50}, {0, 50}};
    const auto left = leftPart(square, upwards);
    ASSERT_EQ(left.size(), 1U);
    EXPECT_FALSE(left[0].closed);
    EXPECT_NEAR(left[0].length, 40, 1e-5);
    EXPECT_EQ(leftPart(square, {{-20, 50}, {-20, -50}}).front().points, square.points);
    EXPECT_TRUE(leftPart(square, {{-20, -50}, {-20, 50}}).empty());
    // Of a line that goes over twice, two parts.
    PieceInternal zigzag;
    zigzag.points.resize(4, 2);
    zigzag.points << -5, 0, 5, 0, 5, 10, -5, 10;
    EXPECT_EQ(leftPart(zigzag, upwards).size(), 2U);
}

TEST(InternalLines, AreDrawnOnTheirLayerWithinTheOutline) {
    const Garment whole = garmentFrom(test::planeGrid(10, 10, 10));
    LineSettings lines = with({{23, 21, 0}, {78, 21, 0}, {50, 72, 0}}, true);
    lines.internalLines.push_back({{}, {{20, 80, 0}}});
    lines.internalLines.push_back({{}, {{70, 80, 0}, {90, 90, 0}}});
    const Drawn made = drawn(whole, lines);
    const Drawing drawing = draw(made.pattern, {{{0, {}}}, 100, 100});
    std::map<std::string, bool> closed;
    for (const DrawnPath& path : drawing.paths) {
        if (path.layer == LayerKind::Internal) {
            closed.emplace(path.id, path.closed);
        }
    }
    const std::string id = "piece-" + made.pattern.pieces[0].slug;
    const std::map<std::string, bool> wanted{{id + "--line-1", true},
                                             {id + "--line-2", false},
                                             {id + "--point-1", true},
                                             {id + "--point-1-2", false},
                                             {id + "--point-1-3", false}};
    EXPECT_EQ(closed, wanted);
    EXPECT_TRUE(hasLayer(drawing, LayerKind::Internal));
    EXPECT_EQ(drawnOnCloth(made.pattern, made.pattern.pieces[0]).size(), 5U);
}

}  // namespace
}  // namespace toile
