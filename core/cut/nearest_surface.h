// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/cut/surface_point.h"
#include "core/geometry/triangle_tree.h"

namespace toile {

/// Finds the surface's nearest point again and again: a tree of boxes around the triangles. Keeps
/// a reference to the mesh. Cost: linear to build, about O(log #F) a question. Immutable.
class NearestSurface {
public:
    /// Precondition: at least one face, finite positions.
    explicit NearestSurface(const MeshArrays& mesh);

    /// Where several points are equally near, the one on the face with the least index.
    SurfacePoint find(const Eigen::Vector3d& p) const;

private:
    const MeshArrays& mesh_;
    TriangleTree<3, double> tree_;
};

/// Weights of the point of a triangle nearest to `p`; exact zeros on its edges and corners.
/// After Ericson, Real-Time Collision Detection, section 5.1.5.
Eigen::Vector3d nearestInTriangle(const Eigen::Vector3d& p, const Eigen::Vector3d& a,
                                  const Eigen::Vector3d& b, const Eigen::Vector3d& c);

}  // namespace toile
