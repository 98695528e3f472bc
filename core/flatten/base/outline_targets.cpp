// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/flatten/base/outline_targets.h"

#include <cmath>

#include "core/base/text.h"
#include "core/garment/piece.h"
#include "core/quality/measures.h"

namespace toile {

Eigen::VectorXd outlineLengths(const Piece& piece, const OutlineTargets& targets) {
    return targets.lengths.size() > 0 ? targets.lengths
                                      : boundaryLengths3d(piece.mesh.V, piece.boundary);
}

std::optional<Error> faultOf(const Piece& piece, const OutlineTargets& targets) {
    for (const double length : targets.lengths) {
        if (!(length > 0 && std::isfinite(length))) {
            return Error{ErrorCode::NotFinite, subjectOf(piece),
                         worded("an edge of the outline is to have %1 mm", {shortest(length)})};
        }
    }
    return std::nullopt;
}

}  // namespace toile
