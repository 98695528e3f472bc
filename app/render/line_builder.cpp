// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/render/line_builder.h"

#include "core/quality/reference_fit.h"
#include "core/seam/seam_measure.h"

namespace toile {

namespace {

const FlatPiece* flatPiece(const PieceResults& results, int piece) {
    const auto at = static_cast<std::size_t>(piece);
    return at < results.size() && results[at]->flat ? &*results[at]->flat : nullptr;
}

template <class Vertex>
VertexRun runSince(std::size_t first, const LineBuffers<Vertex>& lines) {
    return {static_cast<std::uint32_t>(first),
            static_cast<std::uint32_t>(lines.vertices.size() - first)};
}

VertexRun addLine(LineBuffers<GarmentLineVertex>& lines, const Points3& points, int piece,
                  const Eigen::Vector3d& origin, Eigen::AlignedBox3d& box) {
    const std::size_t first = lines.vertices.size();
    for (Eigen::Index i = 0; i < points.rows(); ++i) {
        const Eigen::Vector3d point = points.row(i).transpose() - origin;
        const Eigen::Vector3f position = point.cast<float>();
        lines.vertices.push_back(
            {{position.x(), position.y(), position.z()}, static_cast<float>(piece)});
        box.extend(point);
    }
    return runSince(first, lines);
}

VertexRun addLine(LineBuffers<PatternLineVertex>& lines, const Points2& points, int piece) {
    const std::size_t first = lines.vertices.size();
    double along = 0;
    for (Eigen::Index i = 0; i < points.rows(); ++i) {
        along += i > 0 ? (points.row(i) - points.row(i - 1)).norm() : 0;
        lines.vertices.push_back(
            {{static_cast<float>(points(i, 0)), static_cast<float>(points(i, 1))},
             static_cast<float>(piece),
             static_cast<float>(along)});
    }
    return runSince(first, lines);
}

/// The points of a loop, the first once more at the end.
Points2 closedLine(const Points2& points, const std::vector<int>& loop) {
    const auto n = static_cast<Eigen::Index>(loop.size());
    Points2 line(n + 1, 2);
    for (Eigen::Index i = 0; i <= n; ++i) {
        line.row(i) = points.row(loop[static_cast<std::size_t>(i % n)]);
    }
    return line;
}

}  // namespace

void addSeamLines(const Garment& garment, const PieceResults& results, Scene& scene) {
    for (const Seam& seam : garment.seams.seams) {
        SeamScene& entry = scene.seams.emplace_back();
        auto& inSpace = scene.garmentLines.runs.seams.emplace_back();
        auto& inPattern = scene.patternLines.runs.seams.emplace_back();
        int which = 0;
        for (const SeamSide* side : {&seam.left, &seam.right}) {
            const int k = which++;
            if (side->piece < 0) {
                continue;
            }
            const auto at = static_cast<std::size_t>(side->piece);
            const Piece& piece = *garment.pieces[at];
            inSpace[k] = addLine(scene.garmentLines, spaceLine(*side, piece), side->piece,
                                 scene.origin, entry.box);
            if (const FlatPiece* flat = flatPiece(results, side->piece)) {
                const Points2 line = flatLine(*side, piece, flat->Q);
                inPattern[k] = addLine(scene.patternLines, line, side->piece);
                for (Eigen::Index i = 0; i < line.rows(); ++i) {
                    entry.flatBox.extend(
                        Eigen::Vector2d(line.row(i).transpose() + scene.pieces[at].offset));
                }
            }
        }
    }
}

void addDesignerLines(const Garment& garment, const PieceResults& results, Scene& scene) {
    for (int i = 0; i < static_cast<int>(garment.pieces.size()); ++i) {
        const Piece& piece = *garment.pieces[static_cast<std::size_t>(i)];
        const FlatPiece* flat = flatPiece(results, i);
        if (!flat || !piece.reference) {
            continue;
        }
        const Points2 placed = placedReference(flat->Q, *piece.reference);
        auto& lines = scene.patternLines;
        lines.runs.designer.push_back(addLine(lines, closedLine(placed, piece.boundary), i));
        for (const auto& hole : piece.holes) {
            lines.runs.designer.push_back(addLine(lines, closedLine(placed, hole), i));
        }
    }
}

}  // namespace toile
