// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/prepare/file_surface.h"

namespace toile {

/// Without the faces that lie on others, as those of meshes that are to be seen from both sides.
/// Cost: n log n. Pure.
FileSurface withoutDoubles(const FileSurface& file);

/// What of a surface hangs together by vertices.
struct SurfaceParts {
    std::vector<int> of;         ///< per triangle, numbered by first triangle
    std::vector<double> area{};  ///< per part, mm2
    std::vector<char> isClosed{};
    double total = 0;  ///< mm2

    /// Of the area, what belongs to closed parts.
    double closedShare() const;
};

/// @param mesh  mm  Cost: n log n. Pure.
SurfaceParts partsOf(const MeshArrays& mesh);

}  // namespace toile
