// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>
#include <memory>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/flatten/base/flat_piece.h"
#include "core/flatten/boundary/length_constraints.h"
#include "core/flatten/isometric/kkt_solver.h"
#include "core/mesh/edge_table.h"
#include "core/mesh/mesh_arrays.h"

namespace toile::isometric {

struct DescentOptions {
    /// Ends when a step promises to lower the objective's excess over 1 by less than this part of
    /// it, or has lowered it by less than twice that.
    double tolerance = 1e-4;
    int maxIterations = 500;
    /// A distortion that is wanted. The descent ends as hopeless where it goes down so slowly that
    /// it would not come there in several times the steps that it has had.
    double wanted = std::numeric_limits<double>::infinity();
    /// Keeps the outline, and every rim, from crossing itself (outline_terms.h). At the start
    /// none may.
    bool keepOutlineSimple = false;
    KktSizes sizes{};
    /// Of the boundary lengths, as a descent of a like piece with the same outline left them; if
    /// empty, none is known.
    Eigen::VectorXd multipliers{};
    /// To begin with, as a descent of a piece with the same triangles and nearly the same shape
    /// left it; null where there is none. Not for an outline to be kept simple.
    std::shared_ptr<const KktModel> model{};
    bool sharesModel = false;  ///< the result is to have the last model
};

/// How exactly a quality asks the descent to end.
DescentOptions descentOptions(Quality quality);

/// Whether a flattening with more conditions (an outline that does not cross itself, rims of exact
/// length) is near one without, by their energies: it adds less than 5 % strain, root mean square
/// (strain e in both directions costs 2 e^2). Cloth that cannot lie flat without strain anyway may
/// be asked for some three times as much, up to 16 %. Beyond, a cut serves it better than force.
bool isNear(double energy, double before);
/// The energy up to which it is.
double nearLimit(double before);

struct DescentResult {
    Points2 Q;
    double distortion = 0;  ///< symmetric Dirichlet energy, 1 where isometric
    int iterations = 0;
    Eigen::VectorXd multipliers{};            ///< of the boundary lengths: how much each edge pulls
    bool converged = false;                   ///< the tolerance was met
    bool isHopeless = false;                  ///< `DescentOptions::wanted` is out of reach
    std::shared_ptr<const KktModel> model{};  ///< the last; null where not asked for, or large
};

/// Lowers the symmetric Dirichlet energy of a flattening over interior and boundary positions while
/// every boundary edge keeps its length (`EdgeLoops::lengths`). Every iterate is feasible: exact
/// lengths, no flipped triangle, objective (isometric_objective.h: the energy and small terms
/// beside it) below the one before; ending early costs quality only, and the result is never worse
/// than the start, or the exact one next to it.
///
/// Each step minimises the convexified second-order model under the linearised length conditions
/// (sequential quadratic programming): the KKT system is solved by the augmented Lagrangian, whose
/// matrix has the mesh's own sparsity (kkt_solver.h). Its factorisation serves several steps, as
/// long as they go down faster than a new one would be worth; the steps since tell what changed
/// (refactorisation_policy.h).
/// The step is cut off before a triangle loses its area, a second-order correction with the same
/// factorisation gives the lengths back, and the step is shortened until the objective falls, or
/// stretched as long as it does. Where single triangles stop it, their vertices are moved first.
///
/// @param mesh, table  a disk, holes aside, without degenerate triangles
/// @param loops  all of its boundary, the outline first. One that is held (`withOutlineHeld`) stays
///               where the start has it, but for rounding; its lengths must be those there
/// @param start  #V x 2, unit of the mesh, no flipped triangle; lengths exact, or near enough to be
///               made so without one
/// @param progress  each step is a stage of it
/// Errors: NotFinite (the start has flipped triangles), BoundaryNotConverged (lengths are too far
/// from exact), OutOfMemory, Cancelled. A step that cannot be computed ends the descent, and
/// `converged` is false. Cost: a sparse factorisation of size 2 #V per two or three iterations; for
/// large pieces ten to twenty times some four products with the matrix per iteration. Re-entrant.
Result<DescentResult> lowerIsometricEnergy(const MeshArrays& mesh, const EdgeTable& table,
                                           const EdgeLoops& loops, const Points2& start,
                                           const DescentOptions& options, const Progress& progress);

}  // namespace toile::isometric
