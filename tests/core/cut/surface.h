// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <utility>

#include <gtest/gtest.h>

#include "core/cut/surface_paths.h"

namespace toile::test {

/// A mesh with all that hangs on it.
struct Surface {
    MeshArrays mesh;
    EdgeTable table;
    SurfaceLinks links;

    explicit Surface(MeshArrays arrays)
        : mesh(std::move(arrays)),
          table(buildEdgeTable(mesh.F, static_cast<int>(mesh.V.rows()))),
          links(mesh, table) {}
};

/// Neighbours share a triangle, and the points measure what the path says.
inline void expectValidPath(const Surface& s, const PathPolyline& path) {
    for (std::size_t i = 1; i < path.points.size(); ++i) {
        EXPECT_GE(s.links.commonFace(path.points[i - 1], path.points[i]), 0);
    }
    EXPECT_NEAR(measuredLength(s.mesh, path), path.length, 1e-8 * (1 + path.length));
}

}  // namespace toile::test
