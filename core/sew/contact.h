// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/cut/surface_point.h"
#include "core/geometry/triangle_tree.h"
#include "core/mesh/mesh_arrays.h"
#include "core/sew/space_matrix.h"

namespace toile::sew {

/// The surface that cloth is put over: the design, or a body. Signed distances by the nearest point
/// and the angle-weighted normal there ([BA05]): above 0 on the side from which triangles run
/// anti-clockwise. Past a rim the distance is that from the plane that goes on from it, so that
/// cloth that reaches further than the surface neither falls round its edge nor sticks to it; past
/// a corner of the rim what leads past its two edges does not count.
/// Immutable; thread-safe. One question costs about log #F.
class WornSurface {
public:
    /// Precondition: at least one face with an area, finite positions; neighbouring triangles run
    /// the same way and share their vertices. A face without area takes its direction from those
    /// about it.
    explicit WornSurface(MeshArrays mesh);
    WornSurface(const WornSurface&) = delete;
    WornSurface& operator=(const WornSurface&) = delete;

    struct Place {
        double distance;       ///< signed, mm
        Eigen::Vector3d away;  ///< unit vector along which it grows
        Eigen::Matrix3d bend;  ///< how that turns: the distance's second derivative, 1/mm
        int face;              ///< that the nearest point is on
    };

    /// @param near  a face not far from the point, if one is known: it is found sooner, and is the
    /// same
    Place placeOf(const Eigen::Vector3d& p, int near = -1) const;
    /// From the surface itself, past a rim too: 0 or more, mm.
    double distanceTo(const Eigen::Vector3d& p) const;
    const MeshArrays& mesh() const { return mesh_; }

private:
    const MeshArrays mesh_;
    geometry::TriangleTree<3, double> tree_;
    Triangles faceEdges_;
    Points3 faceNormals_, edgeNormals_, vertexNormals_;
    std::vector<char> isRimEdge_, isRimVertex_;
    /// Per vertex of the rim two directions, past the edge that begins there and past the other.
    Points3 past_;
};

/// What pushes cloth and a surface together or apart.
struct ContactForces {
    double pressure = 0;   ///< p, N/mm²: towards the surface; below 0: away from it
    double stiffness = 1;  ///< k of the surface against what is in it, N/mm³, above 0
    double load = 0;       ///< w, what else may weigh on the cloth, N/mm²; at least 0
};

/// How cloth lies on a surface: a light pressure p towards it, and a stiff one k away from it where
/// it is nearer than h = 2 (|p| + w) / k,
///   W = sum_v A_v (p d + k min(d - h, 0)² / 2),
/// d the vertex's signed distance and A_v its share of the cloth. Where nothing else pulls it rests
/// p / k outside: there the distance from a sharp outward edge is smooth; from a sharp inward one
/// it has a crease, at which forces below p A_v may be left. Pressed in further it is smooth about
/// that. Vertices alone are held off: an edge of the cloth may cut a corner.
/// N, mm. Costs of the places: about log #F a vertex. The same bytes for any number of threads.
class Contact {
public:
    /// @param areas  of the vertices, mm²  Keeps a reference to the surface
    Contact(const WornSurface& surface, Eigen::VectorXd areas, const ContactForces& forces,
            int threads = 1);

    void set(const ContactForces& forces);
    std::vector<WornSurface::Place> placesOf(const Points3& X) const;
    /// Of cloth that has moved. Where a distance has changed by more than its vertex has moved, the
    /// nearest point is on another sheet of the surface now, or past another rim: there it is that
    /// from the plane of the place before, so that the energy does not jump.
    std::vector<WornSurface::Place> placesOf(const Points3& X, const Points3& before,
                                             const std::vector<WornSurface::Place>& places) const;
    double energy(const std::vector<WornSurface::Place>& places) const;
    void addGradient(const std::vector<WornSurface::Place>& places, Points3& g) const;
    /// The second derivative; of the surface's own curvature what is positive: outside about
    /// outward edges and corners, where the pressure prevails, and inside about inward ones.
    /// Further than h it is zero along `away`, and there a step would be one through the surface:
    /// instead a part of the stiffness with which a vertex would come down to where it rests alone.
    /// @param caution  that part, in [0, 1]
    void addHessian(const std::vector<WornSurface::Place>& places, double caution,
                    SpaceMatrix& H) const;

private:
    const WornSurface& surface_;
    Eigen::VectorXd areas_;
    ContactForces forces_;
    double reach_ = 0;  ///< h, mm
    int threads_;

    /// Of a vertex's energy per area, N/mm².
    double slopeAt(double distance) const;
};

}  // namespace toile::sew
