// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string_view>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/mesh/mesh_arrays.h"

namespace toile {

struct Piece;

/// A published way of flattening. docs/methods.md compares them.
enum class Method {
    Natural,   ///< free boundary, conformal [DMA02]; seam lengths are not kept
    Wang2005,  ///< boundary lengths kept exactly, conformal interior [Wang05]
};

/// How the boundary problem of [Wang05] eq. (9) is solved; both find the same outline on pieces of
/// garments. Where one fails, the other is tried (boundary_problem.h).
enum class BoundarySolver {
    Newton,  ///< full Newton in edge directions, O(n) per step
    Slcp,    ///< sequential linearly constrained programming, [Wang05] eq. (14) to (22)
};

struct FlattenOptions {
    Method method = Method::Wang2005;
    BoundarySolver boundarySolver = BoundarySolver::Newton;  ///< used by Wang2005
};

/// A flattened piece: one planar point per vertex, orientation kept (never mirrored).
struct FlatPiece {
    Points2 Q;  ///< #V x 2, millimetres, in the piece's vertex order
    BoundarySolver boundarySolver = BoundarySolver::Newton;  ///< the one that found the outline
    int boundaryIterations = 0;  ///< 0 where the method solves no boundary problem
    double closureGap = 0;       ///< |sum of the boundary edge vectors| / perimeter, before closing
    double angleEnergy = 0;      ///< 1/2 sum (theta - alpha)^2, radians squared
    double boundarySeconds = 0;
    double interiorSeconds = 0;
};

/// Flattens one piece. The y axis points where the 3D +y axis points as seen in the plane.
/// Holes are filled for the solve; the lengths of their rims are not kept.
/// @param piece  a disk, holes aside (no defect), millimetres
/// @errors the piece's own defect, NoClosedOutline, BoundaryNotConverged, FactorisationFailed,
///         NotFinite, Cancelled
/// Cost: one sparse factorisation of the interior, two back-substitutions. Re-entrant.
Result<FlatPiece> flatten(const Piece& piece, const FlattenOptions& options, Progress& progress);

/// "natural", "wang2005"; "newton", "slcp": the words of the command line and the report.
std::string_view name(Method method);
std::string_view name(BoundarySolver solver);
std::optional<Method> parseMethod(std::string_view text);
std::optional<BoundarySolver> parseBoundarySolver(std::string_view text);

}  // namespace toile
