// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/cut/auto_cut.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "core/base/text.h"
#include "core/cut/cut_graph.h"
#include "core/cut/straighten.h"
#include "core/cut/surface_paths.h"
#include "core/mesh/disk_check.h"

namespace toile {
namespace {

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
                             "; automatic cutting takes at most " +
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
