// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/prove/fresh_cloth.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>
#include <vector>

#include "core/base/result.h"
#include "core/base/statistics.h"
#include "core/geometry/disjoint_sets.h"
#include "core/geometry/polygon.h"
#include "core/linalg/sparse_cholesky.h"
#include "core/mesh/cotangents.h"
#include "core/prove/fresh_mesh.h"
#include "core/prove/pattern_faults.h"
#include "core/prove/proof_words.h"
#include "core/prove/stations.h"
#include "core/quality/measures.h"
#include "core/sew/seam_samples.h"

namespace toile::prove {
namespace {

/// Maps the points of a flat mesh to another plane in which some points are given: each other point
/// is the mean of its neighbours, by cotangent weights, so that motion and stretch in the plane are
/// interpolated ([DMA02]'s harmonic map).
/// @param given  the places of the first points  Errors: FactorisationFailed, OutOfMemory.
/// Cost: one factorisation. Pure.
Result<Points2> harmonicPlaces(const FreshMesh& mesh, const Points2& given) {
    /// Keeps all weights positive, so that two triangles across a rim do not pull an edge apart.
    constexpr double kMinWeight = 1e-6;
    const auto known = static_cast<int>(given.rows());
    const auto count = static_cast<int>(mesh.Q.rows());
    Points2 places(count, 2);
    places.topRows(known) = given;
    if (known == count) {
        return places;
    }
    MeshArrays flat{Points3::Zero(count, 3), mesh.F};
    flat.V.leftCols<2>() = mesh.Q;
    const EdgeTable table = buildEdgeTable(mesh.F, count);
    const Eigen::VectorXd weights = cotangentWeights(flat, table);
    linalg::SymmetricBuilder builder(count - known);
    Eigen::MatrixXd pull = Eigen::MatrixXd::Zero(count - known, 2);
    std::vector<char> isUsed(static_cast<std::size_t>(count - known), 0);
    for (Eigen::Index e = 0; e < table.edges.rows(); ++e) {
        const int a = table.edges(e, 0) - known, b = table.edges(e, 1) - known;
        const double weight = std::max(weights[e], kMinWeight);
        for (const auto& [here, there] : {std::pair(a, b), std::pair(b, a)}) {
            if (here >= 0) {
                isUsed[here] = 1;
                builder.add(here, here, weight);
                if (there < 0) {
                    pull.row(here) += weight * given.row(there + known);
                }
            }
        }
        if (a >= 0 && b >= 0) {
            builder.add(a, b, -weight);
        }
    }
    for (int k = 0; k < count - known; ++k) {
        if (isUsed[k] == 0) {
            builder.add(k, k, 1);
        }
    }
    linalg::SparseCholesky cholesky;
    if (const auto done = cholesky.factorise(builder.build()); !done) {
        return done.error();
    }
    const auto solved = cholesky.solve(pull);
    if (!solved) {
        return solved.error();
    }
    places.bottomRows(count - known) = *solved;
    return places;
}

constexpr double kMaxEdge = 30;  // mm
/// Edges are at least as long as those of this many squares that cover the cloth: some 100 000
/// triangles, and edges for dolls may be short.
constexpr double kMaxSquares = 50000;

/// With more triangles a step takes minutes, and a step cannot be cancelled.
constexpr double kMaxTriangles = 300000;

struct UsualEdge {
    double own;   ///< the median of the garment's own triangles' edges, mm
    double made;  ///< the edge length to use
};

double flatAreaOf(const Garment& garment, const RestPattern& pattern) {
    double area = 0;
    for (std::size_t p = 0; p < garment.pieces.size(); ++p) {
        if (pattern.pieces[p]) {
            area += std::abs(geometry::signedAreaOf(
                pattern.pieces[p]->flat(garment.pieces[p]->boundary, Eigen::all)));
        }
    }
    return area;
}

/// An error if the edge length gives more triangles than can be sewn.
std::optional<Error> tooFine(double edge, double area) {
    const double perSquare = 4 / std::sqrt(3.0);  // equilateral ones
    const double count = perSquare * area / (edge * edge);
    if (count <= kMaxTriangles) {
        return std::nullopt;
    }
    const double least = std::sqrt(perSquare * area / kMaxTriangles);
    return Error{ErrorCode::OutOfMemory, {}, edgesTooFine(edge, count, least)};
}

/// An error if the outlines of most pieces are much longer or shorter than on the garment.
std::optional<Error> inOtherUnit(const RestPattern& pattern, const FileUnit& read) {
    constexpr double kOtherUnit = 8;  // beyond ease, grading, and inches for centimetres
    std::vector<double> times;
    for (const auto& piece : pattern.pieces) {
        if (piece && !piece->loops.empty() && piece->loops.front()) {
            const RestLoop& outline = *piece->loops.front();
            times.push_back(outline.restLength(0, outline.length()) / outline.length());
        }
    }
    if (times.empty()) {
        return {};
    }
    const double median = medianOf(std::move(times));
    if (1 / kOtherUnit < median && median < kOtherUnit) {
        return {};
    }
    return Error{ErrorCode::NoGeometry, {}, patternInOtherUnit(median, read)};
}

UsualEdge usualEdge(const Garment& garment, const RestPattern& pattern) {
    std::vector<double> lengths;
    for (std::size_t p = 0; p < garment.pieces.size(); ++p) {
        if (pattern.pieces[p]) {
            const Piece& piece = *garment.pieces[p];
            const Eigen::VectorXd edges = edgeLengths3d(piece.mesh.V, piece.table.edges);
            lengths.insert(lengths.end(), edges.begin(), edges.end());
        }
    }
    const double usual = medianOf(std::move(lengths));
    const double least = std::min(std::sqrt(flatAreaOf(garment, pattern) / kMaxSquares), kMaxEdge);
    return {usual, std::clamp(usual, least, kMaxEdge)};
}

MeshArrays inSpace(const Points2& flat, const Triangles& F) {
    MeshArrays mesh{Points3::Zero(flat.rows(), 3), F};
    mesh.V.leftCols<2>() = flat;
    return mesh;
}

/// A triangulated piece.
struct PieceCloth {
    FreshMesh mesh;      ///< at rest; Q has the rims' points first
    Points2 places;      ///< its points in our flat piece
    Points3 worn;        ///< and on the garment
    int firstPoint = 0;  ///< index into the cloth's points
    std::vector<int> firstOfLoop;
};

/// The points along a piece's rims, in three positions.
struct RimPoints {
    std::vector<Points2> rest;  ///< loop by loop
    Points2 drawn;
    Points3 worn;
    std::vector<int> firstOfLoop;
};

RimPoints rimPoints(const RestPiece& rest, const std::vector<std::vector<double>>& places) {
    RimPoints rim;
    Eigen::Index count = 0, at = 0;
    for (const std::vector<double>& ofLoop : places) {
        count += static_cast<Eigen::Index>(ofLoop.size());
    }
    rim.drawn.resize(count, 2);
    rim.worn.resize(count, 3);
    for (std::size_t l = 0; l < rest.loops.size(); ++l) {
        rim.firstOfLoop.push_back(static_cast<int>(at));
        if (!rest.loops[l]) {
            continue;
        }
        Points2& loop = rim.rest.emplace_back(static_cast<Eigen::Index>(places[l].size()), 2);
        for (std::size_t k = 0; k < places[l].size(); ++k, ++at) {
            loop.row(static_cast<Eigen::Index>(k)) = rest.loops[l]->restAt(places[l][k]);
            rim.drawn.row(at) = rest.loops[l]->drawnAt(places[l][k]);
            rim.worn.row(at) = rest.loops[l]->spaceAt(places[l][k]);
        }
    }
    rim.rest.insert(rim.rest.end(), rest.others.begin(), rest.others.end());
    return rim;
}

/// Triangulates with points of a grid, or with the garment's vertices that are inside.
Result<PieceCloth> clothOf(const Piece& piece, const RestPiece& rest,
                           const std::vector<std::vector<double>>& places, double edge,
                           bool hasGrid) {
    PieceCloth cloth;
    RimPoints rim = rimPoints(rest, places);
    cloth.firstOfLoop = std::move(rim.firstOfLoop);
    auto mesh = freshMesh(rim.rest, edge, subjectOf(piece));
    if (!mesh) {
        return mesh.error();
    }
    auto found = harmonicPlaces(*mesh, rim.drawn);
    if (!found) {
        return found.error();
    }
    if (!hasGrid) {
        const MeshArrays grid = inSpace(*found, mesh->F);
        const NearestSurface nearest(grid);
        Points2 own(rest.flat.rows(), 2);
        for (Eigen::Index v = 0; v < own.rows(); ++v) {
            own.row(v) = flatPositionOf(mesh->Q, mesh->F,
                                        nearest.find({rest.flat(v, 0), rest.flat(v, 1), 0}));
        }
        mesh = freshMesh(rim.rest, edge, subjectOf(piece), &own);
        if (!mesh) {
            return mesh.error();
        }
        const Eigen::Index first =
            mesh->Q.rows() - static_cast<Eigen::Index>(mesh->insideOf.size());
        Points2 drawn(mesh->Q.rows(), 2);
        drawn << found->topRows(first), rest.flat(mesh->insideOf, Eigen::all);
        found = std::move(drawn);
    }
    cloth.mesh = std::move(*mesh);
    cloth.places = std::move(*found);
    const MeshArrays flat = inSpace(rest.flat, piece.mesh.F);
    const NearestSurface nearest(flat);
    cloth.worn.resize(cloth.places.rows(), 3);
    cloth.worn.topRows(rim.worn.rows()) = rim.worn;
    for (Eigen::Index v = rim.worn.rows(); v < cloth.places.rows(); ++v) {
        const Eigen::Vector3d at(cloth.places(v, 0), cloth.places(v, 1), 0);
        cloth.worn.row(v) = positionOf(piece.mesh, nearest.find(at)).transpose();
    }
    return cloth;
}

/// Turns the warp to the y axis.
Points2 alongWarp(const Points2& Q, double warp) {
    const double turn = std::numbers::pi / 2 - warp;
    return turn == 0 ? Q : Points2(Q * Eigen::Rotation2Dd(-turn).toRotationMatrix());
}

/// Places of the garment pieces' vertices on the cloth.
std::vector<SurfacePoint> placesOn(const sew::Cloth& cloth, int index, const PieceCloth& piece,
                                   const RestPiece& rest) {
    std::vector<int> faces;
    for (Eigen::Index f = 0; f < cloth.F.rows(); ++f) {
        if (cloth.pieceOf[f] == index) {
            faces.push_back(static_cast<int>(f));
        }
    }
    if (faces.empty()) {
        return {};
    }
    const Triangles F = cloth.patternF(faces, Eigen::all).array() - piece.firstPoint;
    const MeshArrays flat = inSpace(piece.places, F);
    const NearestSurface nearest(flat);
    std::vector<SurfacePoint> places;
    for (Eigen::Index v = 0; v < rest.flat.rows(); ++v) {
        places.push_back(nearest.find({rest.flat(v, 0), rest.flat(v, 1), 0}));
        places.back().face = faces[places.back().face];
    }
    return places;
}

sew::CutCloth cutOf(std::vector<std::optional<PieceCloth>>& pieces, const RestPattern& pattern,
                    const Stations& stations) {
    sew::CutCloth cut;
    Eigen::Index points = 0, faces = 0;
    for (auto& piece : pieces) {
        if (piece) {
            piece->firstPoint = static_cast<int>(points);
            points += piece->mesh.Q.rows();
            faces += piece->mesh.F.rows();
        }
    }
    cut.Q.resize(points, 2);
    cut.V.resize(points, 3);
    cut.F.resize(faces, 3);
    Eigen::Index f = 0;
    for (std::size_t p = 0; p < pieces.size(); ++p) {
        if (!pieces[p]) {
            continue;
        }
        const FreshMesh& mesh = pieces[p]->mesh;
        const Eigen::Index first = pieces[p]->firstPoint;
        cut.Q.middleRows(first, mesh.Q.rows()) = alongWarp(mesh.Q, pattern.pieces[p]->warp);
        cut.V.middleRows(first, mesh.Q.rows()) = pieces[p]->worn;
        cut.F.middleRows(f, mesh.F.rows()) = mesh.F.array() + static_cast<int>(first);
        f += mesh.F.rows();
        cut.pieceOf.insert(cut.pieceOf.end(), static_cast<std::size_t>(mesh.F.rows()),
                           static_cast<int>(p));
    }
    const auto pointOf = [&](const Station& station) {
        const PieceCloth& piece = *pieces[static_cast<std::size_t>(station.piece)];
        return piece.firstPoint + piece.firstOfLoop[static_cast<std::size_t>(station.loop)] +
               station.number;
    };
    for (const auto& [a, b] : stations.sewn) {
        if (pieces[static_cast<std::size_t>(a.piece)] &&
            pieces[static_cast<std::size_t>(b.piece)]) {
            cut.sewn.emplace_back(pointOf(a), pointOf(b));
        }
    }
    return cut;
}

}  // namespace

Result<FreshCloth> freshCloth(const ExportSource& source, const ProofOrder& order,
                              const Progress& progress) {
    const Garment& garment = source.garment();
    auto found = restPattern(source, order);
    if (!found) {
        return found.error();
    }
    RestPattern& pattern = *found;
    if (auto error = order.file ? inOtherUnit(pattern, order.file->unit) : std::nullopt) {
        return *std::move(error);
    }
    FreshCloth fresh;
    fresh.source = pattern.source;
    fresh.faults = std::move(pattern.faults);
    const UsualEdge usual = usualEdge(garment, pattern);
    // Points that are too close, or too far apart, give no good triangles.
    const bool hasGrid = order.settings.edge > 0 || usual.made != usual.own;
    const double edge = order.settings.edge > 0 ? order.settings.edge : usual.made;
    if (auto error = tooFine(edge, hasGrid ? flatAreaOf(garment, pattern) : 0)) {
        return *std::move(error);
    }
    const Stations stations = placeStations(garment.seams, pattern, edge, !hasGrid);
    std::vector<std::optional<PieceCloth>> pieces(garment.pieces.size());
    for (std::size_t p = 0; p < pieces.size(); ++p) {
        if (progress.isCancelled()) {
            return Error{ErrorCode::Cancelled};
        }
        if (!pattern.pieces[p]) {
            continue;
        }
        auto cloth =
            clothOf(*garment.pieces[p], *pattern.pieces[p], stations.places[p], edge, hasGrid);
        if (!cloth && cloth.error().code != ErrorCode::OutlineCrosses) {
            return cloth.error();
        }
        if (cloth) {
            pieces[p] = std::move(*cloth);
        } else {
            pattern.pieces[p].reset();
            fresh.faults.push_back(pieceCrossesItself(garment, static_cast<int>(p)));
        }
        progress.report(static_cast<double>(p + 1) / static_cast<double>(pieces.size()));
    }
    SeamLengths lengths = seamLengths(garment, pattern);
    fresh.seams = std::move(lengths.seams);
    std::ranges::move(lengths.faults, std::back_inserter(fresh.faults));
    fresh.cloth = sew::sewTogether(cutOf(pieces, pattern, stations));
    if (fresh.cloth.F.rows() == 0) {
        return Error{ErrorCode::NoGeometry, {}, nothingToSew()};
    }
    for (std::size_t p = 0; p < pieces.size(); ++p) {
        fresh.placeOf.emplace_back();
        if (pieces[p]) {
            fresh.placeOf[p] =
                placesOn(fresh.cloth, static_cast<int>(p), *pieces[p], *pattern.pieces[p]);
            if (fresh.placeOf[p].empty()) {
                fresh.faults.push_back(pieceSewnAway(garment, static_cast<int>(p)));
            }
        }
    }
    return fresh;
}

namespace {

/// Per piece whether its triangles run opposite to those of the first piece it is joined to.
std::vector<char> turnedPieces(const sew::CutCloth& cut, const Triangles& F, std::size_t pieces) {
    // Each side of a triangle, between joined points, with its piece and direction.
    struct Side {
        int low, high, piece;
        bool isUp;
    };
    std::vector<Side> sides;
    for (Eigen::Index f = 0; f < F.rows(); ++f) {
        for (int k = 0; k < 3; ++k) {
            const int a = F(f, k), b = F(f, (k + 1) % 3);
            if (a != b) {
                sides.push_back({std::min(a, b), std::max(a, b), cut.pieceOf[f], a < b});
            }
        }
    }
    std::ranges::stable_sort(sides, {}, [](const Side& s) { return std::pair(s.low, s.high); });
    std::map<std::pair<int, int>, int> votes;  // per pair of pieces: sides with the same direction
    for (std::size_t k = 0; k + 1 < sides.size(); ++k) {
        const Side &a = sides[k], &b = sides[k + 1];
        if (a.low == b.low && a.high == b.high && a.piece != b.piece) {
            const int vote = a.isUp == b.isUp ? -1 : 1;
            votes[{a.piece, b.piece}] += vote;
            votes[{b.piece, a.piece}] += vote;
        }
    }
    std::vector<char> isSeen(pieces, 0), isTurned(pieces, 0);
    for (std::size_t first = 0; first < pieces; ++first) {
        std::vector<int> queue{static_cast<int>(first)};
        while (!queue.empty()) {
            const int piece = queue.back();
            queue.pop_back();
            isSeen[piece] = 1;
            for (auto at = votes.lower_bound({piece, 0});
                 at != votes.end() && at->first.first == piece; ++at) {
                const int other = at->first.second;
                if (!isSeen[other] && at->second != 0) {
                    isSeen[other] = 1;
                    isTurned[other] = (isTurned[piece] != 0) == (at->second > 0) ? 1 : 0;
                    queue.push_back(other);
                }
            }
        }
    }
    return isTurned;
}

}  // namespace

Result<MeshArrays> designSurface(const Garment& garment) {
    std::vector<Points2> flat;
    for (const auto& piece : garment.pieces) {
        // The plane does not matter: an upright piece may have no area there.
        flat.emplace_back(piece->mesh.V.leftCols<2>());
    }
    const auto cut = sew::cutAlongSeams(garment, flat);
    if (!cut) {
        return cut.error();
    }
    geometry::DisjointSets sets(static_cast<int>(cut->V.rows()));
    for (const auto& [a, b] : cut->sewn) {
        sets.join(a, b);
    }
    Triangles joined = cut->F;
    for (int& corner : joined.reshaped()) {
        corner = sets.root(corner);
    }
    const auto isTurned = turnedPieces(*cut, joined, garment.pieces.size());
    MeshArrays surface{cut->V, Triangles(joined.rows(), 3)};
    Eigen::Index kept = 0;
    for (Eigen::Index f = 0; f < joined.rows(); ++f) {
        Eigen::RowVector3i corners = joined.row(f);
        if (corners[0] != corners[1] && corners[1] != corners[2] && corners[2] != corners[0]) {
            if (isTurned[cut->pieceOf[f]]) {
                std::swap(corners[1], corners[2]);
            }
            surface.F.row(kept++) = corners;
        }
    }
    surface.F.conservativeResize(kept, 3);
    return surface;
}

}  // namespace toile::prove
