// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <Eigen/Core>

#include "core/cut/surface_links.h"
#include "core/symmetry/mirror_plane.h"

namespace toile {

/// A line on a surface by its points, mm; one that goes all round does not repeat its first.
struct FormLine {
    std::vector<Eigen::Vector3d> points;
    bool isRound = false;
};

/// The lines along which a surface is bent sharply: the edges of a box, the rim of a lid. They end
/// where three meet, or where they turn a corner. Longest first. Cost: O(#E log #E). Pure.
std::vector<FormLine> ridgesOf(const SurfaceLinks& links);

/// Where a plane meets the surface. Longest first. Linear but for the sorting. Pure.
std::vector<FormLine> sectionsOf(const SurfaceLinks& links, const MirrorPlane& plane);

/// Length in mm, round lines closed.
double lengthOf(const std::vector<Eigen::Vector3d>& points, bool isRound);

}  // namespace toile
