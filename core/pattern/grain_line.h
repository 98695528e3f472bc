// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include <Eigen/Geometry>

#include "core/pattern/pole.h"

namespace toile {

struct Chord {
    Eigen::Vector2d from, to;
};

/// Position of a grain line: along the middle of the largest slender box in its direction that fits
/// in the free cloth, up to 300 mm long; of equal boxes the one nearest to the middle of the piece.
/// It keeps a distance of about a twentieth of its length from all lines. Nothing if no line fits.
/// @param angle  of the line, radians  Cost: that of boxPole. Pure.
std::optional<Chord> grainLine(const FreeCloth& cloth, double angle);

/// The line with the two strokes of an arrow head at `to`, as a single open path for a pen, mm.
Points2 arrowPath(const Chord& line);

}  // namespace toile
