// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/views/tools/cloth_snapper.h"

#include <algorithm>
#include <cmath>

#include "app/render/piece_values.h"
#include "core/geometry/segment.h"

namespace toile::app {

namespace {

/// Snapping distances, pixels.
constexpr double kToOwn = 9, kToCorner = 10, kToVertex = 4, kToRim = 8;
/// A rim near the pointer on the screen, but farther from the cloth there than this many pixel
/// sizes, belongs to another layer.
constexpr double kSameLayer = 4;

double length(const QPointF& v) {
    return std::hypot(v.x(), v.y());
}

Eigen::Vector3d corner(int k) {
    return Eigen::Vector3d::Unit(k);
}

/// The best candidate so far: by snapping rank, then by distance.
struct Best {
    ClothPoint point;
    int rank = 0;
    double distance = 0;

    void offer(const ClothPoint& offered, int offeredRank, double offeredDistance) {
        if (offeredRank > rank || (offeredRank == rank && offeredDistance < distance)) {
            point = offered;
            rank = offeredRank;
            distance = offeredDistance;
        }
    }
};

void offerRim(const ToolView& view, const Piece& piece, int index, const PieceRim& rim,
              const QPointF& at, const std::optional<Eigen::Vector3d>& near, Best& best) {
    const double radius = kSameLayer * kToCorner / view.pixelsPerMillimetre();
    for (const int use : rim.uses) {
        const int face = use / 3, k = use % 3, next = (k + 1) % 3;
        const int tail = piece.mesh.F(face, k), head = piece.mesh.F(face, next);
        if (near) {
            const Eigen::Vector3d a = piece.mesh.V.row(tail), b = piece.mesh.V.row(head);
            if ((0.5 * (a + b) - *near).norm() > radius + 0.5 * (b - a).norm()) {
                continue;
            }
        }
        const auto a = view.onScreen(index, face, corner(k));
        const auto b = view.onScreen(index, face, corner(next));
        if (!a || !b) {
            continue;
        }
        const double toTail = length(at - *a);
        if (toTail <= kToCorner && rim.corners.contains(tail)) {
            best.offer({index, {face, corner(k)}, ClothPoint::On::Corner, -1}, 3, toTail);
        } else if (toTail <= kToVertex) {
            best.offer({index, {face, corner(k)}, ClothPoint::On::Rim, -1}, 2, toTail);
        }
        const double t = geometry::nearestShare(pixels(at), pixels(*a), pixels(*b));
        const double distance = length(*a + t * (*b - *a) - at);
        if (distance <= kToRim) {
            best.offer(
                {index, {face, (1 - t) * corner(k) + t * corner(next)}, ClothPoint::On::Rim, -1}, 1,
                distance);
        }
    }
}

}  // namespace

PieceRim rimOf(const Piece& piece) {
    PieceRim rim;
    rim.isOnRim.assign(static_cast<std::size_t>(piece.mesh.V.rows()), 0);
    std::map<int, int> leaving;  // edge use by tail vertex
    const EdgeTable& table = piece.table;
    for (std::size_t e = 0; e + 1 < table.useStart.size(); ++e) {
        if (table.useStart[e + 1] - table.useStart[e] == 1) {
            const int use = table.use[static_cast<std::size_t>(table.useStart[e])];
            rim.uses.push_back(use);
            leaving.emplace(piece.mesh.F(use / 3, use % 3), use);
        }
    }
    for (const int use : rim.uses) {
        const int tail = piece.mesh.F(use / 3, use % 3);
        const int head = piece.mesh.F(use / 3, (use % 3 + 1) % 3);
        rim.isOnRim[static_cast<std::size_t>(tail)] = rim.isOnRim[static_cast<std::size_t>(head)] =
            1;
        const auto next = leaving.find(head);
        if (!piece.boundary.empty() || next == leaving.end()) {
            continue;
        }
        const int beyond = piece.mesh.F(next->second / 3, (next->second % 3 + 1) % 3);
        const Eigen::RowVector3d before = piece.mesh.V.row(head) - piece.mesh.V.row(tail);
        const Eigen::RowVector3d after = piece.mesh.V.row(beyond) - piece.mesh.V.row(head);
        if (before.dot(after) < std::cos(kCornerTurn) * before.norm() * after.norm()) {
            rim.corners.insert(head);
        }
    }
    // For disks, use the same corners as a double click on the outline.
    for (const int place : outlineCorners(piece)) {
        rim.corners.insert(piece.boundary[static_cast<std::size_t>(place)]);
    }
    return rim;
}

const PieceRim& ClothSnapper::rim(const std::shared_ptr<const Piece>& piece) {
    auto found = rims_.find(piece);
    if (found == rims_.end()) {
        found = rims_.emplace(piece, rimOf(*piece)).first;
    }
    return found->second;
}

void ClothSnapper::keep(const Garment* garment) {
    std::erase_if(rims_, [garment](const auto& entry) {
        return !garment || std::ranges::find(garment->pieces, entry.first) == garment->pieces.end();
    });
}

std::optional<ClothPoint> ClothSnapper::find(const ToolView& view, const Garment& garment,
                                             const QPointF& at, std::span<const ClothPoint> own) {
    if (!view.answers()) {
        return std::nullopt;
    }
    for (std::size_t i = 0; i < own.size(); ++i) {
        const auto place = view.onScreen(own[i].piece, own[i].at.face, own[i].at.barycentric);
        if (place && length(*place - at) <= kToOwn) {
            ClothPoint point = own[i];
            point.on = ClothPoint::On::Own;
            point.own = static_cast<int>(i);
            return point;
        }
    }
    Best best;
    if (const auto hit = view.hitAt(at)) {
        const auto& piece = garment.pieces[static_cast<std::size_t>(hit->piece)];
        best.point = {hit->piece, {hit->face, hit->barycentric}, ClothPoint::On::Cloth, -1};
        offerRim(view, *piece, hit->piece, rim(piece), at, positionOf(piece->mesh, best.point.at),
                 best);
        return best.point;
    }
    // Testing every rim would cost all outlines at every pointer move.
    const auto line = view.seamHitAt(at, kToCorner, {});
    const Seam* seam = line && line->seam < static_cast<int>(garment.seams.seams.size())
                           ? &garment.seams.seams[static_cast<std::size_t>(line->seam)]
                           : nullptr;
    for (std::size_t i = 0; i < garment.pieces.size(); ++i) {
        const auto& piece = garment.pieces[i];
        const int index = static_cast<int>(i);
        const bool near = seam && (seam->left.piece == index || seam->right.piece == index);
        if (near || piece->boundary.empty()) {  // a piece that is not a disk has no seams
            offerRim(view, *piece, index, rim(piece), at, std::nullopt, best);
        }
    }
    return best.rank > 0 ? std::optional(best.point) : std::nullopt;
}

}  // namespace toile::app
