// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/cut/surface_point.h"

namespace toile {

struct CutOptions {
    /// Skip a path that cannot be made, with the reason in its `OpenedCut`; else the first such
    /// path fails the whole call.
    bool leavesOut = false;
};

/// The two sides of a run of a cut, in the direction of the path: vertices of the new mesh, as many
/// on the left as on the right, at the same positions. At the end of a slit both sides have the
/// same vertex.
struct CutRun {
    std::vector<int> left;  ///< seen from the fabric's right side
    std::vector<int> right;
    double length = 0;
};

/// The result of one path. It has several runs if another cut branches off, and none if the path
/// runs along a rim or along an earlier cut.
struct OpenedCut {
    std::vector<CutRun> runs;
    double length = 0;  ///< of all runs
    std::optional<Error> error{};
};

struct CutResult {
    MeshArrays mesh;
    std::vector<int> sourceVertex;  ///< vertex of the source at the place of each new vertex, or -1
    std::vector<int> sourceFace;    ///< triangle of the source that contains each new triangle
    std::vector<SurfacePoint> place;  ///< of each new vertex, in the source; no face if unused
    std::vector<OpenedCut> cuts;      ///< one per path
};

/// Cuts a mesh open along curves: the curves become edges, and the two sides of these edges
/// separate. A slit inside the piece stays joined at its two ends, a path that reaches the rim
/// opens there; from rim to rim, or in a loop, it may separate the piece. Paths may cross, touch
/// and overlap. Vertices of the source keep their indices, copies and new ones follow; the parts of
/// a triangle are in the order of the source. Area and orientation are kept; the only new rims are
/// the cuts. A slit of one edge gets a vertex in its middle, since it could not open otherwise.
/// @param paths     see PathPolyline; made in this order
/// @param progress  polled, nothing is reported
/// @errors  NonManifoldEdge, OpposedWinding; a cut error if neighbouring points of a path share no
///         triangle, or if it would divide a triangle into thousands of parts; Cancelled
/// Cost: linear in the mesh, with `leavesOut` for each path, plus the square of the parts of each
/// crossed triangle; those are bounded. Pure.
Result<CutResult> cutAlong(const MeshArrays& mesh, const std::vector<PathPolyline>& paths,
                           const CutOptions& options = {}, const Progress& progress = Progress());

}  // namespace toile
