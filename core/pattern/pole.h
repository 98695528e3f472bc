// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>
#include <optional>
#include <vector>

#include "core/mesh/mesh_arrays.h"

namespace toile {

/// The part of a piece on which something can still be written.
struct FreeCloth {
    /// The outline, then holes; closed, first point not repeated; either winding.
    std::vector<Points2> loops;
    /// What is drawn there already, as polylines; what lies in one that ends where it begins is
    /// taken too.
    std::vector<Points2> obstacles{};
};

/// A place, and how large the shape about it may be: the radius of a circle, or times the size of a
/// box.
struct Pole {
    Eigen::Vector2d place{0, 0};
    double room = 0;
};

struct PoleSearch {
    double tolerance = 0.01;  ///< the largest room may be greater by this share
    /// Of the places with all but this share of the largest room the one nearest to the centroid of
    /// the outline is taken, but for `nearEnough` of its extent; 0: any with the largest.
    double slack = 0;
    double nearEnough = 1e-5;
    double enough = std::numeric_limits<double>::infinity();  ///< more room is no better
    double useful = 0;  ///< where there is less room any place with the most will do
};

/// The same search, coarser on cloth of less than 200 mm: to a tenth at most. The work grows with
/// the square of the precision, and a tenth of a short label or arrow is nothing that anyone sees.
/// Cost: linear in the outline. Pure.
PoleSearch coarserIfSmall(PoleSearch search, const FreeCloth& cloth);

/// The pole of inaccessibility: the point of the free cloth that is farthest from every line.
/// Nothing where there is no cloth.
/// By halving squares, the most promising first; each keeps the lines that may be nearest to a
/// point of it. On outlines that leave hardly any room it ends with the best found so far.
/// Cost: about linear in the points for usual outlines, and bounded so for all. Pure.
std::optional<Pole> circlePole(const FreeCloth& cloth, const PoleSearch& search = {});

/// The same for a box: the middle of the largest one of these proportions that meets no line.
/// @param size   width and height at room 1, positive
/// @param angle  of its width, radians
std::optional<Pole> boxPole(const FreeCloth& cloth, const Eigen::Vector2d& size, double angle,
                            const PoleSearch& search = {});

/// As `boxPole`, but nothing where a box of this size finds no room: the search ends as soon as
/// that is known, which is soon where it is far from fitting.
std::optional<Pole> boxPlace(const FreeCloth& cloth, const Eigen::Vector2d& size, double angle,
                             const PoleSearch& search = {});

}  // namespace toile
