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

/// Weights that differ by no more are equal: of large triangles some nanometres.
inline constexpr double kSameWeight = 1e-6;

/// The part of a straight line that lies in a triangle.
struct FaceSpan {
    int face = -1;
    double from = 0, to = 1;     ///< shares of the line
    Eigen::Vector3d start, end;  ///< weights in the triangle, of the whole line's ends

    SurfacePoint at(double share) const;
};

/// @param start  @param end  weights of the line's ends in the plane of the triangle
/// @return none where the line passes it, or only touches it
std::optional<FaceSpan> spanIn(int face, const Eigen::Vector3d& start, const Eigen::Vector3d& end);

/// The parts of a line in a flat piece.
/// @param Q  of the vertices, #V x 2  Cost: linear in the faces. Pure.
std::vector<FaceSpan> flatSpans(const Points2& Q, const Triangles& F, const Eigen::RowVector2d& a,
                                const Eigen::RowVector2d& b);

/// Weights of a point of space in the plane of a triangle.
/// @return none where it is farther from that plane than `reach`, or the triangle has no area
std::optional<Eigen::Vector3d> weightsIn(const MeshArrays& mesh, int face,
                                         const Eigen::Vector3d& point, double reach);

/// True where both are one point of the surface: at the same place of the same edge, or in one
/// triangle. The two sides of a cut, which lie on each other in space, are two places.
bool isOnePlace(const Triangles& F, const SurfacePoint& a, const SurfacePoint& b);

/// The way from a to b straight in the flat piece: points where it enters another triangle.
/// None where it leaves the cloth, or would cross a cut.
/// Cost: linear in the faces, and the square of those it crosses. Pure.
std::optional<std::vector<SurfacePoint>> straightWay(const Points2& Q, const Triangles& F,
                                                     const SurfacePoint& a, const SurfacePoint& b);

}  // namespace toile
