// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/prove/our_loops.h"

#include "core/geometry/arc_lengths.h"
#include "core/quality/measures.h"

namespace toile::prove {
std::vector<OurLoop> ourLoops(const Piece& piece, const Points2& flat, const FlatLine* line) {
    std::vector<OurLoop> loops;
    const Points3& V = piece.mesh.V;
    const auto add = [&](const std::vector<int>& loop, const FlatLine* drawn) {
        const Points3 space = V(loop, Eigen::all);
        loops.push_back({space, drawn != nullptr
                                    ? ClosedLine(drawn->points, drawn->arc)
                                    : ClosedLine(flat(loop, Eigen::all),
                                                 geometry::arcOf(boundaryLengths3d(V, loop)))});
    };
    add(piece.boundary, line);
    for (const std::vector<int>& hole : piece.holes) {
        add(hole, nullptr);
    }
    return loops;
}

}  // namespace toile::prove
