// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/geometry/disjoint_sets.h"
#include "core/mesh/repair_steps.h"

namespace toile {

void separateFans(MeshPart& part, const Gluing& gluing, RepairNotes& notes) {
    const Triangles& F = part.mesh.F;
    const int cornerCount = static_cast<int>(F.size());
    DisjointSets fans(cornerCount);  // a side's index is the corner at its tail
    for (int side = 0; side < cornerCount; ++side) {
        const int twin = gluing.twin[side];
        if (twin > side) {
            const bool opposed = tailOf(F, side) == tailOf(F, twin);
            fans.join(side, opposed ? twin : nextSide(twin));
            fans.join(nextSide(side), opposed ? nextSide(twin) : twin);
        }
    }
    const int vertexCount = static_cast<int>(part.mesh.V.rows());
    std::vector<int> firstFan(vertexCount, -1);
    std::vector<char> isNoted(gluing.cutAtVertex);
    std::vector<int> ofFan(cornerCount, -1);  // at a fan's least corner: its vertex
    std::vector<int> copies;
    for (int corner = 0; corner < cornerCount; ++corner) {
        const int v = F.data()[corner];
        if (fans.root(corner) != corner) {
            continue;
        }
        if (firstFan[v] < 0) {
            firstFan[v] = corner;
            ofFan[corner] = v;
            continue;
        }
        ofFan[corner] = vertexCount + static_cast<int>(copies.size());
        copies.push_back(v);
        if (isNoted[v] == 0) {  // the ends of edges cut apart are part of that note
            isNoted[v] = 1;
            notes.add(ErrorCode::VerticesSplit, "vertex", translatable("split"),
                      part.mesh.V.row(v));
        }
    }
    if (copies.empty()) {
        return;
    }
    for (int corner = 0; corner < cornerCount; ++corner) {
        part.mesh.F.data()[corner] = ofFan[fans.root(corner)];
    }
    appendCopies(part, copies);
}

}  // namespace toile
