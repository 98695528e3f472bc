// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include <Eigen/Geometry>

#include "core/mesh/mesh_arrays.h"

namespace toile {

struct Chord {
    Eigen::Vector2d from, to;
};

/// Where a grain line goes: of several parallel lines across the outline the longest stretch on the
/// cloth that keeps off a box, shortened to leave room at its ends. Nothing where no line has room.
/// @param angle  of the line, radians
std::optional<Chord> grainLine(const std::vector<Points2>& loops, double angle,
                               const Eigen::AlignedBox2d& off);

/// The line as a pen draws it: from end to end with the two strokes of an arrow head at `to`, as
/// one open path, mm.
Points2 arrowPath(const Chord& line);

}  // namespace toile
