// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/cut/surface_point.h"
#include "core/geometry/triangle_tree.h"
#include "core/mesh/mesh_arrays.h"
#include "core/sew/space_matrix.h"

namespace toile::sew {

/// The surface under the cloth: the design, or a body. Signed distances use the nearest point and
/// the angle-weighted normal there ([BA05]); they are positive on the side from which triangles run
/// anti-clockwise. Beyond a rim the distance is measured from the plane that extends it, so that
/// cloth that reaches beyond the surface neither falls around its edge nor sticks to it. Beyond a
/// corner of the rim the components beyond its two edges are ignored.
/// Immutable; thread-safe. One query costs about log #F.
class WornSurface {
public:
    /// Precondition: at least one face with an area, finite positions; neighbouring triangles are
    /// consistently oriented and share their vertices. A face without area uses the normal of its
    /// neighbours.
    explicit WornSurface(MeshArrays mesh);
    WornSurface(const WornSurface&) = delete;
    WornSurface& operator=(const WornSurface&) = delete;

    struct Place {
        double distance;       ///< signed, mm
        Eigen::Vector3d away;  ///< unit vector along which the distance grows
        Eigen::Matrix3d bend;  ///< derivative of `away`: the distance's second derivative, 1/mm
        int face;              ///< face of the nearest point
    };

    /// @param near  a face near the point, if known: speeds up the search, with the same result
    Place placeOf(const Eigen::Vector3d& p, int near = -1) const;
    /// Unsigned distance to the surface itself, also beyond a rim, mm.
    double distanceTo(const Eigen::Vector3d& p) const;
    const MeshArrays& mesh() const { return mesh_; }

private:
    const MeshArrays mesh_;
    geometry::TriangleTree<3, double> tree_;
    Triangles faceEdges_;
    Points3 faceNormals_, edgeNormals_, vertexNormals_;
    std::vector<char> isRimEdge_, isRimVertex_;
    /// Per vertex of the rim: directions beyond the edge that begins there and beyond the other.
    Points3 past_;
};

/// Parameters of the forces between cloth and a surface.
struct ContactForces {
    double pressure = 0;   ///< p, N/mm²: towards the surface; negative: away from it
    double stiffness = 1;  ///< k, stiffness of the surface against penetration, N/mm³, above 0
    double load = 0;       ///< w, largest other load on the cloth, N/mm²; at least 0
};

/// Contact energy of cloth on a surface: a light pressure p towards it, and a stiff repulsion k
/// where the cloth is closer than h = 2 (|p| + w) / k,
///   W = sum_v A_v (p d + k min(d - h, 0)² / 2),
/// d the vertex's signed distance and A_v its area. Without other forces it rests p / k outside,
/// where the distance from a sharp outward edge is smooth. At a sharp inward edge the distance has
/// a crease, at which residual forces below p A_v may remain; with deeper penetration it is smooth
/// there. Only vertices are repelled: an edge of the cloth may cut a corner.
/// N, mm. Cost of the places: about log #F per vertex. Results do not depend on the threads.
class Contact {
public:
    /// @param areas  of the vertices, mm²  Keeps a reference to the surface
    Contact(const WornSurface& surface, Eigen::VectorXd areas, const ContactForces& forces,
            int threads = 1);

    void set(const ContactForces& forces);
    std::vector<WornSurface::Place> placesOf(const Points3& X) const;
    /// Places of cloth that has moved. If a distance has changed by more than its vertex has moved,
    /// the nearest point is now on another sheet of the surface, or beyond another rim: then the
    /// distance from the plane of the previous place is used, so that the energy does not jump.
    std::vector<WornSurface::Place> placesOf(const Points3& X, const Points3& before,
                                             const std::vector<WornSurface::Place>& places) const;
    double energy(const std::vector<WornSurface::Place>& places) const;
    void addGradient(const std::vector<WornSurface::Place>& places, Points3& g) const;
    /// Adds the second derivative, with only the positive part of the surface's curvature: outside
    /// about outward edges and corners, where the pressure prevails, and inside about inward ones.
    /// Beyond h it is zero along `away`, and a step there would pass through the surface: instead
    /// it adds a fraction of the stiffness with which a single vertex would come to rest.
    /// @param caution  that fraction, in [0, 1]
    void addHessian(const std::vector<WornSurface::Place>& places, double caution,
                    SpaceMatrix& H) const;

private:
    const WornSurface& surface_;
    Eigen::VectorXd areas_;
    ContactForces forces_;
    double reach_ = 0;  ///< h, mm
    int threads_;

    /// Derivative of a vertex's energy per area, N/mm².
    double slopeAt(double distance) const;
};

}  // namespace toile::sew
