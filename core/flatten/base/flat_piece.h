// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "core/base/error.h"
#include "core/base/words.h"
#include "core/mesh/mesh_arrays.h"
#include "core/quality/outline_crossings.h"

namespace toile {

/// A published way of flattening. docs/methods.md compares them.
enum class Method {
    Isometric,  ///< boundary lengths kept exactly, the rest as isometric as they allow, no flips
    Curvature,  ///< boundary lengths kept exactly, angles placed by the curvature, conformal inside
    Wang2005,   ///< boundary lengths kept exactly, angles evenly, conformal interior [Wang05]
    Stretch,    ///< edge lengths kept on a circle, interior of least stretch [YBS04]
    Natural,    ///< free boundary, conformal [DMA02]; seam lengths are not kept
    Lscm,       ///< free boundary, least squares conformal [LPRM02]; seam lengths are not kept
    Abf,        ///< free boundary, angle based [SLMB05]; seam lengths are not kept
    Convex,     ///< edge lengths kept on a circle, interior without flips [Flo03]
};

/// What the command line, the report and the window need to know of a method.
struct MethodTraits {
    Method method;
    std::string_view name;     ///< one word, as typed: "wang2005"
    std::string_view summary;  ///< a line for a list, no full stop
    bool keepsLengths;         ///< every boundary edge has its 3D length
    bool solvesBoundary;       ///< uses the boundary problem of [Wang05] eq. (9)
};

/// All methods, the one recommended first.
std::span<const MethodTraits> allMethods();
const MethodTraits& traits(Method method);
std::string_view name(Method method);
std::optional<Method> parseMethod(std::string_view text);

/// How the boundary problem of [Wang05] eq. (9) is solved; both find the same outline on pieces of
/// garments. Where one fails, the other is tried (boundary_problem.h).
enum class BoundarySolver {
    Newton,  ///< full Newton in edge directions, O(n) per step
    Slcp,    ///< sequential linearly constrained programming, [Wang05] eq. (14) to (22)
};

/// How [DMA02]'s free boundary is held against collapsing to a point.
enum class FreeBoundary {
    Pinned,    ///< two far boundary vertices are given
    Spectral,  ///< no vertex is special: the least eigenvector instead [MTAD08]
};

/// How much time `isometric` takes for how little distortion.
enum class Quality {
    Draft,     ///< within some percent of the least distortion: for dragging
    Standard,  ///< within about a thousandth
    Fine,      ///< to the last digits that matter
};

/// The outline in which `stretch` places the interior. Both have exact lengths.
enum class StretchOutline {
    Circle,     ///< a convex one, as published: no triangle flips, much distortion
    Curvature,  ///< that of `curvature`, which suits the cloth better
};

struct FlattenOptions {
    Method method = Method::Isometric;
    BoundarySolver boundarySolver = BoundarySolver::Newton;  ///< where one is solved
    FreeBoundary freeBoundary = FreeBoundary::Pinned;        ///< used by Natural
    Quality quality = Quality::Standard;                     ///< used by Isometric
    StretchOutline stretchOutline = StretchOutline::Circle;  ///< used by Stretch
    /// mu of [DMA02]'s mix of conformal and authalic weights, (1 - mu) and mu, in [0, 1]; used
    /// where a conformal interior is placed in a fixed boundary (Wang2005, Curvature).
    double authalic = 0;

    bool operator==(const FlattenOptions&) const = default;
};

/// The outline of a piece as it is drawn, where that is not the polygon through its vertices:
/// a closed line in the same coordinates, fine enough to be taken for the curve. The vertices of
/// the outline lie on it, each at its place.
struct FlatLine {
    Points2 points;           ///< #n x 2, mm, anti-clockwise, the first not repeated
    std::vector<double> arc;  ///< #n + 1, mm: place of each on the outline in 3D, over one turn
    int iterations = 0;       ///< of the solver that found it
    double farthest = 0;      ///< from the outline as it was solved, mm
    bool converged = true;    ///< false: it has its lengths and bounds, and could be smoother
    bool hasYielded = false;  ///< it stays nearer to the exact outline where it would cross itself
};

/// A flattened piece: one planar point per vertex, orientation kept (never mirrored).
struct FlatPiece {
    Points2 Q;  ///< #V x 2, millimetres, in the piece's vertex order
    BoundarySolver boundarySolver = BoundarySolver::Newton;  ///< the one that found the outline
    int boundaryIterations = 0;  ///< 0 where the method solves no boundary problem
    double closureGap = 0;       ///< |sum of the boundary edge vectors| / perimeter, before closing
    double angleEnergy = 0;      ///< 1/2 sum (theta - alpha)^2, radians squared
    int interiorIterations = 0;  ///< of methods that iterate inside; 0 for one linear solve
    /// Edges turned to make the cotangent weights non-negative where triangles flipped
    /// (conformal_interior.h); 0 where the interior was placed by the mesh's own weights.
    int delaunayFlips = 0;
    /// Found from where an earlier version lay: as good, but not a function of the piece alone.
    bool warm = false;
    /// By how much moving a crossing outline apart has raised the largest edge strain: 0.1 = from
    /// 2 % to 12 %. 0 where nothing was moved.
    double apartStrain = 0;
    double boundarySeconds = 0;
    double interiorSeconds = 0;
    Problems notes{};  ///< what the user should know of the result: crossings, degenerate triangles
    std::vector<OutlineCrossing> crossings{};  ///< of the outline, for the search of a cut
    std::shared_ptr<const FlatLine> line{};    ///< null: the outline is the polygon of its vertices
};

/// What the choices of a flattening are called on the command line, in the report and in project
/// files. Once released they stay.
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
