// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <Eigen/Core>

#include "core/cut/surface_paths.h"
#include "core/symmetry/mirror_plane.h"
#include "core/tailor/seam_pull.h"

namespace toile {

/// A line on a surface by its points, mm; a closed one does not repeat its first.
struct FormLine {
    std::vector<Eigen::Vector3d> points;
    bool isRound = false;
};

/// Lines along which a surface is bent sharply: the edges of a box, the rim of a lid. They end
/// where three meet, or at corners. Longest first. Cost: O(#E log #E). Pure.
std::vector<FormLine> ridgesOf(const SurfaceLinks& links);

/// The intersection of a plane and the surface. Longest first. Linear, except sorting. Pure.
std::vector<FormLine> sectionsOf(const SurfaceLinks& links, const MirrorPlane& plane);

/// Length in mm; closed lines include the way back to the first point.
double lengthOf(const std::vector<Eigen::Vector3d>& points, bool isRound);

}  // namespace toile

namespace toile::tailor {

/// Lines of the mesh that look like seams and are not found yet, like princess lines, yokes, bands
/// of necks and collars: long, likely, symmetric in the mirror plane, and extended to other lines
/// or rims.
/// @param known  ways of vertices
/// Cost: a search for each end of each. Deterministic.
std::vector<std::vector<int>> styleLines(const BodyWays& ways, const MeshLines& lines,
                                         const SeamPull& pull,
                                         const std::vector<std::vector<int>>& known);

}  // namespace toile::tailor
