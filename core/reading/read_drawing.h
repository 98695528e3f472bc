// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "core/mesh/mesh_arrays.h"
#include "core/pattern/layer_kind.h"

namespace toile {

/// A line as a reader found it, mm, y up, where the drawing has it.
struct ReadLine {
    LayerKind layer = LayerKind::Cut;
    std::string id{};  ///< of the drawing; empty where the format names no lines
    Points2 points = Points2(0, 2);
    bool closed = false;
    /// Only some points of the line, which are on it; lengths are those of these.
    bool hasKeyPoints = false;
    int stretches = 1;  ///< of one with key points: from one turn point to the next
};

struct ReadDrawing {
    std::vector<ReadLine> lines{};
    int pieces = 0;  ///< by blocks, groups or outlines, as the format has them
};

}  // namespace toile
