// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/pattern/internal_lines.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "core/assemble/file_space.h"
#include "core/cut/surface_paths.h"
#include "core/cut/surface_point.h"
#include "core/geometry/buckets.h"
#include "core/geometry/segment.h"
#include "core/mesh/mesh_arrays.h"

namespace toile {
namespace {

/// Straight lines over triangles, in the plane or in space.

/// Weights closer than this are equal: some nanometres in large triangles.
inline constexpr double kSameWeight = 1e-6;

/// The part of a straight line that lies in a triangle.
struct FaceSpan {
    int face = -1;
    double from = 0, to = 1;     ///< shares of the line
    Eigen::Vector3d start, end;  ///< barycentric, of the whole line's ends

    SurfacePoint at(double share) const;
};

/// A weight this little below zero is still in the triangle, and shares this near are equal.
constexpr double kOutside = 1e-9, kSameShare = 1e-9;

SurfacePoint FaceSpan::at(double share) const {
    const Eigen::Vector3d weights = ((1 - share) * start + share * end).cwiseMax(0.0);
    return {face, weights / weights.sum()};
}

/// @param start  @param end  barycentric weights of the line's ends in the triangle's plane
/// @return nothing if the line passes the triangle, or only touches it
std::optional<FaceSpan> spanIn(int face, const Eigen::Vector3d& start, const Eigen::Vector3d& end) {
    FaceSpan span{face, 0, 1, start, end};
    for (int k = 0; k < 3; ++k) {
        const double before = start[k] + kOutside, after = end[k] + kOutside;
        if (before < 0 && after < 0) {
            return std::nullopt;
        }
        if (before < 0) {
            span.from = std::max(span.from, before / (before - after));
        } else if (after < 0) {
            span.to = std::min(span.to, before / (before - after));
        }
    }
    // The comparison is also false for NaN.
    return span.to - span.from > kSameShare ? std::optional(span) : std::nullopt;
}

/// The parts of a line in a flat piece.
/// @param Q  vertices, #V x 2  Cost: linear in the faces. Pure.
std::vector<FaceSpan> flatSpans(const Points2& Q, const Triangles& F, const Eigen::RowVector2d& a,
                                const Eigen::RowVector2d& b) {
    const Eigen::RowVector2d low = a.cwiseMin(b), high = a.cwiseMax(b);
    std::vector<FaceSpan> spans;
    for (int f = 0; f < F.rows(); ++f) {
        const Eigen::RowVector2d p = Q.row(F(f, 0)), q = Q.row(F(f, 1)), r = Q.row(F(f, 2));
        if ((p.cwiseMin(q).cwiseMin(r).array() > high.array()).any() ||
            (p.cwiseMax(q).cwiseMax(r).array() < low.array()).any()) {
            continue;
        }
        const double area = geometry::cross(q - p, r - p);
        const auto weights = [&](const Eigen::RowVector2d& x) -> Eigen::Vector3d {
            return Eigen::Vector3d(geometry::cross(q - x, r - x), geometry::cross(r - x, p - x),
                                   geometry::cross(p - x, q - x)) /
                   area;
        };
        if (area != 0) {
            if (const auto span = spanIn(f, weights(a), weights(b))) {
                spans.push_back(*span);
            }
        }
    }
    return spans;
}

/// Barycentric weights of a point in space, projected to the plane of a triangle.
/// @return nothing if it is farther from that plane than `reach`, or the triangle has no area
std::optional<Eigen::Vector3d> weightsIn(const MeshArrays& mesh, int face,
                                         const Eigen::Vector3d& point, double reach) {
    const Eigen::Vector3d p = mesh.V.row(mesh.F(face, 0)), q = mesh.V.row(mesh.F(face, 1)),
                          r = mesh.V.row(mesh.F(face, 2));
    const Eigen::Vector3d normal = (q - p).cross(r - p);
    const double square = normal.squaredNorm();
    if (!(square > 0) || std::abs(normal.dot(point - p)) > reach * std::sqrt(square)) {
        return std::nullopt;
    }
    const double ofQ = normal.dot((r - p).cross(p - point)) / square;
    const double ofR = normal.dot((q - p).cross(point - p)) / square;
    return Eigen::Vector3d(1 - ofQ - ofR, ofQ, ofR);
}

/// True if both are one point of the surface: at the same place of the same edge, or in one
/// triangle. The two sides of a cut, which coincide in space, are two places.
bool isOnePlace(const Triangles& F, const SurfacePoint& a, const SurfacePoint& b) {
    if (a.face == b.face) {
        return (a.barycentric - b.barycentric).cwiseAbs().maxCoeff() < kSameWeight;
    }
    double shared = 0;
    for (int i = 0; i < 3; ++i) {
        for (int k = 0; k < 3; ++k) {
            if (F(a.face, i) == F(b.face, k)) {
                if (std::abs(a.barycentric[i] - b.barycentric[k]) > kSameWeight) {
                    return false;
                }
                shared += a.barycentric[i];
            }
        }
    }
    return shared > 1 - 2 * kSameWeight;
}

/// The straight path from a to b in the flat piece: points where it enters another triangle.
/// Nothing if it leaves the cloth, or would cross a cut.
/// Cost: linear in the faces, quadratic in those it crosses. Pure.
std::optional<std::vector<SurfacePoint>> straightWay(const Points2& Q, const Triangles& F,
                                                     const SurfacePoint& a, const SurfacePoint& b) {
    const std::vector<FaceSpan> spans =
        flatSpans(Q, F, flatPositionOf(Q, F, a), flatPositionOf(Q, F, b));
    std::vector<SurfacePoint> way{a};
    double at = 0;
    while (at < 1 - kSameShare) {
        const FaceSpan* next = nullptr;
        for (const FaceSpan& span : spans) {
            const bool goesOn = span.from <= at + kSameShare && span.to > at + kSameShare;
            if (goesOn && (!next || span.to > next->to) && isOnePlace(F, way.back(), span.at(at))) {
                next = &span;
            }
        }
        if (!next) {
            return std::nullopt;
        }
        at = next->to;
        way.push_back(next->at(at));
    }
    if (!isOnePlace(F, way.back(), b)) {
        return std::nullopt;
    }
    way.back() = b;
    return way;
}

/// mm: between surfaces nearer to each other, the other points of the line decide.
constexpr double kOneSurface = 1;
/// Smaller weights are rounding: the point lies on the edge.
constexpr double kNoWeight = 1e-9;
/// Part of the bounding box's diagonal: points this near to a plane lie in it.
constexpr double kInPlane = 1e-9;

/// A triangle of a piece of the garment.
struct PieceFace {
    int piece = -1, face = -1;
};

struct PlaceOnPiece {
    int piece = -1;
    SurfacePoint at;
};

/// Key shared by the parts of a face of the file; 0 if the face is not from the file.
int sourceKey(const Piece& piece, int face) {
    const auto f = static_cast<std::size_t>(face);
    return f < piece.sourceFace.size() ? std::max(piece.sourceFace[f], -1) + 1 : 0;
}

/// A piece before it was cut, with its present triangles; members are computed on demand.
class WholePiece {
public:
    /// @param parts  indices of its present pieces
    WholePiece(std::shared_ptr<const Piece> whole, const Garment& garment, std::vector<int> parts)
        : whole_(std::move(whole)),
          garment_(garment),
          parts_(std::move(parts)),
          isCut_(parts_.size() != 1 || garment.pieces[parts_.front()] != whole_) {
        const Points3& V = whole_->mesh.V;
        box_ = {V.colwise().minCoeff().transpose(), V.colwise().maxCoeff().transpose()};
    }

    const MeshArrays& mesh() const { return whole_->mesh; }
    const Eigen::AlignedBox3d& box() const { return box_; }
    double inPlane() const { return kInPlane * box_.diagonal().norm(); }

    SurfacePoint nearest(const Eigen::Vector3d& point) {
        if (!nearest_) {
            nearest_.emplace(whole_->mesh);
        }
        SurfacePoint found = nearest_->find(point);
        for (double& weight : found.barycentric) {
            weight = weight < kNoWeight ? 0 : weight;
        }
        found.barycentric /= found.barycentric.sum();
        return found;
    }

    /// Links to neighbours, for paths.
    const SurfaceLinks& links() {
        if (!links_) {
            links_.emplace(whole_->mesh, whole_->table);
        }
        return *links_;
    }

    /// Present triangles of a triangle, or of others with the same source face.
    std::vector<PieceFace> partsOf(int face) {
        if (!isCut_) {
            return {{parts_.front(), face}};
        }
        if (partFaces_.keyCount() == 0) {
            findParts();
        }
        const int key = sourceKey(*whole_, face);
        const auto faces =
            key < partFaces_.keyCount() ? partFaces_[key] : decltype(partFaces_[0]){};
        return {faces.begin(), faces.end()};
    }

    /// Present places of a point: on both sides of a cut.
    std::vector<PlaceOnPiece> placesOf(const SurfacePoint& point) {
        const Eigen::Vector3d position = positionOf(mesh(), point);
        std::vector<PlaceOnPiece> places;
        for (const int around : links().facesOf(links().carrierOf(point))) {
            for (const PieceFace& part : partsOf(around)) {
                const MeshArrays& there = garment_.pieces[part.piece]->mesh;
                const auto weights = weightsIn(there, part.face, position, inPlane());
                if (weights && weights->minCoeff() > -kSameWeight) {
                    const Eigen::Vector3d inside = weights->cwiseMax(0.0);
                    places.push_back({part.piece, {part.face, inside / inside.sum()}});
                }
            }
        }
        return places;
    }

private:
    void findParts() {
        int keys = 1;
        const auto forEach = [&](auto&& use) {
            for (const int p : parts_) {
                for (int f = 0; f < garment_.pieces[p]->mesh.F.rows(); ++f) {
                    use(sourceKey(*garment_.pieces[p], f), PieceFace{p, f});
                }
            }
        };
        forEach([&keys](int key, const PieceFace&) { keys = std::max(keys, key + 1); });
        partFaces_ = geometry::Buckets<PieceFace>(keys, forEach);
    }

    std::shared_ptr<const Piece> whole_;
    const Garment& garment_;
    std::vector<int> parts_;
    bool isCut_;
    Eigen::AlignedBox3d box_;
    std::optional<SurfaceLinks> links_;
    std::optional<NearestSurface> nearest_;
    geometry::Buckets<PieceFace> partFaces_;  ///< by `sourceKey`
};

struct Home {
    WholePiece* whole = nullptr;
    SurfacePoint at;
};

/// The pieces of the garment, grouped by uncut piece.
std::vector<std::unique_ptr<WholePiece>> wholePieces(const Garment& garment) {
    std::map<PieceId, int> indexOf;
    for (std::size_t p = 0; p < garment.pieces.size(); ++p) {
        indexOf.emplace(garment.pieces[p]->id, static_cast<int>(p));
    }
    Pieces wholeOf(garment.pieces);
    for (const CutRecord& record : garment.cutRecords) {
        for (const auto& part : record.pieces) {
            if (const auto found = indexOf.find(part->id); found != indexOf.end()) {
                wholeOf[static_cast<std::size_t>(found->second)] = record.whole;
            }
        }
    }
    std::vector<std::unique_ptr<WholePiece>> wholes;
    std::vector<bool> isDone(wholeOf.size());
    for (std::size_t p = 0; p < wholeOf.size(); ++p) {
        std::vector<int> parts;
        for (std::size_t k = p; k < wholeOf.size(); ++k) {
            if (!isDone[k] && wholeOf[k] == wholeOf[p]) {
                isDone[k] = true;
                parts.push_back(static_cast<int>(k));
            }
        }
        const MeshArrays& mesh = wholeOf[p]->mesh;
        if (!parts.empty() && mesh.F.rows() > 0 && mesh.V.allFinite()) {
            wholes.push_back(std::make_unique<WholePiece>(wholeOf[p], garment, parts));
        }
    }
    return wholes;
}

/// The whole piece and the place on it of each point of a line; empty for points far from all.
std::vector<Home> homesOf(const std::vector<std::unique_ptr<WholePiece>>& wholes,
                          const std::vector<Eigen::Vector3d>& points, double reach) {
    constexpr double kNowhere = std::numeric_limits<double>::infinity();
    std::vector<std::vector<std::pair<double, SurfacePoint>>> found(wholes.size());
    std::vector<double> least(points.size(), kNowhere), sum(wholes.size(), 0);
    for (std::size_t w = 0; w < wholes.size(); ++w) {
        for (std::size_t i = 0; i < points.size(); ++i) {
            double distance = wholes[w]->box().exteriorDistance(points[i]);
            SurfacePoint at;
            if (distance <= reach) {
                at = wholes[w]->nearest(points[i]);
                distance = (positionOf(wholes[w]->mesh(), at) - points[i]).norm();
            }
            least[i] = std::min(least[i], distance);
            sum[w] += distance;
            found[w].emplace_back(distance, at);
        }
    }
    std::vector<Home> homes(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
        double best = kNowhere;
        for (std::size_t w = 0; w < wholes.size(); ++w) {
            const auto& [distance, at] = found[w][i];
            if (distance <= std::min(reach, least[i] + kOneSurface) && sum[w] < best) {
                best = sum[w];
                homes[i] = {wholes[w].get(), at};
            }
        }
    }
    return homes;
}

/// Joins the legs of a line into runs.
class RunBuilder {
public:
    RunBuilder(const Garment& garment, const PieceResults& results, int line)
        : garment_(garment), results_(results), line_(line) {}

    void drill(const Home& home) {
        const auto places = home.whole->placesOf(home.at);
        if (!places.empty()) {
            append(places.front().piece, {places.front().at});
        }
    }

    void join(const Home& a, const Home& b) {
        if (!a.whole || a.whole != b.whole) {
            runIsOver_ = true;
            return;
        }
        if (!joinStraight(a, b)) {
            joinAlongSurface(*a.whole, a.at, b.at);
        }
    }

    /// @param closed  the last leg ends where the first one starts
    std::vector<InternalRun> take(bool closed) {
        if (closed && !runs_.empty() && meet(runs_.back(), runs_.front())) {
            if (runs_.size() == 1) {
                runs_.front().closed = true;
            } else {
                InternalRun last = std::move(runs_.back());
                runs_.pop_back();
                std::vector<SurfacePoint>& first = runs_.front().way;
                last.way.insert(last.way.end(), first.begin() + 1, first.end());
                first = std::move(last.way);
            }
        }
        return std::move(runs_);
    }

private:
    const Triangles& facesOf(int piece) const { return garment_.pieces[piece]->mesh.F; }

    bool meet(const InternalRun& before, const InternalRun& after) const {
        return before.piece == after.piece && before.way.size() > 1 && after.way.size() > 1 &&
               isOnePlace(facesOf(before.piece), before.way.back(), after.way.front());
    }

    bool goesOn(int piece, const SurfacePoint& from) const {
        return !runIsOver_ && !runs_.empty() && runs_.back().piece == piece &&
               isOnePlace(facesOf(piece), runs_.back().way.back(), from);
    }

    void append(int piece, const std::vector<SurfacePoint>& way) {
        if (!goesOn(piece, way.front())) {
            runs_.push_back({line_, piece, false, {way.front()}});
            runIsOver_ = false;
        }
        std::vector<SurfacePoint>& run = runs_.back().way;
        run.insert(run.end(), way.begin() + 1, way.end());
    }

    bool joinStraight(const Home& a, const Home& b) {
        const auto from = a.whole->placesOf(a.at), to = b.whole->placesOf(b.at);
        std::optional<std::pair<int, std::vector<SurfacePoint>>> found;
        for (const PlaceOnPiece& begin : from) {
            const auto i = static_cast<std::size_t>(begin.piece);
            const PieceResult* result = i < results_.size() ? results_[i].get() : nullptr;
            if (!result || !result->flat || result->piece != garment_.pieces[i]) {
                continue;
            }
            for (const PlaceOnPiece& end : to) {
                // Prefer to continue on the current run, not on the other side of a cut.
                if (end.piece != begin.piece || (found && !goesOn(begin.piece, begin.at))) {
                    continue;
                }
                if (auto way =
                        straightWay(result->flat->Q, facesOf(begin.piece), begin.at, end.at)) {
                    found.emplace(begin.piece, std::move(*way));
                    if (goesOn(begin.piece, begin.at)) {
                        append(found->first, found->second);
                        return true;
                    }
                }
            }
        }
        if (found) {
            append(found->first, found->second);
        }
        return found.has_value();
    }

    void joinAlongSurface(WholePiece& whole, const SurfacePoint& from, const SurfacePoint& to) {
        const auto path = geodesicPath(whole.links(), from, to);
        if (!path) {
            runIsOver_ = true;
            return;
        }
        for (std::size_t i = 1; i < path->points.size(); ++i) {
            const SurfacePoint &a = path->points[i - 1], &b = path->points[i];
            addStep(whole, whole.links().commonFace(a, b), positionOf(whole.mesh(), a),
                    positionOf(whole.mesh(), b));
        }
    }

    /// A straight step within a triangle, split over its present triangles.
    void addStep(WholePiece& whole, int face, const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
        std::vector<std::pair<int, FaceSpan>> spans;
        for (const PieceFace& part : face < 0 ? std::vector<PieceFace>() : whole.partsOf(face)) {
            const MeshArrays& mesh = garment_.pieces[part.piece]->mesh;
            const auto start = weightsIn(mesh, part.face, a, whole.inPlane());
            const auto end = weightsIn(mesh, part.face, b, whole.inPlane());
            if (start && end) {
                if (const auto span = spanIn(part.face, *start, *end)) {
                    spans.emplace_back(part.piece, *span);
                }
            }
        }
        constexpr double kRest = 1e-9;  // of the step
        double at = 0;
        while (at < 1 - kRest) {
            const std::pair<int, FaceSpan>* next = nullptr;
            std::pair<bool, double> best{false, at + kRest};
            double gap = 1;
            for (const auto& span : spans) {
                const FaceSpan& there = span.second;
                if (there.from > at + kRest) {
                    gap = std::min(gap, there.from);
                    continue;
                }
                const std::pair<bool, double> rank{goesOn(span.first, there.at(at)), there.to};
                if (there.to > at + kRest && rank > best) {
                    best = rank;
                    next = &span;
                }
            }
            if (next) {
                append(next->first, {next->second.at(at), next->second.at(next->second.to)});
            }
            at = next ? next->second.to : gap;
        }
    }

    const Garment& garment_;
    const PieceResults& results_;
    int line_;
    std::vector<InternalRun> runs_;
    bool runIsOver_ = false;
};

}  // namespace

std::vector<InternalRun> findInternalRuns(const Garment& garment, const PieceResults& results,
                                          const std::vector<InternalLine>& lines) {
    std::vector<InternalRun> runs;
    if (lines.empty()) {
        return runs;
    }
    const auto wholes = wholePieces(garment);
    Eigen::AlignedBox3d box;
    for (const auto& whole : wholes) {
        box.extend(whole->box());
    }
    const double reach = box.isEmpty() ? 0 : kFarFromCloth * box.diagonal().norm();
    for (std::size_t k = 0; k < lines.size(); ++k) {
        const std::vector<Eigen::Vector3d> points = inPieceSpace(lines[k].points, garment);
        if (!std::ranges::all_of(points, [](const auto& p) { return p.allFinite(); })) {
            continue;
        }
        const std::vector<Home> homes = homesOf(wholes, points, reach);
        RunBuilder builder(garment, results, static_cast<int>(k));
        const bool closed = lines[k].closed && homes.size() > 2;
        if (homes.size() == 1 && homes.front().whole) {
            builder.drill(homes.front());
        }
        for (std::size_t i = 1; i < homes.size() + (closed ? 1 : 0); ++i) {
            builder.join(homes[i - 1], homes[i % homes.size()]);
        }
        for (InternalRun& run : builder.take(closed)) {
            runs.push_back(std::move(run));
        }
    }
    return runs;
}

}  // namespace toile
