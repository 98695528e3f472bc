// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <Eigen/Core>

#include "core/mesh/mesh_arrays.h"

namespace toile {

/// The first fundamental form of the map from the flat piece to the garment, in the flat piece's
/// coordinates: a short step d on the flat cloth is sqrt(d^T M d) long where the cloth is worn.
/// (1, 0, 1) where nothing is stretched. Whether a triangle is flipped does not show in it.
struct MetricTensor {
    double E = 1;  ///< squared stretch along x
    double F = 0;  ///< product of the images of x and y: 0 where they stay at right angles
    double G = 1;  ///< squared stretch along y
};

/// Where the flat cloth has no extent no stretch is large enough. What is computed stays finite:
/// stretch is cut off here.
inline constexpr double kLargestStretch = 1e4;

/// The tensor of a triangle as it comes, without a bound: not finite where it has no area in the
/// plane, or a coordinate that is no number. @param Q #V x 2
MetricTensor unboundedMetric(const MeshArrays& mesh, const Points2& Q, Eigen::Index face);

/// The tensor of each triangle; of one without an area in the plane, or with a coordinate that is
/// no number, the largest stretch in all directions.
/// @param Q #V x 2, the unit of the mesh. Cost: linear. Thread-safe.
std::vector<MetricTensor> faceMetrics(const MeshArrays& mesh, const Points2& Q);

/// The same, but with the largest stretch in all directions also for a triangle that is turned
/// over: such cloth cannot be worn, however it keeps its lengths.
std::vector<MetricTensor> wornFaceMetrics(const MeshArrays& mesh, const Points2& Q);

/// At each vertex the mean of the tensors around it, weighted by 3D area: symmetric and positive as
/// they are. (1, 0, 1) where there is no area around the vertex.
/// @param faces one per triangle
std::vector<MetricTensor> vertexMetrics(const MeshArrays& mesh,
                                        const std::vector<MetricTensor>& faces);

/// What the cloth must do along a direction: 0.02 = stretch by 2 %.
/// @param direction unit vector in the flat piece's coordinates
double strainAlong(const MetricTensor& metric, const Eigen::Vector2d& direction);

/// The largest and the least stretch, at right angles to each other on the flat cloth and on the
/// worn.
struct PrincipalStretch {
    double largest = 1, least = 1;                         ///< ratios of lengths, worn to flat
    Eigen::Vector2d direction = Eigen::Vector2d::UnitX();  ///< of the largest, on the flat piece
};

PrincipalStretch principalStretch(const MetricTensor& metric);

/// (s1^2 + s2^2 + s1^-2 + s2^-2) / 4, the density of the energy by that name in measures.h: 1 where
/// isometric, alike for stretching and for shrinking. Cut off at kLargestStretch squared.
double symmetricDirichlet(const MetricTensor& metric);

}  // namespace toile
