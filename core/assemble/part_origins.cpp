// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/assemble/part_origins.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/geometry/disjoint_sets.h"
#include "core/geometry/line.h"
#include "core/geometry/segment.h"
#include "core/mesh/mesh_arrays.h"

namespace toile {
namespace {

/// A run of a cut between two parts.
struct Border {
    std::size_t cut;
    int left, right;
};

/// Positions of consecutive points along a path, mm: where a cut runs along another one, nothing
/// opens, and positions stay the same if that is undone.
class PathPlaces {
public:
    PathPlaces(const MeshArrays& mesh, const PathPolyline& path)
        : line_(geometry::SpaceLine::open(pointsOf(mesh, path))) {}

    double length() const { return line_.length(); }

    double of(const Eigen::RowVector3d& point) {
        double least = std::numeric_limits<double>::infinity(), along = 0;
        for (int k = edge_; k < line_.arc().edgeCount(); ++k) {
            const Eigen::RowVector3d a = line_.point(k), b = line_.point(k + 1);
            const double t = geometry::nearestShare(point, a, b);
            const double away = (a + t * (b - a) - point).norm();
            if (away < least) {
                least = away;
                edge_ = k;
                along = std::lerp(line_.arc()[k], line_.arc()[k + 1], t);
            }
        }
        return along;
    }

private:
    static Points3 pointsOf(const MeshArrays& mesh, const PathPolyline& path) {
        Points3 points(static_cast<Eigen::Index>(path.points.size()), 3);
        for (std::size_t k = 0; k < path.points.size(); ++k) {
            points.row(static_cast<Eigen::Index>(k)) = positionOf(mesh, path.points[k]).transpose();
        }
        return points;
    }

    geometry::SpaceLine line_;
    int edge_ = 0;  ///< of the last place
};

}  // namespace

std::vector<Lineage> partLineages(const Lineage& whole, std::span<const CutId> cuts,
                                  const CutResult& cut, const std::vector<int>& partOf, int parts) {
    std::vector<Border> borders;
    for (std::size_t c = 0; c < cuts.size(); ++c) {
        for (const CutRun& run : cut.cuts[c].runs) {
            const int left = partOf[run.left.front()], right = partOf[run.right.front()];
            if (left != right) {
                borders.push_back({c, left, right});
            }
        }
    }
    std::vector<Lineage> lineages(static_cast<std::size_t>(parts), whole);
    // As if the cuts were made one after the other: parts that later cuts separate are still
    // connected, and parts that this one separates were one before.
    std::vector<int> before(static_cast<std::size_t>(parts), 0);
    for (std::size_t c = 0; c < cuts.size(); ++c) {
        if (std::ranges::find(borders, c, &Border::cut) == borders.end()) {
            continue;  // it separates nothing
        }
        geometry::DisjointSets together(parts);
        for (const Border& border : borders) {
            if (border.cut > c) {
                together.join(border.left, border.right);
            }
        }
        std::vector<int> sideOf(static_cast<std::size_t>(parts), 0);  // per root
        std::unordered_map<int, std::pair<int, int>> count;  // per whole: left and right so far
        for (const Border& border : borders) {
            const int left = together.root(border.left), right = together.root(border.right);
            if (border.cut != c || left == right) {
                continue;
            }
            auto& [lefts, rights] = count[before[border.left]];
            sideOf[left] = sideOf[left] != 0 ? sideOf[left] : ++lefts;
            sideOf[right] = sideOf[right] != 0 ? sideOf[right] : -++rights;
        }
        for (int part = 0; part < parts; ++part) {
            before[part] = together.root(part);
            if (const int side = sideOf[before[part]]; side != 0) {
                lineages[part].sides.push_back({cuts[c], side});
            }
        }
    }
    return lineages;
}

PartOrigins::PartOrigins(const Piece& piece, std::span<const CutId> cuts,
                         const std::vector<PathPolyline>& paths, const CutResult& cut)
    : piece_(piece), cut_(cut) {
    for (std::size_t c = 0; c < cuts.size(); ++c) {
        const LineId line = lineOf(cuts[c]);
        PathPlaces places(piece.mesh, paths[c]);
        for (const CutRun& run : cut.cuts[c].runs) {
            double along = places.of(cut.mesh.V.row(run.left.front()));
            for (std::size_t k = 0; k + 1 < run.left.size(); ++k) {
                const double from = along / places.length();
                along += (cut.mesh.V.row(run.left[k + 1]) - cut.mesh.V.row(run.left[k])).norm();
                const double to = along / places.length();
                opened_[run.left[k]] = {run.left[k], run.left[k + 1], line, cuts[c], from, to};
                opened_[run.right[k + 1]] = {run.right[k + 1], run.right[k], line,
                                             cuts[c],          to,           from};
            }
        }
    }
}

const EdgeOrigin* PartOrigins::rimAt(int vertex) const {
    if (cut_.sourceVertex[vertex] >= 0) {
        return originAt(piece_.origins, cut_.sourceVertex[vertex]);
    }
    const SurfacePoint& place = cut_.place[vertex];
    for (int k = 0; k < 3 && place.face >= 0; ++k) {
        const EdgeOrigin* edge = originAt(piece_.origins, piece_.mesh.F(place.face, k));
        if (edge && edge->head == piece_.mesh.F(place.face, (k + 1) % 3) &&
            place.barycentric[(k + 2) % 3] <= kOnEdge) {
            return edge;
        }
    }
    return nullptr;
}

std::optional<double> PartOrigins::shareOn(const EdgeOrigin& edge, int vertex) const {
    const int source = cut_.sourceVertex[vertex];
    if (source >= 0) {
        return source == edge.tail   ? std::optional(0.0)
               : source == edge.head ? std::optional(1.0)
                                     : std::nullopt;
    }
    return rimAt(vertex) == &edge
               ? std::optional((cut_.mesh.V.row(vertex) - piece_.mesh.V.row(edge.tail)).norm() /
                               (piece_.mesh.V.row(edge.head) - piece_.mesh.V.row(edge.tail)).norm())
               : std::nullopt;
}

std::vector<EdgeOrigin> PartOrigins::of(const Piece& part, const std::vector<int>& vertex) const {
    std::vector<EdgeOrigin> origins;
    for (Eigen::Index e = 0; e < part.table.edges.rows(); ++e) {
        if (!part.table.isBorder(e)) {
            continue;
        }
        const int side = part.table.usesOf(e)[0];
        const int tail = tailOf(part.mesh.F, side), head = headOf(part.mesh.F, side);
        const auto opened = opened_.find(vertex[tail]);
        if (opened != opened_.end() && opened->second.head == vertex[head]) {
            EdgeOrigin origin = opened->second;
            origin.tail = tail;
            origin.head = head;
            origins.push_back(origin);
        } else if (const EdgeOrigin* rim = rimAt(vertex[tail])) {
            const auto from = shareOn(*rim, vertex[tail]), to = shareOn(*rim, vertex[head]);
            if (from && to) {
                const double whole = rim->to - rim->from;
                origins.push_back({tail, head, rim->line, rim->cut, rim->from + *from * whole,
                                   rim->from + *to * whole});
            }
        }
    }
    std::ranges::sort(origins, {}, &EdgeOrigin::tail);
    return origins;
}

}  // namespace toile
