// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "core/cut/surface_point.h"
#include "core/mesh/mesh_arrays.h"

namespace toile {

/// Straight lines over triangles, in the plane or in space.

/// Weights closer than this are equal: some nanometres in large triangles.
inline constexpr double kSameWeight = 1e-6;

/// The part of a straight line that lies in a triangle.
struct FaceSpan {
    int face = -1;
    double from = 0, to = 1;     ///< shares of the line
    Eigen::Vector3d start, end;  ///< barycentric, of the whole line's ends

    SurfacePoint at(double share) const;
};

/// @param start  @param end  barycentric weights of the line's ends in the triangle's plane
/// @return nothing if the line passes the triangle, or only touches it
std::optional<FaceSpan> spanIn(int face, const Eigen::Vector3d& start, const Eigen::Vector3d& end);

/// The parts of a line in a flat piece.
/// @param Q  vertices, #V x 2  Cost: linear in the faces. Pure.
std::vector<FaceSpan> flatSpans(const Points2& Q, const Triangles& F, const Eigen::RowVector2d& a,
                                const Eigen::RowVector2d& b);

/// Barycentric weights of a point in space, projected to the plane of a triangle.
/// @return nothing if it is farther from that plane than `reach`, or the triangle has no area
std::optional<Eigen::Vector3d> weightsIn(const MeshArrays& mesh, int face,
                                         const Eigen::Vector3d& point, double reach);

/// True if both are one point of the surface: at the same place of the same edge, or in one
/// triangle. The two sides of a cut, which coincide in space, are two places.
bool isOnePlace(const Triangles& F, const SurfacePoint& a, const SurfacePoint& b);

/// The straight path from a to b in the flat piece: points where it enters another triangle.
/// Nothing if it leaves the cloth, or would cross a cut.
/// Cost: linear in the faces, quadratic in those it crosses. Pure.
std::optional<std::vector<SurfacePoint>> straightWay(const Points2& Q, const Triangles& F,
                                                     const SurfacePoint& a, const SurfacePoint& b);

}  // namespace toile
