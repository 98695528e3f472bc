// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/seam/seam_origin.h"

#include <algorithm>

#include "core/mesh/segment.h"
#include "core/seam/seam_measure.h"

namespace toile {
namespace {

/// Points that tell one seam from every other, and which way round a closed one goes.
constexpr int kJoinPoints = 9;

bool liesOnEdge(const Eigen::RowVector3d& point, const Eigen::RowVector3d& a,
                const Eigen::RowVector3d& b) {
    const double length = (b - a).norm();
    return length > 0 && distanceToSegment(point, a, b) <= kOnLine * length;
}

}  // namespace

bool runsThrough(const Seam& seam, const Piece& piece, const Eigen::Vector3d& point) {
    const std::vector<int>& loop = loopOf(seam.left, piece);
    const int n = static_cast<int>(loop.size());
    for (int k = seam.left.first;
         seam.kind != SeamKind::Free && k < seam.left.first + seam.left.count; ++k) {
        if (liesOnEdge(point.transpose(), piece.mesh.V.row(loop[k % n]),
                       piece.mesh.V.row(loop[(k + 1) % n]))) {
            return true;
        }
    }
    return false;
}

bool isLeftBy(const Seam& seam, const MadeCut& cut,
              const std::vector<std::shared_ptr<const Piece>>& pieces) {
    return std::ranges::any_of(cut.middles, [&](const Eigen::Vector3d& point) {
        return runsThrough(seam, *pieces[seam.left.piece], point);
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
