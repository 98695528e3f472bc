// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include <Eigen/Geometry>

#include "core/pattern/pole.h"

namespace toile {

struct Chord {
    Eigen::Vector2d from, to;
};

/// Where a grain line goes: along the middle of the largest slender box in its direction that has
/// room on the free cloth, up to 300 mm long; of equals nearest to the middle of the piece. So it
/// keeps away from all lines by about a twentieth of its length. Nothing where no line has room.
/// @param angle  of the line, radians  Cost: that of boxPole. Pure.
std::optional<Chord> grainLine(const FreeCloth& cloth, double angle);

/// The line as a pen draws it: from end to end with the two strokes of an arrow head at `to`, as
/// one open path, mm.
Points2 arrowPath(const Chord& line);

}  // namespace toile
