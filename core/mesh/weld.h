// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/mesh/repair.h"

namespace toile {

/// Positions as an array of N x 3, or a view of a list of points; not copied.
using PointsView = Eigen::Ref<const Points3>;

struct WeldOptions {
    double tolerance = 0;    ///< mm; 0: equal coordinates only
    bool borderOnly = true;  ///< keep inner vertices: welding them can only pinch the surface
};

/// Which vertices coincide.
struct Weld {
    std::vector<int> target;  ///< per vertex: the smallest index it is merged into; or itself
    int merged = 0;           ///< number of vertices merged into another one
};

/// Finds the coinciding vertices of these triangles. In order of index, a vertex joins the first
/// earlier one that lies within the tolerance and did not join another, so that no chain of small
/// steps moves a vertex far. Unused and non-finite vertices stay unchanged; -0 equals 0. To stay
/// within one object, give the triangles of that object. An edge without exactly two faces is
/// border.
/// @param F  indices in range   @param V  mm
/// Cost: linear on average, in all of V and F. Pure; does not depend on the order of faces.
Weld findWeld(const Triangles& F, const PointsView& V, const WeldOptions& options);

/// The note VerticesWelded: the count and the first place. Precondition: weld.merged > 0.
Error weldNote(const Weld& weld, const PointsView& V, const std::string& name);

/// A tolerance for borders that differ only by rounding in the file: a thousandth of the median
/// edge, mm; 0 if there are no triangles.
double weldTolerance(const Triangles& F, const PointsView& V);

/// True if nearly every vertex is used by a single face (a triangle, or a quad cut in two) and many
/// of them coincide exactly with others: triangles that a file lists one by one. For most files a
/// count is enough to rule this out.
bool looksUnwelded(const Triangles& F, const PointsView& V);

}  // namespace toile
