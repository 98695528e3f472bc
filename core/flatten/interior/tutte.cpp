// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/flatten/interior/tutte.h"

#include "core/flatten/boundary/circle_outline.h"
#include "core/flatten/interior/interior.h"
#include "core/garment/piece.h"
#include "core/quality/measures.h"

namespace toile {

Result<Points2> tutteOnCircle(const Piece& piece, const Progress& progress) {
    const auto outline = circleOutline(boundaryLengths3d(piece.mesh.V, piece.boundary));
    if (!outline) {
        return outline.error();
    }
    return fillInterior({piece.table.edges, Eigen::VectorXd::Ones(piece.table.edges.rows())},
                        piece.mesh.V, piece.boundary, *outline, progress);
}

}  // namespace toile
