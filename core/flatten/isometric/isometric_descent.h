// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>
#include <memory>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/flatten/base/flat_piece.h"
#include "core/flatten/boundary/length_constraints.h"
#include "core/flatten/isometric/flat_energy.h"
#include "core/flatten/isometric/kkt_solver.h"
#include "core/mesh/edge_table.h"
#include "core/mesh/mesh_arrays.h"

namespace toile::isometric {

struct DescentOptions {
    /// Ends if a step promises to lower the objective's excess over 1 by less than this share, or
    /// has lowered it by less than twice that share.
    double tolerance = 1e-4;
    int maxIterations = 500;
    /// Target distortion. The descent ends as hopeless if it is so slow that it would not reach the
    /// target in several times the steps taken so far.
    double wanted = std::numeric_limits<double>::infinity();
    /// Keeps the outline and every rim from crossing themselves (outline_terms.h). Precondition:
    /// none crosses itself at the start.
    bool keepOutlineSimple = false;
    KktSizes sizes{};
    EnergyModel energy{};  ///< what is lowered
    /// Multipliers of the boundary lengths from a descent of a similar piece with the same outline;
    /// empty if unknown.
    Eigen::VectorXd multipliers{};
    /// First model, from a descent of a piece with the same triangles and nearly the same shape;
    /// null if there is none. Do not combine with `keepOutlineSimple`.
    std::shared_ptr<const KktModel> model{};
    bool sharesModel = false;  ///< the result includes the last model
};

/// Tolerances of the descent for a quality.
DescentOptions descentOptions(Quality quality, const EnergyModel& energy = {});

/// Whether a flattening with more constraints (an outline that does not cross itself, rims of exact
/// length) is near one without, by their energies: it adds less than 5 % RMS strain (strain e in
/// both directions costs 2 e^2). Cloth that cannot lie flat without strain may get about three
/// times as much, up to 16 %. Above that, a cut is better.
bool isNear(double energy, double before);
/// The largest energy for which `isNear` is true.
double nearLimit(double before);

struct DescentResult {
    Points2 Q;
    double distortion = 0;  ///< energy, 1 if isometric
    int iterations = 0;
    Eigen::VectorXd multipliers{};            ///< of the boundary lengths: the tension of each edge
    bool converged = false;                   ///< the tolerance was met
    bool isHopeless = false;                  ///< `DescentOptions::wanted` is out of reach
    std::shared_ptr<const KktModel> model{};  ///< the last; null if not requested, or large
};

/// Lowers the energy (flat_energy.h) of a flattening over interior and boundary positions while
/// every boundary edge keeps its length (`EdgeLoops::lengths`). Every iterate is feasible: exact
/// lengths, no flipped triangle, and a lower objective (isometric_objective.h: the energy and small
/// terms). Ending early costs quality only; the result is never worse than the start, or than the
/// nearest exact one.
///
/// Each step minimises the convexified second-order model under the linearised length conditions
/// (sequential quadratic programming): the KKT system is solved by the augmented Lagrangian, whose
/// matrix has the mesh's own sparsity (kkt_solver.h). Its factorisation is reused for several steps
/// while that is faster than a new one; the history of steps corrects for the change
/// (refactorisation_policy.h). The step ends before a triangle loses its area, a second-order
/// correction with the same factorisation restores the lengths, and the step is shortened until the
/// objective falls, or stretched while it falls. If single triangles stop a step, their vertices
/// are moved first.
///
/// @param mesh, table  a disk, may have holes, without degenerate triangles
/// @param loops  its whole boundary, the outline first. A held outline (`withOutlineHeld`) stays at
/// the start's positions, except for rounding; its lengths must be the start's
/// @param start  #V x 2, unit of the mesh, no flipped triangle; lengths exact, or so close that
/// they can be made exact without flipping a triangle
/// @param progress  each step is a stage of it
/// Errors: NotFinite (the start has flipped triangles), BoundaryNotConverged (lengths are too far
/// from exact), OutOfMemory, Cancelled. A step that cannot be computed ends the descent, and
/// `converged` is false. Cost: a sparse factorisation of size 2 #V per two or three iterations; for
/// large pieces ten to twenty rounds of about four matrix products per iteration. Re-entrant.
Result<DescentResult> lowerIsometricEnergy(const MeshArrays& mesh, const EdgeTable& table,
                                           const EdgeLoops& loops, const Points2& start,
                                           const DescentOptions& options, const Progress& progress);

}  // namespace toile::isometric
