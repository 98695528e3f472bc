// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/pattern/mirrored_edit.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "core/assemble/cut_owner.h"
#include "core/cut/surface_paths.h"
#include "core/cut/surface_point.h"
#include "core/geometry/line.h"
#include "core/geometry/segment.h"
#include "core/pattern/fair_outline.h"
#include "core/seam/outline.h"
#include "core/symmetry/mirror_plane.h"

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

namespace {

/// A weight below this puts a point on the rim; a share below this puts it on a segment's end.
constexpr double kOnRim = 1e-6;

const PieceResult* flatResult(const Garment& garment, const PieceResults& results, int piece) {
    const auto i = static_cast<std::size_t>(piece);
    const PieceResult* result = i < results.size() ? results[i].get() : nullptr;
    return result && result->piece == garment.pieces[i] && result->flat ? result : nullptr;
}

int counterpartOf(const Symmetry& symmetry, int piece) {
    const std::vector<int>& counterpart = symmetry.pieces.counterpart;
    const auto i = static_cast<std::size_t>(piece);
    return i < counterpart.size() ? counterpart[i] : -1;
}

/// A place on the outline or on the rim of a hole: arc length in 3D, mm.
struct RimPlace {
    const seam::Outline* rim = nullptr;
    double at = 0;
};

/// A piece with its rims, for transferring points to another piece.
class PieceRims {
public:
    explicit PieceRims(const PieceResult& result)
        : result_(result), outlines_(seam::buildOutlines({result.piece})) {}

    /// The rim place of a surface point; nothing if it is not on a rim. Found by its triangle,
    /// because the two sides of a cut coincide in space.
    std::optional<RimPlace> placeOf(const SurfaceLinks& links, const SurfacePoint& point) const {
        const Eigen::Vector3d& weight = point.barycentric;
        for (int k = 0; k < 3; ++k) {
            if (weight[k] > 1 - kOnRim) {
                return placeFrom(links.mesh().F(point.face, k), 0);
            }
        }
        for (int k = 0; k < 3; ++k) {
            const int use = 3 * point.face + k, next = (k + 1) % 3;
            if (links.twin(use) < 0 && weight[(k + 2) % 3] < kOnRim) {
                return placeFrom(links.tail(use), weight[next] / (weight[k] + weight[next]));
            }
        }
        return std::nullopt;
    }

    /// The rim place nearest to a point of the flat piece.
    RimPlace nearest(const Eigen::RowVector2d& point) const {
        RimPlace nearest;
        double least = std::numeric_limits<double>::infinity();
        for (const seam::Outline& rim : outlines_.list) {
            const auto flat = geometry::Line::closed(result_.flat->Q(rim.vertices, Eigen::all),
                                                     rim.line.arc().values());
            const double at = flat.nearestPlace(point);
            if (const double distance = (flat.pointAt(at) - point).norm(); distance < least) {
                least = distance;
                nearest = {&rim, at};
            }
        }
        return nearest;
    }

    const seam::Outline& outline() const { return outlines_.list.front(); }

private:
    /// On the edge from a vertex, at a share of it.
    std::optional<RimPlace> placeFrom(int vertex, double share) const {
        for (const seam::Outline& rim : outlines_.list) {
            const auto found = std::ranges::find(rim.vertices, vertex);
            if (found != rim.vertices.end()) {
                const auto k = static_cast<std::size_t>(found - rim.vertices.begin());
                return RimPlace{&rim, std::lerp(rim.arcOf(k), rim.arcOf(k + 1), share)};
            }
        }
        return std::nullopt;
    }

    const PieceResult& result_;
    seam::Outlines outlines_;
};

/// The flat piece in the plane z = 0.
MeshArrays flatMesh(const PieceResult& result) {
    MeshArrays mesh{Points3::Zero(result.flat->Q.rows(), 3), result.piece->mesh.F};
    mesh.V.leftCols<2>() = result.flat->Q;
    return mesh;
}

/// Transfers points of a flat piece to its counterpart.
class MirroredSurface {
public:
    MirroredSurface(const Garment& garment, const Symmetry& symmetry, const PieceResult& piece,
                    const PieceResult& counterpart, int index)
        : garment_(garment),
          symmetry_(symmetry),
          piece_(piece),
          other_(counterpart),
          index_(index),
          reflection_(reflectionBetween(piece, counterpart, symmetry.plane)),
          rims_(piece),
          otherRims_(counterpart),
          flatOther_(flatMesh(counterpart)),
          nearest_(flatOther_) {}

    Eigen::Vector3d image(const SurfaceLinks& links, const SurfacePoint& point) const {
        const Eigen::RowVector2d flat =
            reflection_.appliedToRow(flatPositionOf(piece_.flat->Q, links.mesh().F, point));
        const auto rim = rims_.placeOf(links, point);
        if (!rim) {
            return positionOf(other_.piece->mesh, nearest_.find({flat.x(), flat.y(), 0}));
        }
        const bool isOnOutline = rim->rim == &rims_.outline();
        if (const auto at = isOnOutline ? mirroredPlace(rim->at) : std::nullopt) {
            return otherRims_.outline().pointAt(*at);
        }
        const RimPlace there = otherRims_.nearest(flat);
        return there.rim->pointAt(there.at);
    }

private:
    /// On the counterpart's outline, if the segment has a counterpart.
    std::optional<double> mirroredPlace(double at) const {
        const auto piece = static_cast<std::size_t>(index_);
        const auto other = static_cast<std::size_t>(symmetry_.pieces.counterpart[piece]);
        const std::vector<MirrorSegment>& segments = symmetry_.segments[piece];
        for (std::size_t i = 0; i < segments.size(); ++i) {
            const int pair = symmetry_.pairs[piece][i];
            const SeamSide& side = sideOf(garment_, segments[i]);
            const double length = side.length(), low = std::min(side.start, side.end);
            const bool isNextTurn = at < low - kOnRim * length;
            const double past = at - low + (isNextTurn ? rims_.outline().length() : 0);
            if (pair >= 0 && past <= (1 + kOnRim) * length) {
                const auto k = static_cast<std::size_t>(pair);
                const SeamSide& there = sideOf(garment_, symmetry_.segments[other][k]);
                const double share = std::clamp(past / length, 0.0, 1.0);
                return std::max(there.start, there.end) - share * there.length();
            }
        }
        return std::nullopt;
    }

    const Garment& garment_;
    const Symmetry& symmetry_;
    const PieceResult &piece_, &other_;
    int index_;
    Placement reflection_;
    PieceRims rims_, otherRims_;
    MeshArrays flatOther_;
    NearestSurface nearest_;  ///< of the counterpart
};

/// The piece that a cut is drawn on; -1 if there is none.
int pieceOf(const Garment& garment, const UserCut& cut, const Progress& progress) {
    const CutOwners owners = findCutOwners(garment.pieces, {cut}, progress);
    const auto owner =
        std::ranges::find_if(owners.cutsOf, [](const auto& cuts) { return !cuts.empty(); });
    return owner == owners.cutsOf.end() ? -1 : static_cast<int>(owner - owners.cutsOf.begin());
}

double distanceTo(const MeshArrays& mesh, const PathPolyline& line, const Eigen::Vector3d& point) {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 1; i < line.points.size(); ++i) {
        least =
            std::min(least, geometry::distanceToSegment(point, positionOf(mesh, line.points[i - 1]),
                                                        positionOf(mesh, line.points[i])));
    }
    return least;
}

/// Whether points lie on a line, within the tolerance of `kSameCut`.
bool lieOn(const std::vector<Eigen::Vector3d>& points, const MeshArrays& mesh,
           const PathPolyline& line) {
    const double size = (mesh.V.colwise().maxCoeff() - mesh.V.colwise().minCoeff()).norm();
    const double most = std::max(kSameCut, kSameCutShare * size);
    return std::ranges::all_of(
        points, [&](const Eigen::Vector3d& p) { return distanceTo(mesh, line, p) <= most; });
}

std::vector<Eigen::Vector3d> positionsOn(const MeshArrays& mesh, const PathPolyline& line) {
    std::vector<Eigen::Vector3d> points;
    for (const SurfacePoint& point : line.points) {
        points.push_back(positionOf(mesh, point));
    }
    return points;
}

/// The share of a line that runs along edges of a piece.
double shareBesideEdges(const Piece& piece, const std::vector<Eigen::Vector3d>& line) {
    constexpr double kSpacing = 2 * kBesideEdge;  // mm
    std::vector<std::pair<Eigen::Vector3d, Eigen::Vector3d>> edges;
    const auto addLoop = [&](const std::vector<int>& loop) {
        for (std::size_t k = 0; k < loop.size(); ++k) {
            edges.emplace_back(piece.mesh.V.row(loop[k]),
                               piece.mesh.V.row(loop[(k + 1) % loop.size()]));
        }
    };
    addLoop(piece.boundary);
    std::ranges::for_each(piece.holes, addLoop);
    const auto isBeside = [&edges](const Eigen::Vector3d& p) {
        return std::ranges::any_of(edges, [&p](const auto& edge) {
            return geometry::distanceToSegment(p, edge.first, edge.second) <= kBesideEdge;
        });
    };
    double beside = 0, length = 0;
    for (std::size_t i = 1; i < line.size(); ++i) {
        const Eigen::Vector3d &a = line[i - 1], &b = line[i];
        const double part = (b - a).norm();
        const int steps = 1 + static_cast<int>(std::min(part / kSpacing, 1e4));
        for (int k = 0; k < steps; ++k) {
            const bool is = isBeside(a + (k + 0.5) / steps * (b - a));
            beside += is ? part / steps : 0;
        }
        length += part;
    }
    return length > 0 ? beside / length : 0;
}

}  // namespace

std::optional<CutImage> imageOfCut(const Garment& garment, const PieceResults& results,
                                   const Symmetry& symmetry, const UserCut& cut,
                                   const Progress& progress) {
    const int index = pieceOf(garment, cut, progress), other = counterpartOf(symmetry, index);
    const PieceResult* const piece = flatResult(garment, results, index);
    const PieceResult* const counterpart = flatResult(garment, results, other);
    if (!piece || !counterpart || progress.isCancelled()) {
        return std::nullopt;
    }
    const MeshArrays& mesh = piece->piece->mesh;
    const SurfaceLinks links(mesh, piece->piece->table);
    const NearestSurface nearest(mesh);
    const auto line = traceUserCut(links, nearest, cut, progress);
    const auto points = pointsOfCut(links, nearest, cut);
    if (!line || !points || progress.isCancelled()) {
        return std::nullopt;
    }
    const MirroredSurface mirrored(garment, symmetry, *piece, *counterpart, index);
    UserCut image;
    image.kind = cut.kind;
    image.alongEdges = cut.alongEdges;
    for (const SurfacePoint& point : *points) {
        if (progress.isCancelled()) {
            return std::nullopt;
        }
        image.points.push_back(mirrored.image(links, point));
    }
    if (index == other && lieOn(image.points, mesh, *line)) {
        return std::nullopt;
    }
    const Piece& there = *counterpart->piece;
    const SurfaceLinks linksThere(there.mesh, there.table);
    auto way = traceUserCut(linksThere, NearestSurface(there.mesh), image, progress);
    // Shares of the image's length that must run along edges, and of the drawn cut's that may.
    constexpr double kImageBesideEdges = 0.8, kDrawnBesideEdges = 0.4;
    if (!way || progress.isCancelled()) {
        return std::nullopt;
    }
    const std::vector<Eigen::Vector3d> drawn = positionsOn(mesh, *line);
    std::vector<Eigen::Vector3d> reflected;  // in space: a cut on one side only bends flat pieces
    for (const Eigen::Vector3d& point : drawn) {
        reflected.push_back(symmetry.plane.reflected(point));
    }
    if (shareBesideEdges(*piece->piece, drawn) < kDrawnBesideEdges &&
        std::max(shareBesideEdges(there, positionsOn(there.mesh, *way)),
                 shareBesideEdges(there, reflected)) > kImageBesideEdges) {
        return std::nullopt;
    }
    return CutImage{std::move(image), other, std::move(*way)};
}

std::optional<UserCut> mirroredCut(const Garment& garment, const PieceResults& results,
                                   const Symmetry& symmetry, const UserCut& cut,
                                   const Progress& progress) {
    auto image = imageOfCut(garment, results, symmetry, cut, progress);
    return image ? std::optional(std::move(image->cut)) : std::nullopt;
}

std::optional<double> mirroredDirection(const Garment& garment, const PieceResults& results,
                                        const Symmetry& symmetry, int piece, double direction) {
    const int other = counterpartOf(symmetry, piece);
    const PieceResult* const here = flatResult(garment, results, piece);
    const PieceResult* const there = flatResult(garment, results, other);
    if (piece == other || !here || !there) {
        return std::nullopt;
    }
    return directionOnSheet(reflectionBetween(*here, *there, symmetry.plane), direction);
}

}  // namespace toile
