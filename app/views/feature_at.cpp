// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/views/feature_at.h"

#include <QLineF>
#include <algorithm>
#include <array>

#include "app/document/document.h"
#include "app/render/piece_values.h"
#include "app/render/scene.h"
#include "app/views/sewn_run.h"
#include "app/views/tool.h"

namespace toile::app {

namespace {

/// Distance from the pointer within which a line or vertex is hit, pixels.
constexpr double kLineRadius = 6, kVertexRadius = 7;
/// Vertices of triangles smaller than this on the screen cannot be hit, pixels.
constexpr double kMinEdge = 26;

std::optional<Feature> vertexAt(const ToolView& view, const Document& document,
                                const SurfaceHit& hit, const QPointF& at) {
    std::array<QPointF, 3> corners;
    for (int k = 0; k < 3; ++k) {
        const auto place = view.onScreen(hit.piece, hit.face, Eigen::Vector3d::Unit(k));
        if (!place) {
            return std::nullopt;
        }
        corners[static_cast<std::size_t>(k)] = *place;
    }
    int nearest = 0;
    double distance = kVertexRadius;
    bool found = false;
    for (int k = 0; k < 3; ++k) {
        const auto i = static_cast<std::size_t>(k);
        if (QLineF(corners[i], corners[(i + 1) % 3]).length() < kMinEdge) {
            return std::nullopt;
        }
        if (const double off = QLineF(corners[i], at).length(); off <= distance) {
            nearest = k;
            distance = off;
            found = true;
        }
    }
    if (!found) {
        return std::nullopt;
    }
    const Piece& piece = *document.garment()->pieces[static_cast<std::size_t>(hit.piece)];
    return Feature{.kind = Feature::Kind::Vertex,
                   .piece = hit.piece,
                   .vertex = piece.mesh.F(hit.face, nearest),
                   .face = hit.face};
}

/// The boundary edge under a seam's line, whose points can differ from those of the boundary.
int edgeUnder(const SeamHit& hit, const SeamSide& side, const Scene& scene, const Piece& piece) {
    const VertexRun run =
        scene.garmentLines
            .seams[static_cast<std::size_t>(hit.seam)][static_cast<std::size_t>(hit.side)];
    double along = 0;  // up to the middle of the segment that was hit
    for (std::uint32_t k = 0; k + 1 < run.count && static_cast<int>(k) <= hit.segment; ++k) {
        const LineVertex* point = &scene.lineVertices[run.first + k];
        const double length = (wornPoint(point[1]) - wornPoint(point[0])).norm();
        along += static_cast<int>(k) < hit.segment ? length : length / 2;
    }
    const double at = side.reversed ? side.start - along : side.start + along;
    const auto size = static_cast<int>(piece.boundary.size());
    const auto lengthOf = [&](int k) -> double {
        const auto tail = static_cast<std::size_t>(k % size);
        const auto head = static_cast<std::size_t>((k + 1) % size);
        return (piece.mesh.V.row(piece.boundary[head]) - piece.mesh.V.row(piece.boundary[tail]))
            .norm();
    };
    double end = 0;
    for (int k = 0; k <= side.first; ++k) {
        end += lengthOf(k);
    }
    int edge = side.first;
    while (edge + 1 < side.first + side.count && end < at) {
        end += lengthOf(++edge);
    }
    return edge;
}

}  // namespace

std::optional<Feature> featureAt(const ToolView& view, const Document& document,
                                 const QPointF& at) {
    // For a moment, the scene may belong to the previous garment.
    if (!document.garment() || !document.scene() ||
        static_cast<int>(document.scene()->pieces.size()) != document.pieceCount()) {
        return std::nullopt;
    }
    const auto hit = view.hitAt(at);
    if (hit) {
        if (auto vertex = vertexAt(view, document, *hit, at)) {
            return vertex;
        }
    }
    if (const auto seam = view.seamHitAt(at, kLineRadius, {})) {
        return Feature{.kind = Feature::Kind::Seam, .seam = seam->seam};
    }
    return hit ? std::optional(Feature{.piece = hit->piece}) : std::nullopt;
}

std::optional<Feature> runAt(const ToolView& view, const Document& document, const QPointF& at) {
    const auto hit =
        document.garment() && document.scene() ? view.seamHitAt(at, kLineRadius, {}) : std::nullopt;
    if (!hit || hit->seam >= document.seamCount()) {
        return std::nullopt;
    }
    const Seam& seam = document.garment()->seams.seams[static_cast<std::size_t>(hit->seam)];
    const SeamSide& side = hit->side == 0 ? seam.left : seam.right;
    const auto piece = static_cast<std::size_t>(side.piece);
    // The edge of a hole has no corners.
    if (piece >= document.scene()->pieces.size() || side.count == 0 || side.loop > 0) {
        return std::nullopt;
    }
    const int size = static_cast<int>(document.garment()->pieces[piece]->boundary.size());
    const int edge = edgeUnder(*hit, side, *document.scene(), *document.garment()->pieces[piece]);
    const OutlineRun run =
        runBetweenCorners(document.scene()->pieces[piece].corners, size, edge % size);
    return Feature{
        .kind = Feature::Kind::Run, .piece = side.piece, .first = run.first, .count = run.count};
}

bool selectLineAt(const ToolView& view, Document& document, const QPointF& at) {
    const auto feature = featureAt(view, document, at);
    if (!feature || feature->kind == Feature::Kind::Piece) {
        return false;
    }
    if (feature->kind == Feature::Kind::Seam) {
        document.setSeam(feature->seam);
    } else {
        document.setMark(feature);
    }
    return true;
}

void selectPieceAt(const ToolView& view, Document& document, const Pointer& pointer) {
    const auto hit = view.hitAt(pointer.at);
    if (pointer.adds()) {
        if (hit) {
            document.toggleSelected(hit->piece);
        }
        return;
    }
    if (hit) {
        document.setSelection({hit->piece});
    } else {
        document.selectNothing();
    }
}

bool selectRunAt(const ToolView& view, Document& document, const QPointF& at) {
    const auto feature = featureAt(view, document, at);
    const bool onLine = feature && feature->kind == Feature::Kind::Seam;
    const auto run = onLine ? runAt(view, document, at) : std::nullopt;
    if (!run) {
        return false;
    }
    document.setMark(run, seamOfRun(*document.garment(), *run));
    return true;
}

}  // namespace toile::app
