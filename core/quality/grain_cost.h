// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/garment/fabric.h"
#include "core/mesh/mesh_arrays.h"

namespace toile {

/// Cost of a warp direction for the worn cloth: the squared excess of the strain along warp, weft
/// and bias over the fabric's limits, plus a thousandth of the squared strain itself, with more
/// weight along stiff directions. Mean over the worn area, dimensionless; 0 without any area.
/// @param Q  #V x 2, the unit of the mesh  @param angle  of the warp, radians from the x axis of Q
/// Cost: linear in the triangles, 15 ms for a million. Pure, thread-safe.
double grainCost(const MeshArrays& mesh, const Points2& Q, const Fabric& fabric, double angle);

/// Areas of flat cloth, mm2.
struct StrainedArea {
    double all = 0;
    double beyond = 0;  ///< strained beyond the fabric along warp, weft or bias

    double share() const { return all > 0 ? beyond / all : 0; }
};

/// Area of a piece that exceeds its fabric's limits, counted triangle by triangle, as in the
/// window's list of problems and fabric panel. Without a stated fabric nothing exceeds limits.
/// @param angle  as for grainCost
/// Cost: linear in the triangles. Pure, thread-safe.
StrainedArea strainedArea(const MeshArrays& mesh, const Points2& Q, const Fabric& fabric,
                          double angle);

}  // namespace toile
