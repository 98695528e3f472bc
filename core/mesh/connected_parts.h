// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/mesh/repair_part.h"

namespace toile {

/// A part that hangs together, and where its vertices were before.
struct ConnectedPart {
    MeshPart part;
    std::vector<int> vertex;  ///< per vertex: its index in the mesh that was taken apart
};

/// Takes a part to pieces where it does not hang together by shared vertices, in order of first
/// face. Vertices and faces keep their order; vertices without a face go, unless it was one piece
/// all along: then it comes back untouched. Linear.
std::vector<ConnectedPart> connectedParts(MeshPart part);

}  // namespace toile
