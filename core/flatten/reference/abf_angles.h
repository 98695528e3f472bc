// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <Eigen/Core>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/mesh/mesh_arrays.h"

namespace toile {

/// Corner angles of a planar mesh.
struct PlanarAngles {
    Eigen::MatrixX3d angles;  ///< #F x 3, radians, in (0, pi)
    int iterations = 0;
    double residual = 0;  ///< largest violation of a constraint, radians (wheels: log of a ratio)
};

/// [SLMB05]: the angles x closest to the surface's, minimise sum ((x - beta) / beta)^2,
/// such that
///   every triangle's angles sum to pi,
///   the angles around every interior vertex sum to 2 pi,
///   the triangles around every interior vertex close up: sum log sin x_next - log sin x_previous
///   = 0, the logarithm of [SLMB05]'s wheel condition.
/// beta are the 3D angles, scaled around each interior vertex to 2 pi. In logarithms every term is
/// a function of one angle, so the Hessian of the Lagrangian is diagonal with the constraints'
/// curvature included. It is kept positive; after eliminating the triangles' own multipliers as in
/// ABF++, this leaves a symmetric positive definite system of size 2 #interior.
/// A step that would move an angle out of (0, pi) is shortened.
/// @param boundary  vertices without constraints; the mesh is a disk
/// Errors: FactorisationFailed, OutOfMemory, NotFinite, Cancelled (checked every step). Missing
/// convergence is no error: see `residual`. Cost: a factorisation per step, 2 to 11 steps on the
/// pieces tried; at most 30, if many angles are small and change strongly. Re-entrant.
Result<PlanarAngles> closestPlanarAngles(const MeshArrays& mesh, const std::vector<int>& boundary,
                                         const Progress& progress);

}  // namespace toile
