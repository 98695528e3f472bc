// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/flatten/interior/tutte.h"

#include <utility>

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
    auto system =
        InteriorSystem::make({piece.table.edges, Eigen::VectorXd::Ones(piece.table.edges.rows())},
                             static_cast<int>(piece.mesh.V.rows()), piece.boundary, progress);
    if (!system) {
        return system.error();
    }
    auto points = system->extend(*outline);
    if (!points) {
        return points.error();
    }
    return Points2(std::move(*points));
}

}  // namespace toile
