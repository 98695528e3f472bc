// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/mesh/repair.h"

namespace toile {

/// Positions as an array of N x 3, or a list of points seen as one; not copied.
using PointsView = Eigen::Ref<const Points3>;

struct WeldOptions {
    double tolerance = 0;    ///< mm; 0: equal coordinates only
    bool borderOnly = true;  ///< leave inner vertices alone: welding one can only pinch the surface
};

/// Which vertices lie on each other.
struct Weld {
    std::vector<int> target;  ///< per vertex: the vertex it becomes, of least index; or itself
    int merged = 0;           ///< how many become another one
};

/// Finds the vertices of these triangles that lie on each other. In order of index, a vertex joins
/// the first earlier one that stands within the tolerance and joined none itself, so that no chain
/// of small steps carries a vertex far. Vertices that no triangle uses and vertices that are not
/// finite stay themselves; -0 equals 0. To stay within one object, give the triangles of that
/// object. Border is every edge that does not have two faces.
/// @param F  indices in range   @param V  mm
/// Cost: linear on average, in all of V and F. Pure; does not depend on the order of faces.
Weld findWeld(const Triangles& F, const PointsView& V, const WeldOptions& options);

/// The note VerticesWelded: how many, and where the first. Precondition: weld.merged > 0.
Error weldNote(const Weld& weld, const PointsView& V, const std::string& name);

/// A tolerance for borders that are the same but for the digits written: a thousandth of the median
/// edge, mm; 0 where there are no triangles.
double weldTolerance(const Triangles& F, const PointsView& V);

/// True where nearly every vertex is used by a single face (a triangle, or a quad cut in two) and
/// many of them lie exactly on others: triangles that a file lists one by one. Most files are told
/// apart from these by a count.
bool looksUnwelded(const Triangles& F, const PointsView& V);

}  // namespace toile
