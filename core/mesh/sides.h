// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/mesh_arrays.h"

namespace toile {

/// The sides of triangles: side 3 * f + k runs from corner k of face f to the next.

inline int nextSide(int side) {
    return side % 3 == 2 ? side - 2 : side + 1;
}

inline int previousSide(int side) {
    return side % 3 == 0 ? side + 2 : side - 1;
}

inline int tailOf(const Triangles& F, int side) {
    return F.data()[side];
}

inline int headOf(const Triangles& F, int side) {
    return F.data()[nextSide(side)];
}

inline int apexOf(const Triangles& F, int side) {
    return F.data()[previousSide(side)];
}

}  // namespace toile
