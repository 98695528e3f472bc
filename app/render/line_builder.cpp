// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "app/document/reference.h"
#include "app/render/render_style.h"
#include "app/render/scene_builder.h"
#include "core/formats/tables/pattern_match.h"
#include "core/io/conventions.h"
#include "core/mesh/edge_table.h"
#include "core/pattern/darts.h"
#include "core/pattern/facings.h"
#include "core/pattern/internal_lines.h"
#include "core/pattern/notch_mark.h"
#include "core/pattern/pattern.h"
#include "core/quality/piece_quality.h"
#include "core/seam/seam_measure.h"

namespace toile::app {

namespace {

/// Properties shared by all vertices of a line.
struct LineKind {
    int piece;
    float tint;
};

/// @param flat   flat points; empty if the piece is not flat
/// @param space  relative to the scene's origin; empty if the line is drawn in the pattern only
VertexRun addLine(Scene& scene, const Points3& space, const Points2& flat, const LineKind& kind) {
    const std::size_t first = scene.lineVertices.size();
    double along = 0;
    for (Eigen::Index i = 0; i < std::max(space.rows(), flat.rows()); ++i) {
        LineVertex& vertex = scene.lineVertices.emplace_back();
        if (space.rows() > 0) {
            Eigen::Map<Eigen::RowVector3f>(vertex.position) = space.row(i).cast<float>();
        }
        if (flat.rows() > 0) {
            Eigen::Map<Eigen::RowVector2f>(vertex.flat) = flat.row(i).cast<float>();
            along += i > 0 ? (flat.row(i) - flat.row(i - 1)).norm() : 0;
        }
        vertex.piece = static_cast<float>(kind.piece);
        vertex.along = static_cast<float>(along);
        vertex.tint = kind.tint;
    }
    return {static_cast<std::uint32_t>(first),
            static_cast<std::uint32_t>(scene.lineVertices.size() - first)};
}

/// The points of a loop, with the first repeated at the end.
template <class Points>
Points closedLine(const Points& points, const std::vector<int>& loop) {
    const auto n = static_cast<Eigen::Index>(loop.size());
    Points line(n + 1, points.cols());
    for (Eigen::Index i = 0; i <= n; ++i) {
        line.row(i) = points.row(loop[static_cast<std::size_t>(i % n)]);
    }
    return line;
}

/// Indices of the boundary's vertices in a drawn outline, plus its last point.
/// @param worn  the outline in 3D, through all boundary vertices
std::vector<std::uint32_t> boundaryOn(const Points3& worn, const Piece& piece) {
    const Points3 vertices = closedLine<Points3>(piece.mesh.V, piece.boundary);
    std::vector<std::uint32_t> at{0};
    double arc = 0, along = 0;  // up to the vertex, and to the point
    Eigen::Index point = 0;
    for (Eigen::Index k = 1; k + 1 < vertices.rows(); ++k) {
        arc += (vertices.row(k) - vertices.row(k - 1)).norm();
        const auto step = [&] { return (worn.row(point + 1) - worn.row(point)).norm(); };
        while (point + 1 < worn.rows() && along + step() / 2 < arc) {
            along += step();
            ++point;
        }
        at.push_back(static_cast<std::uint32_t>(point));
    }
    at.push_back(static_cast<std::uint32_t>(worn.rows() - 1));
    return at;
}

/// Closes a circle by repeating its first point; leaves a stroke unchanged.
Points2 closedIfRound(Points2 line) {
    if (line.rows() > 2) {
        line.conservativeResize(line.rows() + 1, 2);
        line.row(line.rows() - 1) = line.row(0).eval();
    }
    return line;
}

/// Maps flat strokes around a point to the worn cloth, in the plane of its triangle.
Points3 onCloth(const MeshArrays& mesh, const SurfacePoint& point, const Points2& stroke) {
    const Eigen::RowVector3d p = mesh.V.row(mesh.F(point.face, 0)),
                             q = mesh.V.row(mesh.F(point.face, 1)),
                             r = mesh.V.row(mesh.F(point.face, 2));
    const Eigen::RowVector3d along = (q - p).normalized();
    const Eigen::RowVector3d across = ((q - p).cross(r - p)).cross(along).normalized();
    return (stroke.col(0) * along + stroke.col(1) * across).rowwise() +
           positionOf(mesh, point).transpose();
}

/// Adds a line or drill point in 3D and, if its piece is flat, in the pattern.
void addInternal(Scene& scene, const PieceInternal& internal, const MeshArrays& mesh,
                 const FlatPiece* flat, const LineKind& kind) {
    const auto add = [&](Points3 worn, const Points2& line) {
        worn.rowwise() -= scene.origin.transpose();
        const VertexRun run = addLine(scene, worn, line, kind);
        scene.garmentLines.internal.push_back(run);
        if (flat) {
            scene.patternLines.internal.push_back(run);
        }
    };
    const auto n = static_cast<Eigen::Index>(internal.way.size());
    Points3 worn(n, 3);
    Points2 line(flat ? n : 0, 2);
    for (Eigen::Index k = 0; k < n; ++k) {
        const SurfacePoint& point = internal.way[static_cast<std::size_t>(k)];
        worn.row(k) = positionOf(mesh, point).transpose();
        if (flat) {
            line.row(k) = flatPositionOf(flat->Q, mesh.F, point);
        }
    }
    if (n > 1) {
        add(std::move(worn), line);
        return;
    }
    PieceInternal aboutOrigin;
    aboutOrigin.points = Points2::Zero(1, 2);
    for (const Points2& drawn : drawnLines(aboutOrigin)) {
        const Points2 stroke = closedIfRound(drawn);
        add(onCloth(mesh, internal.way.front(), stroke),
            flat ? Points2(stroke.rowwise() + line.row(0)) : Points2());
    }
}

}  // namespace

void addSeamLines(const Garment& garment, const PieceResults& results, Scene& scene) {
    const std::vector<int> colours = seamColours(garment.seams);
    for (std::size_t s = 0; s < garment.seams.seams.size(); ++s) {
        const Seam& seam = garment.seams.seams[s];
        const float tint = colours[s] < 0 ? kFreeEdgeTint : static_cast<float>(colours[s]);
        SeamScene& entry = scene.seams.emplace_back();
        auto& inSpace = scene.garmentLines.seams.emplace_back();
        auto& inPattern = scene.patternLines.seams.emplace_back();
        std::size_t which = 0;
        for (const SeamSide* side : {&seam.left, &seam.right}) {
            const std::size_t k = which++;
            if (side->piece < 0) {
                continue;
            }
            const auto at = static_cast<std::size_t>(side->piece);
            const Piece& piece = *garment.pieces[at];
            entry.sides[k].piece = side->piece;
            const FlatPiece* flat = flatPieceOf(garment, results, side->piece);
            auto [worn, line] = flat ? stretchLines(*side, piece, *flat)
                                     : StretchLines{spaceLine(*side, piece), Points2()};
            worn.rowwise() -= scene.origin.transpose();
            inSpace[k] = addLine(scene, worn, line, {side->piece, tint});
            for (Eigen::Index i = 0; i < worn.rows(); ++i) {
                entry.box.extend(Eigen::Vector3d(worn.row(i).transpose()));
            }
            if (flat) {
                inPattern[k] = inSpace[k];
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
        VertexRun& inSpace = scene.garmentLines.outlines.emplace_back();
        VertexRun& inPattern = scene.patternLines.outlines.emplace_back();
        auto& boundaryAt = scene.garmentLines.boundaryAt.emplace_back();
        if (piece.boundary.empty()) {
            continue;
        }
        const FlatPiece* flat = flatPieceOf(garment, results, i);
        auto [worn, line] =
            flat && flat->line
                ? stretchLines(wholeOutline(piece, i), piece, *flat)
                : StretchLines{closedLine<Points3>(piece.mesh.V, piece.boundary),
                               flat ? closedLine<Points2>(flat->Q, piece.boundary) : Points2()};
        if (flat && flat->line) {
            boundaryAt = boundaryOn(worn, piece);
        }
        worn.rowwise() -= scene.origin.transpose();
        inSpace = addLine(scene, worn, line, {i, kNoTint});
        inPattern = flat ? inSpace : VertexRun{};
    }
    scene.patternLines.boundaryAt = scene.garmentLines.boundaryAt;
}

void addExactOutlines(const Garment& garment, const PieceResults& results, Scene& scene) {
    for (int i = 0; i < static_cast<int>(garment.pieces.size()); ++i) {
        const FlatPiece* flat = flatPieceOf(garment, results, i);
        const PieceResult* result = flat ? results[static_cast<std::size_t>(i)].get() : nullptr;
        if (result && result->exact && result->exact->flat && flat->line) {
            const Piece& piece = *garment.pieces[static_cast<std::size_t>(i)];
            scene.patternLines.exact.push_back(
                addLine(scene, Points3(),
                        closedLine<Points2>(result->exact->flat->Q, piece.boundary), {i, kNoTint}));
        }
    }
}

void addCuttingLines(const Pattern& pattern, Scene& scene) {
    for (std::size_t i = 0; i < pattern.pieces.size(); ++i) {
        const PatternPiece& piece = pattern.pieces[i];
        const LineKind kind{static_cast<int>(i), kNoTint};
        if (const Points2& line = piece.cuttingLine; line.rows() > 0) {
            Points2 closed(line.rows() + 1, 2);
            closed << line, line.row(0);
            scene.patternLines.cutting.push_back(addLine(scene, Points3(), closed, kind));
            for (Eigen::Index k = 0; k < line.rows(); ++k) {
                scene.edgeBoxes[i].extend(Eigen::Vector2d(line.row(k).transpose()));
            }
        }
        for (const std::vector<Points2>& strokes : notchMarks(pattern, piece)) {
            for (const Points2& stroke : strokes) {
                scene.patternLines.notches.push_back(addLine(scene, Points3(), stroke, kind));
            }
        }
    }
}

void addInternalLines(const Garment& garment, const PieceResults& results, const Pattern& pattern,
                      Scene& scene) {
    for (int i = 0; i < static_cast<int>(pattern.pieces.size()); ++i) {
        const PatternPiece& piece = pattern.pieces[static_cast<std::size_t>(i)];
        const LineKind kind{i, kNoTint};
        for (const PieceInternal& internal : piece.internals) {
            addInternal(scene, internal, garment.pieces[static_cast<std::size_t>(i)]->mesh,
                        flatPieceOf(garment, results, i), kind);
        }
        for (const PieceDart& dart : piece.darts) {
            const DartMarks marks = dartMarks(dart);
            for (const Points2& line : {marks.fold, marks.drill, marks.cross[0], marks.cross[1]}) {
                if (line.rows() > 0) {
                    scene.patternLines.internal.push_back(
                        addLine(scene, Points3(), closedIfRound(line), kind));
                }
            }
        }
        for (const Points2& edge : piece.extensions) {
            scene.patternLines.internal.push_back(addLine(scene, Points3(), edge, kind));
        }
    }
    for (const FacingPiece& facing : pattern.facings) {
        if (facing.strip.outline.rows() > 0) {
            scene.patternLines.internal.push_back(
                addLine(scene, Points3(), innerEdge(facing.strip), {facing.piece, kNoTint}));
        }
    }
}

void addLeftOut(const Garment& garment, Scene& scene) {
    constexpr Eigen::Index kMaxEdges = 50'000;  // more would look like a grey surface
    const int none = static_cast<int>(garment.pieces.size());
    for (const auto& file : garment.files) {
        const MeshArrays& mesh = file->reading.leftOut;
        const EdgeTable table = buildEdgeTable(mesh.F, static_cast<int>(mesh.V.rows()));
        const Eigen::Index step = 1 + table.edges.rows() / kMaxEdges;
        for (Eigen::Index e = 0; e < table.edges.rows(); e += step) {
            Points3 edge(2, 3);
            for (Eigen::Index k = 0; k < 2; ++k) {
                edge.row(k) =
                    withYUp(file->up, mesh.V.row(table.edges(e, k))) - scene.origin.transpose();
            }
            scene.garmentLines.leftOut.push_back(addLine(scene, edge, Points2(), {none, kNoTint}));
        }
    }
}

void addReferenceLines(const Garment& garment, const PieceResults& results, Scene& scene) {
    for (int i = 0; i < static_cast<int>(garment.pieces.size()); ++i) {
        const Piece& piece = *garment.pieces[static_cast<std::size_t>(i)];
        const FlatPiece* flat = flatPieceOf(garment, results, i);
        if (!flat || !piece.reference) {
            continue;
        }
        const Points2 placed = placedReference(flat->Q, *piece.reference);
        const auto add = [&](const std::vector<int>& loop) {
            scene.patternLines.reference.push_back(
                addLine(scene, Points3(), closedLine(placed, loop), {i, kNoTint}));
        };
        add(piece.boundary);
        std::ranges::for_each(piece.holes, add);
    }
}

ReferenceLines referenceLines(const PatternMatch& match) {
    ReferenceLines lines;
    for (const PieceMatch& pair : match.pairs) {
        if (!isSure(pair)) {
            continue;
        }
        const Points2& laid = pair.lines.front().fit.laid;
        const auto first = static_cast<std::uint32_t>(lines.vertices.size());
        double along = 0;
        for (Eigen::Index k = 0; k <= laid.rows(); ++k) {
            const Eigen::RowVector2d point = laid.row(k % laid.rows());
            along += k > 0 ? (point - laid.row(k - 1)).norm() : 0;
            LineVertex& vertex = lines.vertices.emplace_back();
            Eigen::Map<Eigen::RowVector2f>(vertex.flat) = point.cast<float>();
            vertex.piece = static_cast<float>(pair.piece);
            vertex.along = static_cast<float>(along);
            vertex.tint = kNoTint;
        }
        lines.runs.reference.push_back(
            {first, static_cast<std::uint32_t>(lines.vertices.size()) - first});
    }
    return lines;
}

}  // namespace toile::app
