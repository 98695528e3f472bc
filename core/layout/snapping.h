// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "core/mesh/mesh_arrays.h"

namespace toile {

/// Snapping: finds the place near the pointer that the user probably means. Pure functions;
/// millimetres of the sheet, radians, y up.

/// Targets that a moving piece may snap to.
struct SnapTargets {
    std::vector<Eigen::AlignedBox2d> boxes;  ///< of the fixed pieces
    Points2 vertices = Points2(0, 2);        ///< of their outlines
    double gridStep = 0;                     ///< distance between grid lines; 0: no grid
};

/// A guide line of the sheet, from the moved object to its target.
struct SnapLine {
    Eigen::Vector2d from, to;
};

struct SnappedMove {
    Eigen::Vector2d way = Eigen::Vector2d::Zero();  ///< the move to use instead of the given one
    std::vector<SnapLine> lines{};                  ///< guide lines of boxes snapped to
    std::optional<Eigen::Vector2d> vertex{};        ///< snapped to, if any
};

/// Snaps a move: a vertex to a fixed one if two come close enough; else, for each direction
/// separately, an edge or the middle of the box to an edge or the middle of another, else an edge
/// to the grid.
/// @param box       around the moved pieces, before the move
/// @param vertices  of the moved pieces, before the move
/// @param way       the given move
/// @param radius    largest distance for snapping
/// Cost: (moving + staying vertices) log.
SnappedMove snappedMove(const Eigen::AlignedBox2d& box, const Points2& vertices,
                        const Eigen::Vector2d& way, const SnapTargets& targets, double radius);

/// Directions in [0, pi) of the straight stretches of an outline, longest first: runs of edges that
/// turn by at most a degree in total and are at least a twentieth of the outline.
/// @param outline  closed, first point not repeated
std::vector<double> straightDirections(const Points2& outline);

/// Vertices of an outline that are useful for snapping: those where it turns by more than 15
/// degrees.
Points2 snapPoints(const Points2& outline);

/// Direction in [0, pi) of the outline's edge nearest to a point; nothing without an edge.
std::optional<double> nearestEdgeDirection(const Points2& outline, const Eigen::Vector2d& point);

/// The angle, or the nearest of the multiples of `step` and the `others` (modulo pi) if that is
/// within `radius`.
double snappedAngle(double angle, double step, std::span<const double> others, double radius);

}  // namespace toile
