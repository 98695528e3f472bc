// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include "core/garment/garment.h"

namespace toile {

/// Distortion at the vertices in the units a person reads: area change in percent, angle change in
/// degrees, strain in percent. Always finite: the infinite is clamped to +-kLargestValue.
struct VertexValues {
    Eigen::VectorXf area, angle, strain;
};

inline constexpr double kLargestValue = 1e6;

/// Faces' values weighted by their 3D area, edges' by their 3D length.
VertexValues vertexValues(const Piece& piece, const Points2& Q);

/// Unit normals, faces weighted by area; (0, 0, 1) where a vertex has no area around it.
Points3 vertexNormals(const MeshArrays& mesh);

}  // namespace toile
