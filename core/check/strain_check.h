// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "core/garment/fabric.h"
#include "core/mesh/mesh_arrays.h"

namespace toile {

/// How far a flat piece goes beyond what a fabric allows along one direction.
struct StrainExcess {
    double share = 0;     ///< of the flat area that lies beyond, in [0, 1]
    int face = -1;        ///< the worst triangle, or -1 where nothing is strained
    double strain = 0;    ///< there: 0.02 = the cloth must stretch by 2 %
    double limit = 0;     ///< of that sign
    double severity = 0;  ///< strain / limit there: more than 1 is beyond
};

struct StrainExcesses {
    StrainExcess warp, weft, bias;
};

/// Each triangle by itself, as the window's colour bar and fabric panel count them. On the bias the
/// worse of both diagonals counts; a triangle that is turned over is beyond any limit.
/// @param Q      #V x 2, mm
/// @param grain  direction of the warp, radians from the x axis of Q
/// Cost: linear, the metric tensors. Pure.
StrainExcesses strainExcesses(const MeshArrays& mesh, const Points2& Q, const Fabric& fabric,
                              double grain);

}  // namespace toile
