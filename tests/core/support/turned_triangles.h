// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/mesh_arrays.h"
#include "core/quality/measures.h"

namespace toile::test {

/// How many lie the wrong way round, or have no area at all: by the sign alone, however little of a
/// triangle is left.
inline int turnedTriangles(const Points2& Q, const Triangles& F) {
    return static_cast<int>((triangleAreas2d(Q, F).array() <= 0).count());
}

}  // namespace toile::test
