// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/seam/seam_origin.h"

#include <algorithm>

#include "core/mesh/segment.h"
#include "core/seam/seam_measure.h"

namespace toile {
namespace {

/// A point of a cut lies on the outline but for rounding: this part of the edge's length.
constexpr double kOnLine = 1e-6;

/// Points that tell one seam from every other, and which way round a closed one goes.
constexpr int kJoinPoints = 9;

bool liesOnEdge(const Eigen::RowVector3d& point, const Eigen::RowVector3d& a,
                const Eigen::RowVector3d& b) {
    const double length = (b - a).norm();
    return length > 0 && distanceToSegment(point, a, b) <= kOnLine * length;
}

bool runsThrough(const SeamSide& side, const Piece& piece, const Eigen::RowVector3d& point) {
    const std::vector<int>& loop = loopOf(side, piece);
    const int n = static_cast<int>(loop.size());
    for (int k = side.first; k < side.first + side.count; ++k) {
        if (liesOnEdge(point, piece.mesh.V.row(loop[k % n]), piece.mesh.V.row(loop[(k + 1) % n]))) {
            return true;
        }
    }
    return false;
}

}  // namespace

bool isLeftBy(const Seam& seam, const MadeCut& cut,
              const std::vector<std::shared_ptr<const Piece>>& pieces) {
    return seam.kind != SeamKind::Free &&
           std::ranges::any_of(cut.middles, [&](const Eigen::Vector3d& point) {
               return runsThrough(seam.left, *pieces[seam.left.piece], point.transpose());
           });
}

UserJoin joinAlong(const Seam& seam, const std::vector<std::shared_ptr<const Piece>>& pieces) {
    const Points3 line = spaceLine(seam.left, *pieces[seam.left.piece]);
    std::vector<double> arc{0};
    for (Eigen::Index i = 1; i < line.rows(); ++i) {
        arc.push_back(arc.back() + (line.row(i) - line.row(i - 1)).norm());
    }
    UserJoin join{seam.name, {}};
    Eigen::Index last = -1;
    for (int k = 0; k < kJoinPoints; ++k) {
        // The ends exactly, between them the vertices next to even places.
        const auto at = std::ranges::lower_bound(arc, arc.back() * k / (kJoinPoints - 1.0));
        Eigen::Index i = std::min<Eigen::Index>(at - arc.begin(), line.rows() - 1);
        i = k == kJoinPoints - 1 ? line.rows() - 1 : i;
        if (i != last) {
            join.points.emplace_back(line.row(i).transpose());
            last = i;
        }
    }
    return join;
}

}  // namespace toile
