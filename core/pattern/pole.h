// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>
#include <optional>
#include <vector>

#include "core/mesh/mesh_arrays.h"

namespace toile {

/// The part of a piece that is free for texts and marks.
struct FreeCloth {
    /// The outline, then holes; closed, first point not repeated; either winding.
    std::vector<Points2> loops;
    /// Lines already drawn there, as polylines; a closed one (last point equals the first) also
    /// blocks its inside.
    std::vector<Points2> obstacles{};
};

/// A place and the size of the largest shape around it: the radius of a circle, or the scale factor
/// of a box.
struct Pole {
    Eigen::Vector2d place{0, 0};
    double room = 0;
};

struct PoleSearch {
    double tolerance = 0.01;  ///< the largest room may be greater by this share
    /// Among places with at least the largest room less this share, take the one nearest to the
    /// centroid of the outline, to within `nearEnough` of its extent; 0: any with the largest.
    double slack = 0;
    double nearEnough = 1e-5;
    double enough = std::numeric_limits<double>::infinity();  ///< more room is not needed
    double useful = 0;  ///< below this any place with the largest room will do
};

/// The same search, coarser on cloth of less than 200 mm: to a tenth at most. The work grows with
/// the square of the precision, and a tenth of a short label or arrow is not visible.
/// Cost: linear in the outline. Pure.
PoleSearch coarserIfSmall(PoleSearch search, const FreeCloth& cloth);

/// The pole of inaccessibility: the point of the free cloth farthest from every line. Nothing if
/// there is no cloth.
/// Method: halves squares, the most promising first; each keeps the lines that may be nearest to
/// one of its points. If outlines leave hardly any room, it ends with the best found so far.
/// Cost: about linear in the points for usual outlines, and bounded for all. Pure.
std::optional<Pole> circlePole(const FreeCloth& cloth, const PoleSearch& search = {});

/// The same for a box: the middle of the largest box of these proportions that meets no line.
/// @param size   width and height at room 1, positive
/// @param angle  of its width, radians
std::optional<Pole> boxPole(const FreeCloth& cloth, const Eigen::Vector2d& size, double angle,
                            const PoleSearch& search = {});

/// Like `boxPole`, but nothing if a box of this size does not fit: the search stops once that is
/// certain, which is early if it is far from fitting.
std::optional<Pole> boxPlace(const FreeCloth& cloth, const Eigen::Vector2d& size, double angle,
                             const PoleSearch& search = {});

}  // namespace toile
