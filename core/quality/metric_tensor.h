// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <Eigen/Core>

#include "core/garment/fabric.h"
#include "core/mesh/mesh_arrays.h"

namespace toile {

/// The first fundamental form of the map from the flat piece to the garment, in the flat piece's
/// coordinates: a short step d on the flat cloth has the length sqrt(d^T M d) on the garment. (1,
/// 0, 1) without stretch. It does not show whether a triangle is flipped.
struct MetricTensor {
    double E = 1;  ///< squared stretch along x
    double F = 0;  ///< product of the images of x and y: 0 if they stay at right angles
    double G = 1;  ///< squared stretch along y
};

/// Upper limit of stretch, so that values stay finite where the flat cloth has no extent.
inline constexpr double kLargestStretch = 1e4;

/// The tensor of a triangle without a limit: not finite if the triangle has no area in the plane or
/// a coordinate is not finite. @param Q #V x 2
MetricTensor unboundedMetric(const MeshArrays& mesh, const Points2& Q, Eigen::Index face);

/// The tensor of each triangle. Triangles without area in the plane, or with a coordinate that is
/// not finite, get the largest stretch in all directions.
/// @param Q #V x 2, the unit of the mesh. Cost: linear. Thread-safe.
std::vector<MetricTensor> faceMetrics(const MeshArrays& mesh, const Points2& Q);

/// The same, but flipped triangles also get the largest stretch in all directions: such cloth
/// cannot be worn, even if its lengths are right.
std::vector<MetricTensor> wornFaceMetrics(const MeshArrays& mesh, const Points2& Q);

/// Mean of the tensors around each vertex, weighted by 3D area: symmetric and positive as they are.
/// (1, 0, 1) if there is no area around the vertex.
/// @param faces one per triangle
std::vector<MetricTensor> vertexMetrics(const MeshArrays& mesh,
                                        const std::vector<MetricTensor>& faces);

/// Required strain of the cloth along a direction: 0.02 = stretch by 2 %.
/// @param direction unit vector in the flat piece's coordinates
double strainAlong(const MetricTensor& metric, const Eigen::Vector2d& direction);

/// The largest and the smallest stretch; their directions are at right angles both on the flat and
/// on the worn cloth.
struct PrincipalStretch {
    double largest = 1, least = 1;                         ///< ratios of lengths, worn to flat
    Eigen::Vector2d direction = Eigen::Vector2d::UnitX();  ///< of the largest, on the flat piece
};

PrincipalStretch principalStretch(const MetricTensor& metric);

/// (s1^2 + s2^2 + s1^-2 + s2^-2) / 4, the density of `symmetricDirichlet` in measures.h: 1 if
/// isometric, equal for stretching and shrinking. Limited to kLargestStretch squared.
double symmetricDirichlet(const MetricTensor& metric);

/// Cost of a warp direction for the worn cloth: the squared excess of the strain along warp, weft
/// and bias over the fabric's limits, plus a thousandth of the squared strain itself, with more
/// weight along stiff directions. Mean over the worn area, dimensionless; 0 without any area.
/// @param Q  #V x 2, the unit of the mesh  @param angle  of the warp, radians from the x axis of Q
/// Cost: linear in the triangles, 15 ms for a million. Pure, thread-safe.
double grainCost(const MeshArrays& mesh, const Points2& Q, const Fabric& fabric, double angle);

/// Areas of flat cloth, mm2.
struct StrainedArea {
    double all = 0;
    double beyond = 0;  ///< strained beyond the fabric along warp, weft or bias

    double share() const { return all > 0 ? beyond / all : 0; }
};

/// Area of a piece that exceeds its fabric's limits, counted triangle by triangle, as in the
/// window's list of problems and fabric panel. Without a stated fabric nothing exceeds limits.
/// @param angle  as for grainCost
/// Cost: linear in the triangles. Pure, thread-safe.
StrainedArea strainedArea(const MeshArrays& mesh, const Points2& Q, const Fabric& fabric,
                          double angle);

}  // namespace toile
