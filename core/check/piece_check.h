// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "core/check/ready_to_cut.h"
#include "core/diagnose/finding.h"
#include "core/flatten/base/piece_result.h"
#include "core/garment/fabric.h"
#include "core/garment/piece.h"
#include "core/mesh/mesh_arrays.h"
#include "core/project/piece_settings.h"

namespace toile {

/// One piece of a garment, as it is to be cut.
struct PieceToCut {
    int index;  ///< in the garment
    const PieceResult& result;
    PieceSettings settings;  ///< without anchors
    const Fabric& fabric;    ///< that of its material
};

/// Shares of a piece's area beyond the fabric's limits along one direction. The first makes a
/// doubt. The second makes a fault if the user typed the limits; rules of thumb make none. Smaller
/// shares are single triangles.
inline constexpr double kStrainDoubtShare = 0.01, kStrainFaultShare = 0.05;

/// Checks the piece alone: flatness, outline, flips, strain, grain, and the notes of its
/// flattening. Cost: linear in the triangles, n log n in an outline that crosses itself. Pure.
void checkPiece(const PieceToCut& piece, FindingList& found);

/// Places of a flat piece, Q in mm. Cost: linear in the triangles (for the normal). Pure.

FindingPlace placeAtVertex(const Piece& piece, const Points2& Q, int vertex);
/// At the point `flat` on the outline edge that starts at boundary[edge].
FindingPlace placeOnOutline(const Piece& piece, const Points2& Q, int edge,
                            const Eigen::RowVector2d& flat);

/// How far a flat piece goes beyond what a fabric allows along one direction.
struct StrainExcess {
    double share = 0;     ///< of the flat area beyond the limit, in [0, 1]
    int face = -1;        ///< the worst triangle, or -1 if nothing is strained
    double strain = 0;    ///< there: 0.02 = the cloth must stretch by 2 %
    double limit = 0;     ///< for strain of that sign
    double severity = 0;  ///< strain / limit there: more than 1 is beyond the limit
};

struct StrainExcesses {
    StrainExcess warp, weft, bias;
};

/// Judges each triangle separately, like the window's colour bar and fabric panel. On the bias the
/// worse diagonal counts; a flipped triangle exceeds any limit.
/// @param Q      #V x 2, mm
/// @param grain  direction of the warp, radians from the x axis of Q
/// Cost: linear (metric tensors). Pure.
StrainExcesses strainExcesses(const MeshArrays& mesh, const Points2& Q, const Fabric& fabric,
                              double grain);

}  // namespace toile
