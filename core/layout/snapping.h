// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "core/mesh/mesh_arrays.h"

namespace toile {

/// Snapping: what lies near a place that a person probably means. Pure functions; millimetres of
/// the sheet, radians, y up.

/// What a moving piece may snap to.
struct SnapTargets {
    std::vector<Eigen::AlignedBox2d> boxes;  ///< of the pieces that stay
    Points2 vertices = Points2(0, 2);        ///< of their outlines
    double gridStep = 0;                     ///< distance between grid lines; 0: no grid
};

/// A line of the sheet that something has snapped to, from one thing to the other.
struct SnapLine {
    Eigen::Vector2d from, to;
};

struct SnappedMove {
    Eigen::Vector2d way = Eigen::Vector2d::Zero();  ///< to move by instead of the way wanted
    std::vector<SnapLine> lines{};                  ///< of boxes snapped to
    std::optional<Eigen::Vector2d> vertex{};        ///< snapped to, if any
};

/// Snaps a move: a given vertex to another where two come near enough; else, for each direction
/// alone, an edge or the middle of the box to an edge or the middle of another, else an edge to the
/// grid.
/// @param box       around what moves, before the move
/// @param vertices  of what moves, likewise
/// @param way       the move that is wanted
/// @param radius     how near is near enough
/// Cost: (moving + staying vertices) log.
SnappedMove snappedMove(const Eigen::AlignedBox2d& box, const Points2& vertices,
                        const Eigen::Vector2d& way, const SnapTargets& targets, double radius);

/// Directions in [0, pi) of the straight stretches of an outline, the longest first: runs of edges
/// that turn by no more than a degree altogether and make up a twentieth of the outline.
/// @param outline  closed, first point not repeated
std::vector<double> straightDirections(const Points2& outline);

/// The vertices of an outline that a person may want to bring to others: where it turns by more
/// than 15 degrees.
Points2 snapPoints(const Points2& outline);

/// The direction in [0, pi) of the outline's edge nearest to a point; nothing without an edge.
std::optional<double> nearestEdgeDirection(const Points2& outline, const Eigen::Vector2d& point);

/// An angle, or the nearest of the whole multiples of `step` and of the `others`, taken modulo pi,
/// where that is within `radius`.
double snappedAngle(double angle, double step, std::span<const double> others, double radius);

}  // namespace toile
