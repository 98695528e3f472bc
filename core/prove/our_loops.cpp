// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/prove/our_loops.h"

namespace toile::prove {
namespace {

std::vector<double> arcAlong(const Points3& closed) {
    std::vector<double> arc{0};
    for (Eigen::Index k = 0; k < closed.rows(); ++k) {
        arc.push_back(arc.back() + (closed.row((k + 1) % closed.rows()) - closed.row(k)).norm());
    }
    return arc;
}

}  // namespace

std::vector<OurLoop> ourLoops(const Piece& piece, const Points2& flat, const FlatLine* line) {
    std::vector<OurLoop> loops;
    const auto add = [&](const std::vector<int>& loop, const FlatLine* drawn) {
        const Points3 space = piece.mesh.V(loop, Eigen::all);
        loops.push_back({space, drawn != nullptr
                                    ? ClosedLine(drawn->points, drawn->arc)
                                    : ClosedLine(flat(loop, Eigen::all), arcAlong(space))});
    };
    add(piece.boundary, line);
    for (const std::vector<int>& hole : piece.holes) {
        add(hole, nullptr);
    }
    return loops;
}

}  // namespace toile::prove
