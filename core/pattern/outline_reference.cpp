// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/pattern/outline_reference.h"

#include <numbers>

#include "core/geometry/line.h"
#include "core/geometry/placement.h"
#include "core/quality/measures.h"

namespace toile {

std::vector<double> outlineArc(const Piece& piece) {
    return geometry::arcOf(boundaryLengths3d(piece.mesh.V, piece.boundary));
}

OutlineReference referenceOf(const Piece& piece, const FlatPiece& exact) {
    const Eigen::ArrayXd turn =
        std::numbers::pi - boundaryAngles3d(piece.mesh, piece.boundary).array();
    return {exact.Q(piece.boundary, Eigen::all), outlineArc(piece), {turn.begin(), turn.end()}};
}

Points2 laidOver(const Points2& points, const Points2& onto) {
    return geometry::fitMotion(points, onto).appliedToRows(points);
}

void layOver(FlatLine& line, const OutlineReference& onto) {
    const auto closed = geometry::Line::closed(line.points, line.arc);
    Points2 there(onto.points.rows(), 2);
    for (Eigen::Index k = 0; k < there.rows(); ++k) {
        there.row(k) = closed.pointAt(onto.arc[k]);
    }
    line.points = geometry::fitMotion(there, onto.points).appliedToRows(line.points);
}

}  // namespace toile
