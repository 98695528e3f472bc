// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/io/soup.h"

namespace toile {

/// The uv index of a face's corner at a position, or -1. Faces that use a position twice are left
/// out before, so the corner is the only one. Cost: the corners of the face.
inline int cornerUv(const PolygonSoup& soup, int face, int position) {
    if (soup.cornerUvs.empty()) {
        return -1;
    }
    for (int c = soup.faceStart[face]; c < soup.faceStart[face + 1]; ++c) {
        if (soup.corners[c] == position) {
            return soup.cornerUvs[c];
        }
    }
    return -1;
}

}  // namespace toile
