// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/cut/surface_point.h"
#include "core/geometry/triangle_tree.h"
#include "core/mesh/mesh_arrays.h"

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

}  // namespace toile::sew
