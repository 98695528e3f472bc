// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/pattern/flat_reflection.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/cut/surface_point.h"
#include "core/geometry/line.h"
#include "core/pattern/fair_outline.h"
#include "core/symmetry/garment_surface.h"

namespace toile {
namespace {

/// For either piece: largest number of starting vertices, and places on its outline.
constexpr int kReflectedVertices = 400, kOutlinePlaces = 200;
constexpr int kOutlineRounds = 40;
/// The iteration stops when the middle moves, mm, and the direction turns, by less than this.
constexpr double kReflectionAtRest = 1e-9;

/// Points of a flat piece, and their target positions on the other.
struct ReflectedPoints {
    Points2 from, to;
    Eigen::VectorXd weight;
};

/// Vertices of `piece`, and the points of `other` nearest to their mirror images.
ReflectedPoints nearestPoints(const PieceResult& piece, const PieceResult& other,
                              const MirrorPlane& plane) {
    const symmetry::GarmentSurface surface = symmetry::surfaceOf({piece.piece});
    const MeshArrays& there = other.piece->mesh;
    const NearestSurface nearest(there);
    const std::vector<int> vertices = surface.sampled(kReflectedVertices);
    const auto count = static_cast<Eigen::Index>(vertices.size());
    ReflectedPoints points{Points2(count, 2), Points2(count, 2), Eigen::VectorXd(count)};
    for (Eigen::Index i = 0; i < count; ++i) {
        const int v = vertices[static_cast<std::size_t>(i)];
        const SurfacePoint image = nearest.find(plane.reflected(surface.mesh.V.row(v)));
        points.from.row(i) = piece.flat->Q.row(v);
        points.to.row(i) = flatPositionOf(other.flat->Q, there.F, image);
        points.weight[i] = surface.area[v];
    }
    return points;
}

/// Concatenates both; the points of the second are exchanged.
ReflectedPoints bothWays(const ReflectedPoints& there, const ReflectedPoints& back) {
    const Eigen::Index n = there.from.rows(), m = back.from.rows();
    ReflectedPoints both{Points2(n + m, 2), Points2(n + m, 2), Eigen::VectorXd(n + m)};
    both.from << there.from, back.to;
    both.to << there.to, back.from;
    both.weight << there.weight, back.weight;
    return both;
}

/// The inverse map.
MirrorPlaces inverse(MirrorPlaces places) {
    std::ranges::reverse(places.rising);
    std::ranges::reverse(places.falling);
    return {std::move(places.falling), std::move(places.rising)};
}

bool isDrawnMirrored(const PieceResult& result) {
    return result.flat->line && result.plan && result.plan->mirrored;
}

/// Nodes of one drawn line, and the mirrored places on the other.
ReflectedPoints pointsOfLines(const PieceResult& piece, const PieceResult& other) {
    const FlatLine &line = *piece.flat->line, &otherLine = *other.flat->line;
    const MirroredOutline& outline = *piece.plan->mirrored;
    const MirrorPlaces places = outline.isImage ? inverse(outline.places) : outline.places;
    const auto there = geometry::Line::closed(otherLine.points, otherLine.arc);
    const Eigen::Index count = line.points.rows();
    ReflectedPoints points{line.points, Points2(count, 2), Eigen::VectorXd::Ones(count)};
    for (Eigen::Index i = 0; i < count; ++i) {
        points.to.row(i) = there.pointAt(places(line.arc[static_cast<std::size_t>(i)]));
    }
    return points;
}

Placement bestReflection(const ReflectedPoints& points) {
    return geometry::fitMotion(points.from, points.to, true, points.weight);
}

/// Evenly spaced places on an outline, and the nearest places of another to their reflections.
ReflectedPoints nearestPlaces(const geometry::Line& line, const geometry::Line& other,
                              const Placement& reflection) {
    ReflectedPoints points{Points2(kOutlinePlaces, 2), Points2(kOutlinePlaces, 2),
                           Eigen::VectorXd::Ones(kOutlinePlaces)};
    for (int i = 0; i < kOutlinePlaces; ++i) {
        points.from.row(i) = line.pointAt(line.length() * i / kOutlinePlaces);
        points.to.row(i) =
            other.pointAt(other.nearestPlace(reflection.appliedToRow(points.from.row(i))));
    }
    return points;
}

/// Lays one outline over the other.
Placement improved(Placement reflection, const geometry::Line& line, const geometry::Line& other) {
    for (int round = 0; round < kOutlineRounds; ++round) {
        const ReflectedPoints points = bothWays(nearestPlaces(line, other, reflection),
                                                nearestPlaces(other, line, reflection.inverse()));
        const Placement next = bestReflection(points);
        const Eigen::RowVector2d middle = points.from.colwise().mean();
        const double moved = (next.appliedToRow(middle) - reflection.appliedToRow(middle)).norm();
        const double turned = std::abs(std::sin((next.turn - reflection.turn) / 2));
        reflection = next;
        if (moved <= kReflectionAtRest && turned <= kReflectionAtRest) {
            break;
        }
    }
    return reflection;
}

geometry::Line outlineOf(const PieceResult& result) {
    return geometry::Line::closed(result.flat->Q(result.piece->boundary, Eigen::all));
}

}  // namespace

Placement reflectionBetween(const PieceResult& piece, const PieceResult& counterpart,
                            const MirrorPlane& plane) {
    if (isDrawnMirrored(piece) && isDrawnMirrored(counterpart)) {
        return bestReflection(pointsOfLines(piece, counterpart));
    }
    const Placement start = bestReflection(bothWays(nearestPoints(piece, counterpart, plane),
                                                    nearestPoints(counterpart, piece, plane)));
    return improved(start, outlineOf(piece), outlineOf(counterpart));
}

}  // namespace toile
