// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <Eigen/Core>

#include "core/garment/garment.h"
#include "core/garment/piece.h"
#include "core/quality/metric_tensor.h"

namespace toile::app {

/// Distortion of vertices or triangles in displayed units: area change in percent, angle change in
/// degrees, edge strain in percent. Largest and smallest strain are kept apart, so that stretch and
/// surplus in different directions do not cancel. Positive means that the cloth must grow to be
/// worn, A3D/A2D - 1 for areas. Below -100 % a triangle is flipped. Always finite: clamped to
/// +-kLargestValue.
struct OverlayFields {
    Eigen::VectorXf area, angle, mostStrain, leastStrain;
    std::vector<MetricTensor> metric;
};

inline constexpr double kLargestValue = 1e6;

/// Values of the triangles, and smoothed values of the vertices: the mean of the surrounding
/// triangles weighted by 3D area. The metric comes from `wornFaceMetrics`.
struct PieceValues {
    OverlayFields vertices, faces;
    Eigen::VectorXf flatAreas;  ///< of the triangles, positive, mm2
};

PieceValues pieceValues(const Piece& piece, const Points2& Q);

/// Unit normals, weighted by face area; (0, 0, 1) for a vertex without area around it.
Points3 vertexNormals(const MeshArrays& mesh);

/// Smallest turn at a corner of an outline, radians: 40 degrees. The short edges of a curve turn by
/// less.
inline constexpr double kCornerTurn = 0.6981317007977318;

/// Places in Piece::boundary where the outline turns sharply, measured in the cloth, ascending.
/// Cost: linear in the faces. Pure.
std::vector<int> outlineCorners(const Piece& piece);

/// A stretch of an outline: edge k runs from boundary[k] to boundary[k + 1].
struct OutlineRun {
    int first = 0;
    int count = 0;  ///< number of edges; the run may wrap past the outline's start
};

/// The run between the corners around an edge; the whole outline if it has fewer than two corners.
/// Precondition: 0 <= edge < size.
OutlineRun runBetweenCorners(const std::vector<int>& corners, int size, int edge);

}  // namespace toile::app
