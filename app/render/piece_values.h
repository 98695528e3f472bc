// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <Eigen/Core>

#include "core/garment/garment.h"
#include "core/garment/piece.h"
#include "core/quality/metric_tensor.h"

namespace toile::app {

/// Distortion of vertices or triangles in the units a person reads: area change in percent, angle
/// change in degrees, strain in percent; strain is that of edges, the largest and the least, kept
/// apart so that stretch one way and surplus another do not cancel. Positive is what the cloth must
/// gain to be worn, A3D/A2D - 1 for areas; an area below -100 % is of a triangle that is turned
/// over. Always finite: the infinite is clamped to +-kLargestValue.
struct OverlayFields {
    Eigen::VectorXf area, angle, mostStrain, leastStrain;
    std::vector<MetricTensor> metric;
};

inline constexpr double kLargestValue = 1e6;

/// Of the triangles as they are, and at the vertices smoothed: the mean of the triangles around,
/// weighted by their 3D area. The metric is that of `wornFaceMetrics`.
struct PieceValues {
    OverlayFields vertices, faces;
    Eigen::VectorXf flatAreas;  ///< of the triangles, positive, mm2
};

PieceValues pieceValues(const Piece& piece, const Points2& Q);

/// Unit normals, faces weighted by area; (0, 0, 1) where a vertex has no area around it.
Points3 vertexNormals(const MeshArrays& mesh);

/// The least turn at a corner of an outline, radians: 40 degrees. A curve, drawn by short edges,
/// turns by less at each.
inline constexpr double kCornerTurn = 0.6981317007977318;

/// Where the outline turns sharply, measured in the cloth: places in Piece::boundary, ascending.
/// Cost: linear in the faces. Pure.
std::vector<int> outlineCorners(const Piece& piece);

/// A stretch of an outline: edge k runs from boundary[k] to boundary[k + 1].
struct OutlineRun {
    int first = 0;
    int count = 0;  ///< of edges; the last may be past the outline's beginning
};

/// From corner to corner around an edge of the outline; all of it where there are fewer than two
/// corners. Precondition: 0 <= edge < size.
OutlineRun runBetweenCorners(const std::vector<int>& corners, int size, int edge);

}  // namespace toile::app
