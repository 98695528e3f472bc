// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/garment/fabric.h"
#include "core/mesh/mesh_arrays.h"

namespace toile {

/// What the worn cloth suffers where the warp runs in a direction: by how much the strain along
/// warp, weft and bias goes beyond what the fabric allows, squared; and, a thousandth of that, the
/// squared strain itself, counting more along directions that give way little. Per worn area,
/// without dimension; 0 where there is none.
/// @param Q  #V x 2, the unit of the mesh  @param angle  of the warp, radians from the x axis of Q
/// Cost: linear in the triangles, 15 ms for a million. Pure, thread-safe.
double grainCost(const MeshArrays& mesh, const Points2& Q, const Fabric& fabric, double angle);

/// Of flat cloth, mm2.
struct StrainedArea {
    double all = 0;
    double beyond = 0;  ///< strained beyond the fabric along warp, weft or bias

    double share() const { return all > 0 ? beyond / all : 0; }
};

/// What is shown of a piece beside its fabric: counted triangle by triangle, as the window's list
/// of problems and fabric panel do. Nothing is beyond a fabric that is not stated.
/// @param angle  as for grainCost
/// Cost: linear in the triangles. Pure, thread-safe.
StrainedArea strainedArea(const MeshArrays& mesh, const Points2& Q, const Fabric& fabric,
                          double angle);

}  // namespace toile
