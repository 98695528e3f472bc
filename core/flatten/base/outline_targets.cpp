// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/flatten/base/outline_targets.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include "core/base/text.h"
#include "core/flatten/base/flat_piece.h"
#include "core/garment/piece.h"
#include "core/geometry/line.h"
#include "core/quality/measures.h"
#include "core/quality/outline_crossings.h"
#include "core/quality/piece_quality.h"

namespace toile {
namespace {

/// Length of each edge of the outline along the drawn line.
Eigen::VectorXd lengthsAlong(const FlatLine& drawn, const Piece& piece) {
    const auto line = geometry::Line::closed(drawn.points, drawn.arc);
    Eigen::VectorXd lengths = boundaryLengths3d(piece.mesh.V, piece.boundary);
    double at = 0;
    for (double& length : lengths) {
        const double from = at;
        at += length;
        length = line.lengthOf(from, at);
    }
    return lengths;
}

}  // namespace

Eigen::VectorXd outlineLengths(const Piece& piece, const OutlineTargets& targets) {
    return targets.lengths.size() > 0 ? targets.lengths
                                      : boundaryLengths3d(piece.mesh.V, piece.boundary);
}

std::optional<Error> faultOf(const Piece& piece, const OutlineTargets& targets) {
    for (const double length : targets.lengths) {
        if (!(length > 0 && std::isfinite(length))) {
            return Error{
                ErrorCode::NotFinite, subjectOf(piece),
                worded("an outline edge has a target length of %1 mm", {shortest(length)})};
        }
    }
    return std::nullopt;
}

void measureOutline(const Piece& piece, const FlatPiece& flat, const OutlineTargets& targets,
                    PieceQuality& quality) {
    if (!flat.line && targets.lengths.size() == 0) {
        return;
    }
    const Eigen::VectorXd wanted = outlineLengths(piece, targets);
    const Eigen::VectorXd lengths =
        flat.line ? lengthsAlong(*flat.line, piece) : boundaryLengths2d(flat.Q, piece.boundary);
    quality.perimeter2d = lengths.sum();
    quality.piL = piL(wanted, lengths);
    quality.maxBoundaryLengthError =
        maxRelativeLengthError(boundaryLengths3d(piece.mesh.V, piece.boundary), lengths);
    quality.maxTargetLengthError = maxRelativeLengthError(wanted, lengths);
    if (flat.line) {
        std::vector<int> loop(static_cast<std::size_t>(flat.line->points.rows()));
        std::iota(loop.begin(), loop.end(), 0);
        quality.outlineCrossings =
            std::max(quality.outlineCrossings, outlineCrossings(flat.line->points, loop));
    }
}

}  // namespace toile
