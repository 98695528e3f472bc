// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/sew/cloth.h"
#include "core/sew/cloth_stiffness.h"
#include "core/sew/contact.h"

namespace toile::sew {

struct SettleOptions {
    PieceStiffness stiffness{};
    /// Towards the surface, N/mm² (1e-5: 10 Pa, 1 g on 10 cm²); below 0: away from it.
    double pressure = 1e-5;
    double gravity = 0;              ///< along -y, m/s² (9.81)
    int threads = 1;                 ///< the same bytes for any number; at least 1
    double contactStiffness = 0.02;  ///< of the surface against what is in it, N/mm³
    /// It keeps off itself, and stays on the side of itself on which the design, or where it is not
    /// held first its start, has it: see `SelfContact`. False: cloth goes through cloth.
    bool touchesItself = false;
    double thickness = 1;  ///< that it keeps off itself, mm, above 0
    /// It is pinned to where `Cloth::X` has it first, and let go by and by: then it ends in the
    /// same place from wherever it starts. False: cloth that buckles may rest in many places, and
    /// the start decides.
    bool heldFirst = true;
    /// It has settled where the rest of force, root mean square over the vertices, is below this
    /// share of the force at seams. Garments of 5 000 to 85 000 triangles get there.
    double share = 1e-3;
    int maxIterations = 200;
    /// Called after each step with the positions, to show; may be empty.
    std::function<void(const Points3&)> watch{};
};

/// Cloth at rest, or nearly.
struct SettledCloth {
    Points3 X;               ///< mm
    int iterations = 0;      ///< factorisations
    double restForce = 0;    ///< of the vertices, root mean square, N
    double largestRest = 0;  ///< of one vertex, N
    /// What balances at sewn vertices, the sizes of the triangles' forces on them and the pressure
    /// added up, root mean square; of cloth without seams at all vertices. N.
    double seamForce = 0;
    /// False: the steps ran out, or none of them helps any more, or nothing holds it and it has
    /// fallen ten times its size.
    bool hasSettled = false;
};

/// Finds the rest of sewn cloth over a surface: a minimum of its membrane, bending and contact
/// energies by Newton's method with semidefinite parts of the Hessians, a damping as of Levenberg
/// and Marquardt ([NW06]), and a line search; first with a softer surface. One pattern and one
/// order of elimination for all steps. Energies are sums in order: the same bytes for the same
/// input. A vertex keeps to the sheet of the surface that it started on: see `Contact`.
/// @param start  of the cloth's vertices, mm, finite
/// Errors: NoGeometry (no triangles), FactorisationFailed, OutOfMemory, NotFinite, Cancelled.
/// Cost: a factorisation of size 3 #V a step, 20 to 100 steps.
Result<SettledCloth> settle(const Cloth& cloth, const Points3& start, const WornSurface& surface,
                            const SettleOptions& options, const Progress& progress);

}  // namespace toile::sew
