// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/reading/pattern_file.h"

namespace toile {

/// Open lines that lie end to end, as one each: a chain that comes back to its start, or has
/// `gap` to it at most, is closed. Closed ones stay as they are; points that repeat the one before
/// are left out. In the order of the first line of each.
/// @param near  how far apart ends may be that are one, positive
/// Cost: about n log n. Pure.
std::vector<FileLine> joinedLines(const std::vector<FileLine>& lines, double near, double gap);

/// The mirror image of points across a line through two points that differ.
Points2 mirroredAcross(const Points2& points, const FileChord& line);

/// The whole of which a closed line is one half: its longest straight run along the mirror line
/// falls away, and the other half is added. The line as it is where none of it lies there, or where
/// it lies on both sides.
/// @param near  how far from the mirror line a point may be that lies on it
struct Unfolded {
    Points2 line = Points2(0, 2);
    bool isWhole = false;  ///< it was a half, and is whole now
};
Unfolded unfolded(const Points2& closed, const FileChord& mirror, double near);

}  // namespace toile
