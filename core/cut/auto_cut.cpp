// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/cut/auto_cut.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <set>
#include <string>
#include <vector>

#include "core/base/text.h"
#include "core/cut/straighten.h"
#include "core/cut/surface_paths.h"
#include "core/geometry/disjoint_sets.h"
#include "core/mesh/disk_check.h"

namespace toile {
namespace {

/// Paths along edges that open a connected, manifold, oriented mesh to one disk. Weights, one per
/// edge, define length; ties are decided by index. Each path is a list of vertices.
using EdgeWays = std::vector<std::vector<int>>;

/// A vertex that lacks at least this much of a full turn is a corner that a seam should reach.
constexpr double kSharpVertex = std::numbers::pi / 5;
constexpr int kMaxPeaks = 16;
constexpr int kBasePointsTried = 6;

struct Candidate {
    double length;
    int edge;
};

/// The path from source to source across an edge.
std::vector<int> pathOver(const SurfaceLinks& links, const geometry::ShortestForest& forest,
                          int edge) {
    const Edges& edges = links.table().edges;
    std::vector<int> way = forest.pathTo(edges(edge, 0), edges);
    const std::vector<int> rest = forest.pathTo(edges(edge, 1), edges);
    way.insert(way.end(), rest.rbegin(), rest.rend());
    return way;
}

/// Edges outside the forest, with the length of the path across each.
std::vector<Candidate> outside(const SurfaceLinks& links, const geometry::ShortestForest& forest,
                               const std::vector<double>& weights) {
    const Edges& edges = links.table().edges;
    std::vector<Candidate> candidates;
    for (int e = 0; e < links.edgeCount(); ++e) {
        if (!links.table().isBorder(e) && forest.parentEdge[edges(e, 0)] != e &&
            forest.parentEdge[edges(e, 1)] != e) {
            candidates.push_back(
                {forest.distance[edges(e, 0)] + weights[e] + forest.distance[edges(e, 1)], e});
        }
    }
    std::ranges::stable_sort(candidates, {}, &Candidate::length);
    return candidates;
}

/// The remaining paths after a tree of faces has crossed as many of the expensive edges as it can.
std::vector<Candidate> leftOver(const SurfaceLinks& links, const std::vector<Candidate>& sorted) {
    geometry::DisjointSets faces(links.faceCount());
    std::vector<Candidate> left;
    for (auto candidate = sorted.rbegin(); candidate != sorted.rend(); ++candidate) {
        const std::span<const int> use = links.table().usesOf(candidate->edge);
        if (faces.root(use[0] / 3) == faces.root(use[1] / 3)) {
            left.push_back(*candidate);
        } else {
            faces.join(use[0] / 3, use[1] / 3);
        }
    }
    std::reverse(left.begin(), left.end());
    return left;
}

int farthest(const geometry::ShortestForest& forest) {
    int best = 0;
    for (std::size_t v = 0; v < forest.distance.size(); ++v) {
        const double d = forest.distance[v];
        if (std::isfinite(d) && d > forest.distance[best]) {
            best = static_cast<int>(v);
        }
    }
    return best;
}

/// The sharpest vertices, or the two ends of the piece.
std::vector<int> peaks(const SurfaceLinks& links, const std::vector<double>& weights) {
    std::vector<std::pair<double, int>> sharp;
    for (int v = 0; v < links.vertexCount(); ++v) {
        const double missing = 2 * std::numbers::pi - links.angleAround(v);
        if (missing > kSharpVertex && !links.cornersAt(v).empty()) {
            sharp.emplace_back(-missing, v);
        }
    }
    std::sort(sharp.begin(), sharp.end());
    std::vector<int> result;
    for (std::size_t i = 0; i < sharp.size() && i < kMaxPeaks; ++i) {
        result.push_back(sharp[i].second);
    }
    const auto from = [&](int v) {
        return geometry::shortestForest(links.table().edges, links.vertexCount(), weights, {{v}});
    };
    if (result.empty()) {
        result.push_back(farthest(from(links.mesh().F(0, 0))));
    }
    if (result.size() == 1) {
        result.push_back(farthest(from(result.front())));
    }
    return result;
}

/// A graph of paths along edges, which is then split at its branchings.
class EdgeSet {
public:
    void add(const std::vector<int>& way) {
        for (std::size_t i = 1; i < way.size(); ++i) {
            neighbours_[way[i - 1]].insert(way[i]);
            neighbours_[way[i]].insert(way[i - 1]);
        }
    }

    /// Removes dead ends until every end is part of a loop.
    void prune() {
        std::vector<int> ends;
        for (const auto& [v, around] : neighbours_) {
            ends.push_back(v);
        }
        while (!ends.empty()) {
            const int v = ends.back();
            ends.pop_back();
            if (neighbours_[v].size() == 1) {
                const int w = *neighbours_[v].begin();
                remove(v, w);
                ends.push_back(w);
            }
        }
    }

    /// The graph as paths between its branchings and ends; a loop without either starts anywhere.
    std::vector<std::vector<int>> takeApart() {
        std::set<int> stops;
        for (const auto& [v, around] : neighbours_) {
            if (around.size() != 2) {
                stops.insert(v);
            }
        }
        std::vector<std::vector<int>> ways;
        for (const int v : stops) {
            while (!neighbours_[v].empty()) {
                ways.push_back(walk(v, stops));
            }
        }
        for (const auto& [v, around] : neighbours_) {
            if (!around.empty()) {
                ways.push_back(walk(v, {v}));
            }
        }
        return ways;
    }

private:
    void remove(int v, int w) {
        neighbours_[v].erase(w);
        neighbours_[w].erase(v);
    }

    std::vector<int> walk(int v, const std::set<int>& stops) {
        std::vector<int> way{v};
        do {
            const int next = *neighbours_[v].begin();
            remove(v, next);
            v = next;
            way.push_back(v);
        } while (!stops.contains(v));
        return way;
    }

    std::map<int, std::set<int>> neighbours_;
};

/// For a mesh with a rim: arcs from rim to rim, one less than there are loops plus two for every
/// handle. The shortest such arcs in turn, by a tree of shortest paths from the rim and the most
/// expensive tree of faces that does not cross it ([EW05], the rim as base point). For a piece
/// without handles they are the minimum spanning tree of its loops. Shortest first.
/// Cost: O(#E log #E).
EdgeWays arcsBetweenRims(const SurfaceLinks& links, const std::vector<double>& weights) {
    std::vector<int> rim;
    for (int use = 0; use < 3 * links.faceCount(); ++use) {
        if (links.twin(use) < 0) {
            rim.push_back(links.tail(use));
        }
    }
    const geometry::ShortestForest forest =
        geometry::shortestForest(links.table().edges, links.vertexCount(), weights, {rim});
    EdgeWays arcs;
    for (const Candidate& c : leftOver(links, outside(links, forest, weights))) {
        arcs.push_back(pathOver(links, forest, c.edge));
    }
    return arcs;
}

/// For a closed mesh with handles: a graph of loops through a point, cut into paths between its
/// branchings. Tries a few points and takes the shortest graph. Cost: a few times the above.
EdgeWays loopsAroundHandles(const SurfaceLinks& links, const std::vector<double>& weights) {
    EdgeWays best;
    double least = std::numeric_limits<double>::infinity();
    std::vector<int> tried{links.mesh().F(0, 0)};
    for (int i = 0; i < kBasePointsTried; ++i) {
        const geometry::ShortestForest forest = geometry::shortestForest(
            links.table().edges, links.vertexCount(), weights, {{tried.back()}});
        double total = 0;
        EdgeSet graph;
        for (const Candidate& c : leftOver(links, outside(links, forest, weights))) {
            total += c.length;
            graph.add(pathOver(links, forest, c.edge));
        }
        if (total < least) {
            least = total;
            graph.prune();
            best = graph.takeApart();
        }
        std::vector<std::vector<int>> sources{tried};
        tried.push_back(farthest(
            geometry::shortestForest(links.table().edges, links.vertexCount(), weights, sources)));
    }
    return best;
}

/// For a closed mesh without handles: a short tree through its sharpest points (largest missing
/// angle around the vertex), or between its two ends if nothing is sharp, cut into paths between
/// branchings and ends ([Meh88]). Cost: O(#E log #E).
EdgeWays treeThroughPeaks(const SurfaceLinks& links, const std::vector<double>& weights) {
    std::vector<std::vector<int>> sources;
    for (const int v : peaks(links, weights)) {
        sources.push_back({v});
    }
    const geometry::ShortestForest forest =
        geometry::shortestForest(links.table().edges, links.vertexCount(), weights, sources);
    geometry::DisjointSets joined(static_cast<int>(sources.size()));
    EdgeSet tree;
    for (const Candidate& c : outside(links, forest, weights)) {
        const auto ends = links.table().edges.row(c.edge);
        const int a = forest.source[ends[0]];
        const int b = forest.source[ends[1]];
        if (joined.root(a) != joined.root(b)) {
            joined.join(a, b);
            tree.add(pathOver(links, forest, c.edge));
        }
    }
    return tree.takeApart();
}

/// Along a fold of a right angle or more a seam counts as shorter than it is, by this factor.
constexpr double kCreaseDiscount = 0.6;
/// A fold from this angle on is a crease.
constexpr double kCrease = std::numbers::pi / 6;
/// Keeps cuts away from the rims of holes to be filled, and out of their caps.
constexpr double kKeepOff = 1e3;
/// Approximate shares of the time until the paths are found, and until they are tight.
constexpr double kGraphShare = 0.3;
constexpr double kTightShare = 0.6;

class Proposer {
public:
    Proposer(const MeshArrays& mesh, const EdgeTable& table, const AutoCutOptions& options,
             const Progress& progress)
        : mesh_(mesh), links_(mesh, table), options_(options), progress_(progress) {}

    Result<AutoCut> run(ErrorCode defect) {
        if (auto error = findLoops()) {
            return *error;
        }
        const MeshArrays filled = fillHoles(mesh_, proposal_.holesToFill);
        const EdgeTable table = buildEdgeTable(filled.F, static_cast<int>(filled.V.rows()));
        const SurfaceLinks links(filled, table);
        const std::vector<double> weights = weightsOf(links, defect == ErrorCode::ClosedSurface);
        EdgeWays ways;
        if (!openings_.empty()) {
            ways = arcsBetweenRims(links, weights);
        } else if (links.vertexCount() - links.edgeCount() + links.faceCount() == 2) {
            ways = treeThroughPeaks(links, weights);
        } else {
            ways = loopsAroundHandles(links, weights);
        }
        progress_.report(kGraphShare);
        std::vector<PathPolyline> tight;
        for (const auto& way : ways) {
            if (progress_.isCancelled()) {
                return Error{ErrorCode::Cancelled};
            }
            const PathPolyline path = polylineOf(links_, way);
            proposal_.cuts.push_back(path);
            tight.push_back(openings_.empty() && followsCrease(way)
                                ? path
                                : shortenedCut(links_, openings_, path));
        }
        progress_.report(kTightShare);
        adopt(tight);
        if (const auto trouble = whatIsNoDisk()) {
            return *trouble;
        }
        return proposal_;
    }

private:
    /// Finds openings to join by seams, and holes to fill.
    std::optional<Error> findLoops() {
        SortedLoops loops = sortLoops(links_, options_.smallHole);
        openings_ = std::move(loops.openings);
        proposal_.holesToFill = std::move(loops.holes);
        if (static_cast<int>(openings_.size()) > options_.maxLoops) {
            return Error{ErrorCode::SeveralLoops,
                         {},
                         counted(static_cast<long long>(openings_.size()), "loop") +
                             "; automatic cutting handles at most " +
                             std::to_string(options_.maxLoops)};
        }
        isAtHole_.assign(mesh_.V.rows(), 0);
        for (const RimLoop& hole : proposal_.holesToFill) {
            for (const int v : hole.vertices) {
                isAtHole_[v] = 1;
            }
        }
        return std::nullopt;
    }

    std::vector<double> weightsOf(const SurfaceLinks& links, bool preferCreases) const {
        std::vector<double> weights = edgeLengths(links.mesh(), links.table().edges);
        for (int e = 0; e < links.edgeCount(); ++e) {
            const auto ends = links.table().edges.row(e);
            const bool inCap = ends[1] >= links_.vertexCount();
            if (inCap || isAtHole_[ends[0]] != 0 || isAtHole_[ends[1]] != 0) {
                weights[e] *= inCap ? kKeepOff * kKeepOff : kKeepOff;
            }
            if (preferCreases) {
                const double sharpness = std::min(1.0, 2 * links.foldAngle(e) / std::numbers::pi);
                weights[e] *= 1 - kCreaseDiscount * sharpness;
            }
        }
        return weights;
    }

    /// Whether more than half of the path runs along creases.
    bool followsCrease(const std::vector<int>& way) const {
        double creased = 0;
        double whole = 0;
        for (std::size_t i = 1; i < way.size(); ++i) {
            const double length = (mesh_.V.row(way[i]) - mesh_.V.row(way[i - 1])).norm();
            whole += length;
            const int edge = findEdge(links_.table().edges, way[i - 1], way[i]);
            creased += links_.foldAngle(edge) > kCrease ? length : 0;
        }
        return 2 * creased > whole;
    }

    bool touchesHole(const PathPolyline& path) const {
        return std::ranges::any_of(path.points, [this](const SurfacePoint& point) {
            for (int k = 0; k < 3; ++k) {
                if (point.barycentric[k] > kOnEdge && isAtHole_[mesh_.F(point.face, k)] != 0 &&
                    links_.carrierOf(point).kind != Carrier::Kind::Face) {
                    return true;
                }
            }
            return false;
        });
    }

    /// Takes over the tightened cuts: all of them, or as many as leave one disk.
    void adopt(const std::vector<PathPolyline>& tight) {
        const std::vector<PathPolyline> safe = proposal_.cuts;
        const auto take = [&](std::size_t i) {
            if (!touchesHole(tight[i])) {
                proposal_.cuts[i] = tight[i];
            }
        };
        for (std::size_t i = 0; i < tight.size(); ++i) {
            take(i);
        }
        if (!whatIsNoDisk()) {
            return;
        }
        proposal_.cuts = safe;
        for (std::size_t i = 0; i < tight.size() && !progress_.isCancelled(); ++i) {
            take(i);
            if (whatIsNoDisk()) {
                proposal_.cuts[i] = safe[i];
            }
        }
    }

    /// Why the cuts do not leave one disk; badly shaped triangles are not a reason here.
    std::optional<Error> whatIsNoDisk() const {
        const auto cut = applyAutoCut(mesh_, proposal_, {}, progress_);
        if (!cut) {
            return cut.error();
        }
        const auto parts = faceComponents(cut->mesh.F, static_cast<int>(cut->mesh.V.rows()));
        if (*std::ranges::max_element(parts) > 0) {
            return cutError({}, toile::worded("the cuts would separate the piece"));
        }
        const auto defect = checkDisk(cut->mesh, "").defect;
        const bool isOnlyShape = defect && (defect->code == ErrorCode::DegenerateFace ||
                                            defect->code == ErrorCode::ZeroLengthEdge);
        return isOnlyShape ? std::nullopt : defect;
    }

    const MeshArrays& mesh_;
    const SurfaceLinks links_;
    const AutoCutOptions& options_;
    const Progress& progress_;
    std::vector<RimLoop> openings_;
    std::vector<char> isAtHole_;
    AutoCut proposal_;
};

}  // namespace

Result<AutoCut> proposeCuts(const MeshArrays& mesh, const EdgeTable& table,
                            const AutoCutOptions& options, const Progress& progress) {
    const auto defect = checkDisk(mesh, "").defect;
    if (!defect) {
        return AutoCut{};
    }
    if (defect->code != ErrorCode::ClosedSurface && defect->code != ErrorCode::SeveralLoops &&
        defect->code != ErrorCode::Handle) {
        return *defect;
    }
    const auto parts = faceComponents(mesh.F, static_cast<int>(mesh.V.rows()));
    if (*std::ranges::max_element(parts) > 0) {
        return cutError({}, toile::worded("the mesh has several parts"));
    }
    return Proposer(mesh, table, options, progress).run(defect->code);
}

Result<CutResult> applyAutoCut(const MeshArrays& mesh, const AutoCut& proposal,
                               const CutOptions& options, const Progress& progress) {
    auto result = cutAlong(fillHoles(mesh, proposal.holesToFill), proposal.cuts, options, progress);
    if (!result) {
        return result;
    }
    for (int& face : result->sourceFace) {
        face = face < mesh.F.rows() ? face : -1;
    }
    for (int& vertex : result->sourceVertex) {
        vertex = vertex < mesh.V.rows() ? vertex : -1;
    }
    for (SurfacePoint& place : result->place) {
        if (place.face >= mesh.F.rows()) {
            place = {};
        }
    }
    return result;
}

}  // namespace toile
