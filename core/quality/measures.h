// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>

#include "core/mesh/mesh_arrays.h"

namespace toile {

/// Measures of a flattening: pure functions of the 3D mesh and its planar points Q (#V x 2), the
/// same unit on both sides. [Wang05] eq. (1), (2), (24), (25). Angles in radians. All are linear in
/// the mesh, except the outline crossings (about n log n).

/// Inner angle of each boundary vertex in 3D: the sum of its triangle angles ("alpha").
Eigen::VectorXd boundaryAngles3d(const MeshArrays& mesh, const std::vector<int>& boundary);
/// Sum of the triangle angles at each vertex in 3D; 0 without triangles. Avoids an arc tangent per
/// corner: a fifth of the time of `cornerAngles3d`.
Eigen::VectorXd vertexAngles3d(const MeshArrays& mesh);
/// Inner angle of each vertex of a planar loop, in [0, 2 pi) ("theta").
Eigen::VectorXd boundaryAngles2d(const Points2& Q, const std::vector<int>& boundary);
/// Length of each boundary edge (from loop vertex i to i+1), in 3D and in the plane.
Eigen::VectorXd boundaryLengths3d(const Points3& V, const std::vector<int>& boundary);
Eigen::VectorXd boundaryLengths2d(const Points2& Q, const std::vector<int>& boundary);
/// Length of each edge, in 3D and in the plane.
Eigen::VectorXd edgeLengths3d(const Points3& V, const Edges& edges);
Eigen::VectorXd edgeLengths2d(const Points2& Q, const Edges& edges);
/// Area of each triangle: in 3D, and signed in the plane (positive: anti-clockwise).
Eigen::VectorXd triangleAreas3d(const MeshArrays& mesh);
Eigen::VectorXd triangleAreas2d(const Points2& Q, const Triangles& F);
/// Corner angles of each triangle, #F x 3.
Eigen::MatrixX3d cornerAngles3d(const MeshArrays& mesh);
Eigen::MatrixX3d cornerAngles2d(const Points2& Q, const Triangles& F);

/// Singular values s1 >= s2 >= 0 of each triangle's 3D-to-plane map, #F x 2.
Eigen::MatrixX2d singularValues(const MeshArrays& mesh, const Points2& Q);

/// Mean |l0 - l| over matching edges, in their unit. Eq. (1).
double piL(const Eigen::VectorXd& lengths3d, const Eigen::VectorXd& lengths2d);
/// Mean |theta - alpha| over boundary vertices, differences taken modulo 2 pi: at the tip of a slit
/// the planar angle is 0 or 2 pi, depending on rounding. Eq. (2).
double piTheta(const Eigen::VectorXd& alpha, const Eigen::VectorXd& theta);
/// 1/2 sum (theta - alpha)^2, differences likewise. The objective of eq. (9).
double angleEnergy(const Eigen::VectorXd& alpha, const Eigen::VectorXd& theta);
/// Sum over edges of | |q|/sum|q| - |v|/sum|v| |, in [0, 2]. Eq. (24), normalised.
double piE(const Eigen::VectorXd& lengths3d, const Eigen::VectorXd& lengths2d);
/// Sum over triangles of | A/sum A - A'/sum A' | with unsigned areas, in [0, 2]. Eq. (25).
double piA(const Eigen::VectorXd& areas3d, const Eigen::VectorXd& areas2d);
/// Largest |l/l0 - 1|.
double maxRelativeLengthError(const Eigen::VectorXd& lengths3d, const Eigen::VectorXd& lengths2d);

/// Mean of (s1^2 + s2^2 + s1^-2 + s2^-2) / 4 weighted by 3D area: 1 if isometric. Nothing if a
/// triangle is flipped or collapsed: the energy is infinite there.
std::optional<double> symmetricDirichlet(const Eigen::MatrixX2d& singular,
                                         const Eigen::VectorXd& areas3d,
                                         const Eigen::VectorXd& areas2d);

/// s1/s2 over the triangles: mean weighted by 3D area, and largest; nothing if any s2 = 0.
struct QuasiConformal {
    std::optional<double> mean, max;
};

QuasiConformal quasiConformal(const Eigen::MatrixX2d& singular, const Eigen::VectorXd& areas3d);

/// Fabric strain of each edge: L3D/L2D - 1, how much the cloth must stretch to take the 3D shape
/// (0.02 = must stretch by 2 %). Infinite if the flat edge has no length.
Eigen::VectorXd edgeStrain(const Eigen::VectorXd& lengths3d, const Eigen::VectorXd& lengths2d);

/// A triangle that keeps at most this share of its area has collapsed, even if the area is positive
/// by rounding.
inline constexpr double kCollapsedShare = 1e-6;
/// Number of triangles that are flipped or have collapsed: the measure of a failed pattern.
int flippedTriangles(const Eigen::VectorXd& areas2d, const Eigen::VectorXd& areas3d);
/// The triangle with the most negative area; any triangle without flipped ones.
Eigen::Index worstFlipped(const Eigen::VectorXd& areas2d, const Eigen::VectorXd& areas3d);
/// Pairs of non-adjacent outline edges that cross each other, up to a limit of a million. Edges
/// that touch or coincide within rounding (1e-12 of the outline's extent), as the two sides of a
/// slit do, do not cross. For the places of crossings see outline_crossings.h.
int outlineCrossings(const Points2& Q, const std::vector<int>& boundary);

}  // namespace toile
