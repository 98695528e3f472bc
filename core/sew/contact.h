// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/cut/surface_point.h"
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
    /// the same way and share their vertices.
    explicit WornSurface(MeshArrays mesh);
    WornSurface(const WornSurface&) = delete;
    WornSurface& operator=(const WornSurface&) = delete;

    struct Place {
        double distance;       ///< signed, mm
        Eigen::Vector3d away;  ///< unit vector along which it grows
        Eigen::Matrix3d bend;  ///< how that turns: the distance's second derivative, 1/mm
    };

    Place placeOf(const Eigen::Vector3d& p) const;
    /// From the surface itself, past a rim too: 0 or more, mm.
    double distanceTo(const Eigen::Vector3d& p) const;
    const MeshArrays& mesh() const { return mesh_; }

private:
    const MeshArrays mesh_;
    NearestSurface nearest_;
    Triangles faceEdges_;
    Points3 faceNormals_, edgeNormals_, vertexNormals_;
    std::vector<char> isRimEdge_, isRimVertex_;
    /// Per vertex of the rim two directions, past the edge that begins there and past the other.
    Points3 past_;
};

/// How cloth lies on a surface: a light pressure p towards it, and a stiff one k away from it where
/// it is nearer than h = 2 p / k,
///   W = sum_v A_v (p d + k min(d - h, 0)² / 2),
/// d the vertex's signed distance and A_v its share of the cloth. Where nothing else pulls it rests
/// p / k outside: there the distance from a sharp outward edge is smooth, inside it has a crease at
/// which no force vanishes. Vertices alone are held off: an edge of the cloth may cut a corner.
/// N, mm.
class Contact {
public:
    /// @param areas  of the vertices, mm²  @param pressure  p, N/mm²; 0: cloth that hangs free is
    /// drawn to nothing  @param stiffness  k, N/mm³, above 0  Keeps a reference to the surface
    Contact(const WornSurface& surface, Eigen::VectorXd areas, double pressure, double stiffness);

    std::vector<WornSurface::Place> placesOf(const Points3& X) const;
    double energy(const std::vector<WornSurface::Place>& places) const;
    void addGradient(const std::vector<WornSurface::Place>& places, Points3& g) const;
    /// The second derivative; of the surface's own curvature what is left of it about outward edges
    /// and corners, where the pressure prevails. Further than h it is zero along `away`, and there
    /// a step would be one through the surface: instead a part of the stiffness with which a vertex
    /// would come down to where it rests alone.
    /// @param caution  that part, in [0, 1]
    void addHessian(const std::vector<WornSurface::Place>& places, double caution,
                    SpaceMatrix& H) const;

private:
    const WornSurface& surface_;
    Eigen::VectorXd areas_;
    double pressure_, stiffness_, reach_;  ///< p, k, h

    /// Of a vertex's energy per area, N/mm².
    double slopeAt(double distance) const;
};

}  // namespace toile::sew
