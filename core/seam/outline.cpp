// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/seam/outline.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <Eigen/Geometry>

#include "core/mesh/mesh_arrays.h"
#include "core/quality/measures.h"

namespace toile::seam {
namespace {

// Number of edges on either side over which the local edge length is averaged.
constexpr int kSpacingRadius = 2;

/// The corner opposite to edge (u, v) in its only triangle.
int oppositeVertex(const Piece& piece, int u, int v) {
    return apexOf(piece.mesh.F, piece.table.usesOf(findEdge(piece.table.edges, u, v))[0]);
}

Outline buildOutline(const Piece& piece, int index, int hole) {
    Outline outline;
    outline.piece = index;
    outline.loop = hole;
    const std::vector<int>& loop =
        hole == 0 ? piece.boundary : piece.holes[static_cast<std::size_t>(hole) - 1];
    const int n = static_cast<int>(loop.size());
    if (n == 0 || piece.defect) {
        return outline;
    }
    outline.vertices = loop;
    outline.line = geometry::SpaceLine::closed(piece.mesh.V(loop, Eigen::all));
    outline.inward.resize(n, 3);
    outline.spacing.resize(n);
    for (int k = 0; k < n; ++k) {
        const int u = loop[k], v = loop[(k + 1) % n];
        const Eigen::Vector3d along = outline.line.point(k + 1) - outline.line.point(k);
        const Eigen::Vector3d across =
            piece.mesh.V.row(oppositeVertex(piece, u, v)) - piece.mesh.V.row(u);
        outline.inward.row(k) =
            (across - along * (across.dot(along) / along.squaredNorm())).normalized();
    }
    for (int k = 0; k < n; ++k) {
        const double length =
            outline.arcOf(k + kSpacingRadius + 1) - outline.arcOf(k - kSpacingRadius);
        outline.spacing[k] = length / (2 * kSpacingRadius + 1);
    }
    outline.angle = boundaryAngles3d(piece.mesh, loop);
    return outline;
}

}  // namespace

double Outline::nearestVertex(double s) const {
    const auto [edge, share] = line.arc().edgePlace(s);
    return s - wrap(s) + line.arc()[share < 0.5 ? edge : edge + 1];
}

Outlines buildOutlines(const Pieces& pieces) {
    Outlines all;
    Eigen::AlignedBox3d box;
    all.firstEdge.push_back(0);
    const auto add = [&](Outline outline) {
        const auto index = static_cast<int>(all.list.size());
        all.firstEdge.push_back(all.firstEdge.back() + outline.size());
        all.outlineOf.insert(all.outlineOf.end(), outline.size(), index);
        all.list.push_back(std::move(outline));
    };
    const auto count = static_cast<int>(pieces.size());
    for (int p = 0; p < count; ++p) {
        add(buildOutline(*pieces[p], p, 0));
        const Outline& outline = all.list.back();
        for (int k = 0; k < outline.size(); ++k) {
            box.extend(Eigen::Vector3d(outline.line.point(k)));
        }
    }
    for (int p = 0; p < count; ++p) {
        all.firstHole.push_back(static_cast<int>(all.list.size()));
        for (int hole = 1; hole <= static_cast<int>(pieces[p]->holes.size()); ++hole) {
            add(buildOutline(*pieces[p], p, hole));
        }
    }
    all.size = box.isEmpty() ? 0 : box.diagonal().norm();
    return all;
}

}  // namespace toile::seam
