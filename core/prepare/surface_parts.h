// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/prepare/file_surface.h"

namespace toile {

/// Removes faces that coincide with others, like those of double-sided meshes. Cost: n log n. Pure.
FileSurface withoutDoubles(const FileSurface& file);

/// The parts of a surface connected by vertices.
struct SurfaceParts {
    std::vector<int> of;         ///< per triangle, numbered by first triangle
    std::vector<double> area{};  ///< per part, mm2
    std::vector<char> isClosed{};
    double total = 0;  ///< mm2

    /// Share of the area in closed parts.
    double closedShare() const;
};

/// @param mesh  mm  Cost: n log n. Pure.
SurfaceParts partsOf(const MeshArrays& mesh);

}  // namespace toile
