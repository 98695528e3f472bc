// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "core/base/progress.h"
#include "core/garment/piece.h"
#include "core/mesh/mesh_arrays.h"

namespace toile::symmetry {

/// Pieces of a garment as a single triangle mesh, mm; seams are not joined.
struct GarmentSurface {
    MeshArrays mesh;
    std::vector<int> pieceOfVertex;   ///< #V
    std::vector<int> pieceOfFace;     ///< #F
    Eigen::VectorXd area;             ///< #V, a third of the triangles at each vertex, mm^2
    Eigen::Vector3d centre{0, 0, 0};  ///< of the area
    Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();  ///< mean of the centred x x^T, mm^2

    /// Root mean square distance from the centre, mm: the garment's size, in any orientation.
    double radius() const;
    /// Evenly chosen vertices, at most `most`. Deterministic.
    std::vector<int> sampled(int most) const;
};

/// Precondition: finite positions.  Cost: linear. Pure.
GarmentSurface surfaceOf(const Pieces& pieces);

}  // namespace toile::symmetry

namespace toile {

/// The plane in which a garment is closest to its own mirror image: normal . x = offset.
struct MirrorPlane {
    Eigen::Vector3d normal{1, 0, 0};  ///< unit; its largest component is positive
    double offset = 0;                ///< mm
    /// Distance from the reflected vertices to the garment's surface, mm: root mean square over the
    /// area, and the largest. Draped cloth is not symmetric: 5 to 20 mm are usual.
    double deviation = 0;
    double farthest = 0;

    Eigen::Vector3d reflected(const Eigen::Vector3d& p) const {
        return p - 2 * (normal.dot(p) - offset) * normal;
    }
};

/// A garment has no mirror plane if its deviation exceeds this fraction of its size (root mean
/// square distance from its centre). Draped garments have 0.01 to 0.05.
inline constexpr double kMaxMirrorDeviation = 0.06;
/// The root mean square distance from the plane must be at least this fraction of that size, so
/// that the garment does not lie in the plane.
inline constexpr double kMinMirrorWidth = 0.1;

/// Alternates two steps: reflect the vertices and pair them with the nearest points of the surface;
/// take the plane that fits the pairs (x, x') best in the least-squares sense. Its normal is the
/// eigenvector of the smallest eigenvalue of sum w (x x'^T + x' x^T), about the means. The weights
/// w are the vertices' areas, so that the triangulation matters little; pairs farther apart than
/// three medians are left out. It starts from the area's principal axes, and from the coordinate
/// axes that differ, because a round garment has no principal axes; the least deviation wins. At
/// most 40 rounds from each, and 40 more from the best.
/// None if even the least deviation is too large (`kMaxMirrorDeviation`), if the garment is a line
/// (`kMinMirrorWidth`), or without any area.
/// Depends only on these pieces; moves, turns and reflects with them. For large garments a
/// selection of vertices is used, 500 for the choice and 1500 for the plane.
/// @param pieces    as divided (`Garment::uncut`): cuts and seams do not count
/// @param progress  polled for each vertex; nothing after a cancel
/// Precondition: finite positions. Deterministic.
/// Cost: 40 rounds, with a search of O(log #F) for each vertex: a second, or two to three for a
/// hundred thousand vertices.  Pure.
std::optional<MirrorPlane> findMirrorPlane(const Pieces& pieces, const Progress& progress = {});

}  // namespace toile
