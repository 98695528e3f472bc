// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/pattern/half_pattern.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <map>
#include <utility>

#include "core/geometry/line.h"
#include "core/geometry/polygon.h"
#include "core/geometry/segment.h"
#include "core/pattern/darts.h"
#include "core/pattern/drawn_outline.h"
#include "core/pattern/internal_lines.h"
#include "core/pattern/piece_allowance.h"

namespace toile {
namespace {

/// Shorter stretches are rounding, mm.
constexpr double kNothing = 1e-6;

/// The mirrored outline with which the piece was drawn; null if it was not mirrored.
const MirroredOutline* mirroredOf(const PieceResult* result) {
    const bool isDrawn = result && result->flat && result->flat->line && result->plan;
    return isDrawn && result->plan->mirrored && result->piece->holes.empty()
               ? &*result->plan->mirrored
               : nullptr;
}

/// True if the mirror line lies on the cloth, from row 0 to the row half-way around.
bool hasFold(const Points2& outline) {
    const Eigen::Index half = outline.rows() / 2;
    if (half < 2 || 2 * half != outline.rows()) {
        return false;
    }
    const Eigen::RowVector2d fold = outline.row(half) - outline.row(0);
    for (Eigen::Index k = 1; k < half; ++k) {
        if (!(geometry::cross(fold, outline.row(k) - outline.row(0)) < 0)) {
            return false;
        }
    }
    return true;
}

/// The parts of a stretch of outline on its first half, from 0 to `end`.
struct HalfPart {
    double from = 0, to = 0;                        ///< within the half
    bool startsAtFold = false, endsAtFold = false;  ///< cut off there
};

std::vector<HalfPart> partsOnHalf(double from, double to, double end) {
    std::vector<HalfPart> parts;
    for (const auto& part : geometry::commonParts({0, end}, {from, to}, 2 * end)) {
        if (part.length() > kNothing) {
            parts.push_back({part.low, part.high,
                             from + part.shift<-kNothing, to + part.shift> end + kNothing});
        }
    }
    return parts;
}

std::vector<SeamLine> halfSeams(const std::vector<SeamLine>& seams, const geometry::Line& outline,
                                double end) {
    std::vector<SeamLine> halves;
    for (const SeamLine& seam : seams) {
        for (const HalfPart& part : partsOnHalf(seam.from, seam.to, end)) {
            SeamLine& half = halves.emplace_back(seam);
            half.from = part.from;
            half.to = part.to;
            half.isAtFold = {part.startsAtFold, part.endsAtFold};
            if (part.startsAtFold || part.endsAtFold) {
                half.length3d *= (part.to - part.from) / (seam.to - seam.from);
                half.line = outline.part(part.from, part.to);
                half.closed = false;
            }
        }
    }
    return halves;
}

std::vector<PatternSegment> halfSegments(const std::vector<PatternSegment>& segments, double end,
                                         double fold) {
    std::vector<PatternSegment> halves;
    for (const PatternSegment& segment : segments) {
        for (const HalfPart& part : partsOnHalf(segment.from, segment.to, end)) {
            PatternSegment& half = halves.emplace_back(segment);
            half.from = part.from;
            half.to = part.to;
            half.length *= (part.to - part.from) / (segment.to - segment.from);
            half.isCorner |= part.from < kNothing;
        }
    }
    std::ranges::stable_sort(halves, {}, &PatternSegment::from);
    PatternSegment& edge = halves.emplace_back();
    edge.from = end;
    edge.to = end + fold;
    edge.length = fold;
    edge.isCorner = edge.isFold = true;
    return halves;
}

/// The part of a symmetric closed line to the left of the fold: an open line that starts and ends
/// on the fold.
Points2 upToFold(const Points2& line, const Chord& fold) {
    constexpr double kNoEdge = 1e-4;  // mm: rounding of points at the fold
    const std::vector<PieceInternal> parts = leftPart({.points = line, .closed = true}, fold);
    const auto longest = std::ranges::max_element(parts, {}, &PieceInternal::length);
    if (longest == parts.end()) {
        return Points2(0, 2);
    }
    Points2 half = longest->points;
    const Eigen::RowVector2d from = fold.from.transpose();
    const Eigen::RowVector2d along = (fold.to - fold.from).normalized().transpose();
    const auto onFold = [&](Eigen::Index k) -> Eigen::RowVector2d {
        return from + (half.row(k) - from).dot(along) * along;
    };
    const Eigen::Index n = half.rows();
    const Eigen::Index first = n > 3 && (half.row(1) - half.row(0)).norm() < kNoEdge ? 1 : 0;
    const Eigen::Index last =
        n > 3 && (half.row(n - 2) - half.row(n - 1)).norm() < kNoEdge ? n - 2 : n - 1;
    half.row(first) = onFold(first);
    half.row(last) = onFold(last);
    return half.middleRows(first, last - first + 1);
}

double edgeArea(const PatternPiece& piece) {
    return geometry::signedAreaOf(piece.cuttingLine);
}

/// Precondition: it is symmetric.
void halve(PatternPiece& piece) {
    const Eigen::Index half = piece.outline.rows() / 2;
    const auto outline = geometry::Line::closed(piece.outline);
    const double end = outline.length() / 2;
    const double fold = (piece.outline.row(half) - piece.outline.row(0)).norm();
    piece.seams = halfSeams(piece.seams, outline, end);
    piece.segments = halfSegments(piece.segments, end, fold);
    piece.outline = Points2(piece.outline.topRows(half + 1));
    for (PieceNotch& notch : piece.notches) {
        if (notch.hole < 0 && outline.apart(notch.at, 0) < kNothing) {
            notch.at = 0;  // rounded: where the fold starts
        }
    }
    std::erase_if(piece.notches, [end](const PieceNotch& notch) {
        return notch.hole < 0 && notch.at > end + kNothing;
    });
    const Chord chord = foldOf(piece);
    std::vector<PieceInternal> internals;
    for (const PieceInternal& internal : piece.internals) {
        std::ranges::move(leftPart(internal, chord), std::back_inserter(internals));
    }
    piece.internals = std::move(internals);
    if (piece.cuttingLine.rows() > 0) {
        piece.cuttingLine = upToFold(piece.cuttingLine, chord);
    }
    piece.extensions = leftParts(piece.extensions, chord);
    if (!piece.darts.empty()) {
        piece.darts = findDarts(piece);
    }
}

}  // namespace

std::vector<DrawnMirror> drawnMirrors(const PieceResults& results) {
    std::vector<DrawnMirror> mirrors(results.size());
    std::map<PieceId, int> leads;
    for (int p = 0; p < static_cast<int>(results.size()); ++p) {
        const MirroredOutline* mirrored = mirroredOf(results[p].get());
        if (mirrored && mirrored->isSymmetric) {
            mirrors[p].isSymmetric = hasFold(results[p]->flat->line->points);
        } else if (mirrored && !mirrored->isImage) {
            leads.emplace(mirrored->lead, p);
        }
    }
    for (int p = 0; p < static_cast<int>(results.size()); ++p) {
        const MirroredOutline* mirrored = mirroredOf(results[p].get());
        const auto lead = mirrored && mirrored->isImage ? leads.find(mirrored->lead) : leads.end();
        if (lead != leads.end()) {
            mirrors[p].counterpart = lead->second;
            mirrors[lead->second].counterpart = p;
            mirrors[lead->second].leads = true;
        }
    }
    return mirrors;
}

CutAs cutAs(const DrawnMirror& mirror, bool byHalf) {
    return !byHalf                  ? CutAs::Whole
           : mirror.isSymmetric     ? CutAs::OnFold
           : mirror.counterpart < 0 ? CutAs::Whole
           : mirror.leads           ? CutAs::Pair
                                    : CutAs::Image;
}

Pattern asCut(Pattern whole) {
    int number = 0;
    for (PatternPiece& piece : whole.pieces) {
        const int other = piece.mirror.counterpart;
        piece.cutAs =
            cutAs(piece.mirror, piece.byHalf || (other >= 0 && whole.pieces[other].byHalf));
        if (piece.cutAs == CutAs::OnFold) {
            halve(piece);
        } else if (piece.cutAs == CutAs::Image) {
            piece.outline.resize(0, 2);
            piece.seams.clear();
            piece.segments.clear();
            piece.darts.clear();
            piece.cuttingLine.resize(0, 2);
            piece.extensions.clear();
            piece.notches.clear();
            piece.internals.clear();
        }
        piece.number = piece.outline.rows() > 0 ? ++number : 0;
    }
    for (FacingPiece& facing : whole.facings) {
        const PatternPiece& piece = whole.pieces[facing.piece];
        setCutting(facing.strip, piece);
        Cutting& cutting = facing.strip;
        cutting.byHalf = false;
        if (piece.cutAs == CutAs::Pair || piece.cutAs == CutAs::Image) {
            // Each of the pair has a facing, with the quantity of the pair.
            const PatternPiece& drawn =
                piece.cutAs == CutAs::Pair ? piece : whole.pieces[piece.mirror.counterpart];
            cutting.quantity = drawn.quantity;
            cutting.material = drawn.material;
            cutting.mirroredPair = false;
        }
        facing.strip.number = facing.strip.outline.rows() > 0 ? ++number : 0;
        whole.pieces.push_back(std::exchange(facing.strip, {}));
    }
    return whole;
}

void dropUnequalMirrors(std::vector<PatternPiece>& pieces) {
    constexpr double kSameArea = 1e-5;  // of the area
    for (PatternPiece& piece : pieces) {
        if (piece.cuttingLine.rows() == 0) {
            continue;
        }
        const double area = edgeArea(piece);
        const auto isOf = [area](double other) { return std::abs(other / area - 1) < kSameArea; };
        const int other = piece.mirror.counterpart;
        if (piece.mirror.isSymmetric) {
            piece.mirror.isSymmetric =
                isOf(2 * geometry::signedAreaOf(upToFold(piece.cuttingLine, foldOf(piece))));
        } else if (other >= 0 && !isOf(edgeArea(pieces[other]))) {
            piece.mirror = pieces[other].mirror = {};
        }
    }
}

Chord foldOfEdge(const PatternPiece& piece) {
    const Points2& edge = edgeOf(piece);
    return {edge.row(edge.rows() - 1), edge.row(0)};
}

Chord foldOf(const PatternPiece& piece) {
    const Eigen::Index n = piece.outline.rows();
    const Eigen::Index end = piece.cutAs == CutAs::OnFold ? n - 1 : n / 2;
    return {piece.outline.row(end), piece.outline.row(0)};
}

}  // namespace toile
