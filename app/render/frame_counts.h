// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

namespace toile {

/// What the frames of one renderer have asked of the graphics driver so far. Writing over the view
/// is not in it.
struct FrameCounts {
    int drawCalls = 0;
    std::size_t uploadedBytes = 0;  ///< to buffers and textures
};

}  // namespace toile
