// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include "core/garment/piece.h"

namespace toile {

/// The rim edges of all pieces, and which of them lie on each other.
struct RimPairs {
    static constexpr int kNone = -1;
    static constexpr int kSeveral = -2;

    struct Edge {
        int piece;
        int tail, head;    ///< vertices of the piece, cloth on the left
        int next = kNone;  ///< the edge that goes on from `head`; none where that is in doubt
        int prev = kNone;
        /// The edge with the same two ends that runs the other way; `kSeveral` where more than two
        /// edges lie there.
        int mate = kNone;
    };

    std::vector<Edge> edges;
};

/// Two vertices lie on each other when they are no farther apart than this part of the diagonal of
/// all pieces: the rounding of a file, far below any gap between two layers.
inline constexpr double kSamePlace = 1e-6;

/// @param pieces  null ones are passed by
/// Cost: linear in the triangles, n log n in the rim edges. Pure.
RimPairs pairRims(const std::vector<std::shared_ptr<const Piece>>& pieces);

/// Edges one after the other on one piece whose mates are one after the other too: the stretch of
/// seam around an edge that has a mate. Closed where the last goes on with the first.
struct PairedChain {
    std::vector<int> edges;  ///< indices into RimPairs::edges; each side of the seam once
    bool closed = false;
};

PairedChain chainAround(const RimPairs& rims, int seed);

}  // namespace toile
