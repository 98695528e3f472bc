// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "core/base/error.h"
#include "core/geometry/triangle_tree.h"
#include "core/mesh/mesh_arrays.h"

namespace toile {

/// A barycentric coordinate below this is zero: the point lies on the opposite edge.
inline constexpr double kOnEdge = 1e-12;

/// A point of the surface: a triangle and three weights that sum to 1. A weight of zero puts the
/// point on the opposite edge, two zeros at a vertex; any triangle there will do.
struct SurfacePoint {
    int face = -1;
    Eigen::Vector3d barycentric = Eigen::Vector3d::Zero();
};

/// A curve on the surface. Neighbouring points lie in the closure of one common triangle, and the
/// curve runs straight between them. A closed curve repeats its first point at the end.
struct PathPolyline {
    std::vector<SurfacePoint> points;
    double length = 0;  ///< in the mesh's unit
};

/// Position in space.
inline Eigen::Vector3d positionOf(const MeshArrays& mesh, const SurfacePoint& point) {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (int k = 0; k < 3; ++k) {
        sum += point.barycentric[k] * mesh.V.row(mesh.F(point.face, k)).transpose();
    }
    return sum;
}

/// Position in the plane. @param Q  of the vertices, #V x 2
inline Eigen::RowVector2d flatPositionOf(const Points2& Q, const Triangles& F,
                                         const SurfacePoint& point) {
    Eigen::RowVector2d sum = Eigen::RowVector2d::Zero();
    for (int k = 0; k < 3; ++k) {
        sum += point.barycentric[k] * Q.row(F(point.face, k));
    }
    return sum;
}

/// Sum of the straight pieces. Cost: linear. Pure.
double measuredLength(const MeshArrays& mesh, const PathPolyline& path);

/// Finds the surface's closest point repeatedly, with a tree of boxes around the triangles. Keeps a
/// reference to the mesh. Cost: linear to build, about O(log #F) per query. Immutable.
class NearestSurface {
public:
    /// Precondition: at least one face, finite positions.
    explicit NearestSurface(const MeshArrays& mesh);

    /// Of several equally close points, the one on the face with the smallest index.
    SurfacePoint find(const Eigen::Vector3d& p) const;

private:
    const MeshArrays& mesh_;
    geometry::TriangleTree<3, double> tree_;
};

/// Weights of the point of a triangle closest to `p`; exact zeros on its edges and corners.
/// After Ericson, Real-Time Collision Detection, section 5.1.5.
Eigen::Vector3d nearestInTriangle(const Eigen::Vector3d& p, const Eigen::Vector3d& a,
                                  const Eigen::Vector3d& b, const Eigen::Vector3d& c);

/// The error for a cut that cannot be made: unconnected points, or too few.
inline Error cutError(Subject subject, Wording detail) {
    return {ErrorCode::CutImpossible, std::move(subject), std::move(detail)};
}

}  // namespace toile
