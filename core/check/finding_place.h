// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/check/finding.h"
#include "core/garment/piece.h"

namespace toile {

/// Places of a flat piece, Q in mm. Cost: linear in the triangles (for the normal). Pure.

FindingPlace placeAtVertex(const Piece& piece, const Points2& Q, int vertex);
/// In its middle.
FindingPlace placeInTriangle(const Piece& piece, const Points2& Q, Eigen::Index face);
/// On the edge of the outline that starts at boundary[edge], where `flat` lies on it.
FindingPlace placeOnOutline(const Piece& piece, const Points2& Q, int edge,
                            const Eigen::RowVector2d& flat);

}  // namespace toile
