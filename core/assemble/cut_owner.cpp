// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/assemble/cut_owner.h"

#include <limits>

#include <Eigen/Geometry>

namespace toile {
namespace {

/// Distance of a cut's points from a piece.
struct Distance {
    double sum = 0;
    double farthest = 0;
    std::size_t point = 0;  ///< the one farthest away
};

Distance distanceTo(const MeshArrays& mesh, const NearestSurface& surface, const UserCut& cut) {
    Distance distance;
    for (std::size_t i = 0; i < cut.points.size(); ++i) {
        const Eigen::Vector3d& point = cut.points[i];
        const double d = (positionOf(mesh, surface.find(point)) - point).stableNorm();
        distance.sum += d;
        if (d >= distance.farthest) {
            distance.farthest = d;
            distance.point = i;
        }
    }
    return distance;
}

/// The fault of a cut itself, before any piece is checked; empty if there is none.
Wording faultOf(const UserCut& cut) {
    if (cut.points.empty()) {
        return worded("it has no points");
    }
    for (const Eigen::Vector3d& point : cut.points) {
        if (!point.allFinite()) {
            return worded("a point is not finite");
        }
    }
    return {};
}

}  // namespace

CutOwners findCutOwners(const Pieces& pieces, const std::vector<UserCut>& cuts,
                        const Progress& progress) {
    CutOwners owners;
    owners.cutsOf.resize(pieces.size());
    if (cuts.empty()) {
        return owners;
    }
    std::vector<std::pair<Distance, std::size_t>> best(
        cuts.size(), {Distance{std::numeric_limits<double>::infinity()}, pieces.size()});
    Eigen::AlignedBox3d box;
    for (std::size_t p = 0; p < pieces.size() && !progress.isCancelled(); ++p) {
        const MeshArrays& mesh = pieces[p]->mesh;
        if (mesh.F.rows() == 0 || !mesh.V.allFinite()) {
            continue;  // an unchanged piece, reported by its defect
        }
        box.extend(mesh.V.colwise().minCoeff().transpose());
        box.extend(mesh.V.colwise().maxCoeff().transpose());
        const NearestSurface surface(mesh);
        for (std::size_t c = 0; c < cuts.size(); ++c) {
            if (faultOf(cuts[c]).empty()) {
                const Distance distance = distanceTo(mesh, surface, cuts[c]);
                if (distance.sum < best[c].first.sum) {
                    best[c] = {distance, p};
                }
            }
        }
    }
    const double limit = box.isEmpty() ? 0 : kFarFromSurface * box.diagonal().norm();
    for (std::size_t c = 0; c < cuts.size(); ++c) {
        const auto& [distance, piece] = best[c];
        if (const Wording fault = faultOf(cuts[c]); !fault.empty()) {
            owners.problems.push_back(cutError(subjectOf(cuts[c]), fault));
        } else if (piece == pieces.size()) {
            owners.problems.push_back(
                cutError(subjectOf(cuts[c]), worded("there is no piece to cut")));
        } else if (distance.farthest > limit) {
            owners.problems.push_back(cutError(
                subjectOf(cuts[c]), worded("its point %1 is %2 mm from the nearest piece, %3",
                                           {figure(distance.point + 1.0), figure(distance.farthest),
                                            pieces[piece]->name})));
        } else {
            owners.cutsOf[piece].push_back(cuts[c]);
        }
    }
    return owners;
}

}  // namespace toile
