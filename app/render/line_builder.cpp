// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/render/render_style.h"
#include "app/render/scene_builder.h"
#include "core/quality/piece_quality.h"
#include "core/seam/seam_measure.h"

namespace toile::app {

namespace {

template <class Vertex>
VertexRun runSince(std::size_t first, const LineBuffers<Vertex>& lines) {
    return {static_cast<std::uint32_t>(first),
            static_cast<std::uint32_t>(lines.vertices.size() - first)};
}

/// What all vertices of a line have in common.
struct LineKind {
    int piece;
    float tint;
};

/// @param flat  the same points where the piece lies flat; may be empty
VertexRun addLine(LineBuffers<GarmentLineVertex>& lines, const Points3& points, const Points2& flat,
                  const LineKind& kind, const Eigen::Vector3d& origin, Eigen::AlignedBox3d* box) {
    const std::size_t first = lines.vertices.size();
    const bool isFlat = flat.rows() == points.rows();
    for (Eigen::Index i = 0; i < points.rows(); ++i) {
        const Eigen::Vector3d point = points.row(i).transpose() - origin;
        GarmentLineVertex& vertex = lines.vertices.emplace_back();
        Eigen::Map<Eigen::Vector3f>(vertex.position) = point.cast<float>();
        if (isFlat) {
            Eigen::Map<Eigen::RowVector2f>(vertex.flat) = flat.row(i).cast<float>();
        }
        vertex.piece = static_cast<float>(kind.piece);
        vertex.tint = kind.tint;
        if (box) {
            box->extend(point);
        }
    }
    return runSince(first, lines);
}

VertexRun addLine(LineBuffers<PatternLineVertex>& lines, const Points2& points,
                  const LineKind& kind) {
    const std::size_t first = lines.vertices.size();
    double along = 0;
    for (Eigen::Index i = 0; i < points.rows(); ++i) {
        along += i > 0 ? (points.row(i) - points.row(i - 1)).norm() : 0;
        lines.vertices.push_back(
            {{static_cast<float>(points(i, 0)), static_cast<float>(points(i, 1))},
             static_cast<float>(kind.piece),
             static_cast<float>(along),
             kind.tint});
    }
    return runSince(first, lines);
}

/// The points of a loop, the first once more at the end.
template <class Points>
Points closedLine(const Points& points, const std::vector<int>& loop) {
    const auto n = static_cast<Eigen::Index>(loop.size());
    Points line(n + 1, points.cols());
    for (Eigen::Index i = 0; i <= n; ++i) {
        line.row(i) = points.row(loop[static_cast<std::size_t>(i % n)]);
    }
    return line;
}

}  // namespace

void addSeamLines(const Garment& garment, const PieceResults& results, Scene& scene) {
    const std::vector<int> colours = seamColours(garment.seams);
    for (std::size_t s = 0; s < garment.seams.seams.size(); ++s) {
        const Seam& seam = garment.seams.seams[s];
        const float tint = colours[s] < 0 ? kFreeEdgeTint : static_cast<float>(colours[s]);
        SeamScene& entry = scene.seams.emplace_back();
        auto& inSpace = scene.garmentLines.runs.seams.emplace_back();
        auto& inPattern = scene.patternLines.runs.seams.emplace_back();
        std::size_t which = 0;
        for (const SeamSide* side : {&seam.left, &seam.right}) {
            const std::size_t k = which++;
            if (side->piece < 0) {
                continue;
            }
            const auto at = static_cast<std::size_t>(side->piece);
            const Piece& piece = *garment.pieces[at];
            const LineKind kind{side->piece, tint};
            entry.sides[k].piece = side->piece;
            const FlatPiece* flat = flatPieceOf(garment, results, side->piece);
            const Points2 line = flat ? flatLine(*side, piece, flat->Q) : Points2();
            inSpace[k] = addLine(scene.garmentLines, spaceLine(*side, piece), line, kind,
                                 scene.origin, &entry.box);
            if (flat) {
                inPattern[k] = addLine(scene.patternLines, line, kind);
                for (Eigen::Index i = 0; i < line.rows(); ++i) {
                    entry.sides[k].flatBox.extend(Eigen::Vector2d(line.row(i).transpose()));
                }
            }
        }
    }
}

void addOutlines(const Garment& garment, const PieceResults& results, Scene& scene) {
    for (int i = 0; i < static_cast<int>(garment.pieces.size()); ++i) {
        const Piece& piece = *garment.pieces[static_cast<std::size_t>(i)];
        auto& inSpace = scene.garmentLines.runs.outlines.emplace_back();
        auto& inPattern = scene.patternLines.runs.outlines.emplace_back();
        if (piece.boundary.empty()) {
            continue;
        }
        const FlatPiece* flat = flatPieceOf(garment, results, i);
        const Points2 line = flat ? closedLine<Points2>(flat->Q, piece.boundary) : Points2();
        const LineKind kind{i, kNoTint};
        inSpace = addLine(scene.garmentLines, closedLine<Points3>(piece.mesh.V, piece.boundary),
                          line, kind, scene.origin, nullptr);
        if (flat) {
            inPattern = addLine(scene.patternLines, line, kind);
        }
    }
}

void addDesignerLines(const Garment& garment, const PieceResults& results, Scene& scene) {
    for (int i = 0; i < static_cast<int>(garment.pieces.size()); ++i) {
        const Piece& piece = *garment.pieces[static_cast<std::size_t>(i)];
        const FlatPiece* flat = flatPieceOf(garment, results, i);
        if (!flat || !piece.reference) {
            continue;
        }
        const Points2 placed = placedReference(flat->Q, *piece.reference);
        auto& lines = scene.patternLines;
        lines.runs.designer.push_back(
            addLine(lines, closedLine(placed, piece.boundary), {i, kNoTint}));
        for (const auto& hole : piece.holes) {
            lines.runs.designer.push_back(addLine(lines, closedLine(placed, hole), {i, kNoTint}));
        }
    }
}

}  // namespace toile::app
