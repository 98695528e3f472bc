// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "core/mesh/mesh_arrays.h"
#include "core/pattern/layer_kind.h"

namespace toile {

/// A line as read, mm, y up, at its position in the drawing.
struct ReadLine {
    LayerKind layer = LayerKind::Cut;
    std::string id{};  ///< from the drawing; empty if the format does not name lines
    Points2 points = Points2(0, 2);
    bool closed = false;
    /// `points` are only some points on the line; lengths are measured between these.
    bool hasKeyPoints = false;
    int stretches = 1;  ///< with key points: stretches between turn points
};

struct ReadDrawing {
    std::vector<ReadLine> lines{};
    int pieces = 0;  ///< counted by blocks, groups or outlines, depending on the format
};

}  // namespace toile
