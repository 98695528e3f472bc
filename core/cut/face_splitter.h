// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/cut/face_parts.h"

namespace toile {

/// Makes curves into edges of the parts of triangles. Decides on a reference triangle of equal
/// sides, so that the shape of the source does not matter and parts never overlap.
class FaceSplitter {
public:
    /// @param snap  see CutOptions
    FaceSplitter(FaceParts& parts, double snap) : parts_(parts), snap_(snap) {}

    /// The vertex at a point, new if none is near. It touches all triangles that the point touches.
    int insert(const SurfacePoint& point);

    /// Makes edges from vertex `from` to vertex `to`, straight across the source triangle `face`
    /// that both touch. Appends the vertices passed to `path`, `to` included. False where the walk
    /// does not arrive, which would be a bug.
    bool connect(int face, int from, int to, std::vector<int>& path);

private:
    int step(int face, int from, int to);

    FaceParts& parts_;
    double snap_;
};

}  // namespace toile
