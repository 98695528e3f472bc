// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "core/base/error.h"
#include "core/base/wording.h"
#include "core/mesh/mesh_arrays.h"
#include "core/quality/outline_crossings.h"

namespace toile {

/// A published way of flattening. docs/methods.md compares them.
enum class Method {
    Isometric,  ///< boundary lengths exact, the rest as isometric as possible, no flips
    Curvature,  ///< boundary lengths exact, angles placed by the curvature, conformal inside
    Wang2005,   ///< boundary lengths exact, angles changed evenly, conformal interior [Wang05]
    Stretch,    ///< edge lengths kept on a circle, interior of minimal stretch [YBS04]
    Natural,    ///< free boundary, conformal [DMA02]; seam lengths are not kept
    Lscm,       ///< free boundary, least squares conformal [LPRM02]; seam lengths are not kept
    Abf,        ///< free boundary, angle based [SLMB05]; seam lengths are not kept
    Convex,     ///< edge lengths kept on a circle, interior without flips [Flo03]
};

/// Properties of a method for the command line, the report and the window.
struct MethodTraits {
    Method method;
    std::string_view name;     ///< as typed, a single word: "wang2005"
    std::string_view summary;  ///< a line for a list, no full stop
    bool keepsLengths;         ///< every boundary edge has its 3D length
    bool solvesBoundary;       ///< uses the boundary problem of [Wang05] eq. (9)
};

/// All methods, the recommended one first.
std::span<const MethodTraits> allMethods();
const MethodTraits& traits(Method method);
std::string_view name(Method method);
std::optional<Method> parseMethod(std::string_view text);

/// Solver of the boundary problem of [Wang05] eq. (9); both find the same outline on pieces of
/// garments. If one fails, the other is tried (boundary_problem.h).
enum class BoundarySolver {
    Newton,  ///< full Newton in edge directions, O(n) per step
    Slcp,    ///< sequential linearly constrained programming, [Wang05] eq. (14) to (22)
};

/// How [DMA02]'s free boundary is prevented from collapsing to a point.
enum class FreeBoundary {
    Pinned,    ///< two distant boundary vertices are fixed
    Spectral,  ///< no fixed vertices: the eigenvector of the smallest eigenvalue [MTAD08]
};

/// Trade-off of `isometric` between time and distortion.
enum class Quality {
    Draft,     ///< within some percent of the minimal distortion: for dragging
    Standard,  ///< within about a thousandth
    Fine,      ///< to the last significant digits
};

/// The outline in which `stretch` places the interior. Both have exact lengths.
enum class StretchOutline {
    Circle,     ///< convex, as published: no triangle flips, much distortion
    Curvature,  ///< that of `curvature`, which suits cloth better
};

namespace isometric {

struct EnergyKind;  // isometric/flat_energy.h
extern const EnergyKind kSymmetricDirichlet;

}  // namespace isometric

struct FlattenOptions {
    Method method = Method::Isometric;
    BoundarySolver boundarySolver = BoundarySolver::Newton;  ///< if solvesBoundary
    FreeBoundary freeBoundary = FreeBoundary::Pinned;        ///< used by Natural
    Quality quality = Quality::Standard;                     ///< used by Isometric
    StretchOutline stretchOutline = StretchOutline::Circle;  ///< used by Stretch
    /// mu of [DMA02]'s mix of conformal and authalic weights, (1 - mu) and mu, in [0, 1]; used for
    /// a conformal interior in a fixed boundary (Wang2005, Curvature).
    double authalic = 0;
    /// What Isometric lowers; alike in all directions unless another energy is given.
    const isometric::EnergyKind* energy = &isometric::kSymmetricDirichlet;

    bool operator==(const FlattenOptions&) const = default;
};

/// The drawn outline of a piece if it is not the polygon through its vertices: a closed line in the
/// same coordinates, fine enough to represent the curve. The outline's vertices lie on it, each at
/// its place.
struct FlatLine {
    Points2 points;           ///< #n x 2, mm, anti-clockwise, the first not repeated
    std::vector<double> arc;  ///< #n + 1, mm: place of each on the outline in 3D, over one turn
    int iterations = 0;       ///< of the solver
    double farthest = 0;      ///< largest distance from the solved outline, mm
    bool converged = true;    ///< false: lengths and bounds hold, but it could be smoother
    bool hasYielded = false;  ///< it was drawn nearer to the exact outline to avoid crossing itself
};

/// A flattened piece: one planar point per vertex, with the same orientation (never mirrored).
struct FlatPiece {
    Points2 Q;  ///< #V x 2, millimetres, in the piece's vertex order
    BoundarySolver boundarySolver = BoundarySolver::Newton;  ///< the one that found the outline
    int boundaryIterations = 0;  ///< 0 if the method solves no boundary problem
    double closureGap = 0;       ///< |sum of the boundary edge vectors| / perimeter, before closing
    double angleEnergy = 0;      ///< 1/2 sum (theta - alpha)^2, radians squared
    int interiorIterations = 0;  ///< of methods that iterate inside; 0 for a single linear solve
    /// Edges flipped to make cotangent weights non-negative where triangles flipped
    /// (conformal_interior.h); 0 if the mesh's own weights were used.
    int delaunayFlips = 0;
    /// Started from an earlier version: equally good, but depends on more than the piece alone.
    bool warm = false;
    /// Increase of the largest edge strain by moving a crossing outline apart: 0.1 = from 2 % to 12
    /// %. 0 if nothing was moved.
    double apartStrain = 0;
    double boundarySeconds = 0;
    double interiorSeconds = 0;
    Problems notes{};  ///< notes for the user: crossings, degenerate triangles
    std::vector<OutlineCrossing> crossings{};  ///< of the outline, for finding a cut
    std::shared_ptr<const FlatLine> line{};    ///< null: the outline is the polygon of its vertices
};

/// Names of these options on the command line, in the report and in project files. Never change
/// released names.
inline constexpr Word<BoundarySolver> kBoundarySolverWords[] = {{BoundarySolver::Newton, "newton"},
                                                                {BoundarySolver::Slcp, "slcp"}};
inline constexpr Word<Quality> kQualityWords[] = {
    {Quality::Draft, "draft"}, {Quality::Standard, "standard"}, {Quality::Fine, "fine"}};
inline constexpr Word<FreeBoundary> kFreeBoundaryWords[] = {{FreeBoundary::Pinned, "pinned"},
                                                            {FreeBoundary::Spectral, "spectral"}};
inline constexpr Word<StretchOutline> kStretchOutlineWords[] = {
    {StretchOutline::Circle, "circle"}, {StretchOutline::Curvature, "curvature"}};

inline std::string_view name(BoundarySolver solver) {
    return wordOf(kBoundarySolverWords, solver);
}
inline std::optional<BoundarySolver> parseBoundarySolver(std::string_view text) {
    return parseWord(kBoundarySolverWords, text);
}

}  // namespace toile
