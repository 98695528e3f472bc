// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/pattern/outline_reference.h"

#include <cmath>
#include <numbers>

#include <Eigen/Geometry>

#include "core/geometry/line.h"
#include "core/geometry/segment.h"
#include "core/quality/measures.h"

namespace toile {
namespace {

/// Moves points as the rigid motion moves others that brings them nearest to a third set.
Points2 movedAs(const Points2& points, const Points2& others, const Points2& onto) {
    const Eigen::RowVector2d from = others.colwise().mean(), to = onto.colwise().mean();
    double along = 0, across = 0;
    for (Eigen::Index i = 0; i < others.rows(); ++i) {
        const Eigen::RowVector2d a = others.row(i) - from, b = onto.row(i) - to;
        along += a.dot(b);
        across += geometry::cross(a, b);
    }
    const Eigen::Rotation2Dd turn(std::atan2(across, along));
    Points2 moved(points.rows(), 2);
    for (Eigen::Index i = 0; i < points.rows(); ++i) {
        moved.row(i) = to + (turn * (points.row(i) - from).transpose()).transpose();
    }
    return moved;
}

}  // namespace

std::vector<double> outlineArc(const Piece& piece) {
    return geometry::arcOf(boundaryLengths3d(piece.mesh.V, piece.boundary));
}

OutlineReference referenceOf(const Piece& piece, const FlatPiece& exact) {
    const Eigen::ArrayXd turn =
        std::numbers::pi - boundaryAngles3d(piece.mesh, piece.boundary).array();
    return {exact.Q(piece.boundary, Eigen::all), outlineArc(piece), {turn.begin(), turn.end()}};
}

Points2 laidOver(const Points2& points, const Points2& onto) {
    return movedAs(points, points, onto);
}

void layOver(FlatLine& line, const OutlineReference& onto) {
    const auto closed = geometry::Line::closed(line.points, line.arc);
    Points2 there(onto.points.rows(), 2);
    for (Eigen::Index k = 0; k < there.rows(); ++k) {
        there.row(k) = closed.pointAt(onto.arc[k]);
    }
    line.points = movedAs(line.points, there, onto.points);
}

}  // namespace toile
