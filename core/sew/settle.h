// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/garment/fabric_stiffness.h"
#include "core/sew/cloth.h"
#include "core/sew/contact.h"

namespace toile::sew {

struct SettleOptions {
    PieceStiffness stiffness{};
    /// Towards the surface, N/mm² (1e-5: 10 Pa, 1 g on 10 cm²); below 0: away from it.
    double pressure = 1e-5;
    double gravity = 0;              ///< along -y, m/s² (9.81)
    int threads = 1;                 ///< results do not depend on it; at least 1
    double contactStiffness = 0.02;  ///< stiffness against penetration, N/mm³
    /// The cloth repels itself and keeps its layers in the order of the design, or of the start if
    /// it is not held first: see `SelfContact`. False: cloth passes through cloth.
    bool touchesItself = false;
    double thickness = 1;  ///< distance kept between layers, mm, above 0
    /// Cloth is first pinned to `Cloth::X`, then released in stages: it ends in the same place from
    /// any start. False: buckled cloth may rest in many places, and the start decides.
    bool heldFirst = true;
    /// Settled if the residual force, root mean square over the vertices, is below this share of
    /// the force at seams. Garments of 5 000 to 85 000 triangles reach it.
    double share = 1e-3;
    int maxIterations = 200;
    /// Called after each step with the positions, for display; may be empty.
    std::function<void(const Points3&)> watch{};
};

/// Cloth at rest, or nearly.
struct SettledCloth {
    Points3 X;               ///< mm
    int iterations = 0;      ///< factorisations
    double restForce = 0;    ///< residual of the vertices, root mean square, N
    double largestRest = 0;  ///< residual of one vertex, N
    /// Sum of the magnitudes of the triangles' forces and the pressure at sewn vertices, root mean
    /// square; without seams at all vertices. N.
    double seamForce = 0;
    /// False: the steps ran out, no step helps any more, or unsupported cloth has fallen ten times
    /// its size.
    bool hasSettled = false;
};

/// Finds the equilibrium of sewn cloth over a surface: a minimum of its membrane, bending and
/// contact energies by Newton's method with semidefinite parts of the Hessians, Levenberg-Marquardt
/// damping ([NW06]), and a line search; first with a softer surface. All steps share a sparsity
/// pattern and an elimination order. Sums have a fixed order: the same input gives the same bytes.
/// A vertex stays on the sheet of the surface where it started: see `Contact`.
/// @param start  of the cloth's vertices, mm, finite
/// Errors: NoGeometry (no triangles), FactorisationFailed, OutOfMemory, NotFinite, Cancelled.
/// Cost: a factorisation of size 3 #V a step, 20 to 100 steps.
Result<SettledCloth> settle(const Cloth& cloth, const Points3& start, const WornSurface& surface,
                            const SettleOptions& options, const Progress& progress);

}  // namespace toile::sew
