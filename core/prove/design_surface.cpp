// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/prove/design_surface.h"

#include <algorithm>
#include <map>
#include <utility>
#include <vector>

#include "core/geometry/disjoint_sets.h"
#include "core/sew/seam_samples.h"

namespace toile::prove {
namespace {

/// Per piece whether its triangles run opposite to those of the first piece it is joined to.
std::vector<char> turnedPieces(const sew::CutCloth& cut, const Triangles& F, std::size_t pieces) {
    // Each side of a triangle, between joined points, with its piece and direction.
    struct Side {
        int low, high, piece;
        bool isUp;
    };
    std::vector<Side> sides;
    for (Eigen::Index f = 0; f < F.rows(); ++f) {
        for (int k = 0; k < 3; ++k) {
            const int a = F(f, k), b = F(f, (k + 1) % 3);
            if (a != b) {
                sides.push_back({std::min(a, b), std::max(a, b), cut.pieceOf[f], a < b});
            }
        }
    }
    std::ranges::stable_sort(sides, {}, [](const Side& s) { return std::pair(s.low, s.high); });
    std::map<std::pair<int, int>, int> votes;  // per pair of pieces: sides with the same direction
    for (std::size_t k = 0; k + 1 < sides.size(); ++k) {
        const Side &a = sides[k], &b = sides[k + 1];
        if (a.low == b.low && a.high == b.high && a.piece != b.piece) {
            const int vote = a.isUp == b.isUp ? -1 : 1;
            votes[{a.piece, b.piece}] += vote;
            votes[{b.piece, a.piece}] += vote;
        }
    }
    std::vector<char> isSeen(pieces, 0), isTurned(pieces, 0);
    for (std::size_t first = 0; first < pieces; ++first) {
        std::vector<int> queue{static_cast<int>(first)};
        while (!queue.empty()) {
            const int piece = queue.back();
            queue.pop_back();
            isSeen[piece] = 1;
            for (auto at = votes.lower_bound({piece, 0});
                 at != votes.end() && at->first.first == piece; ++at) {
                const int other = at->first.second;
                if (!isSeen[other] && at->second != 0) {
                    isSeen[other] = 1;
                    isTurned[other] = (isTurned[piece] != 0) == (at->second > 0) ? 1 : 0;
                    queue.push_back(other);
                }
            }
        }
    }
    return isTurned;
}

}  // namespace

Result<MeshArrays> designSurface(const Garment& garment) {
    std::vector<Points2> flat;
    for (const auto& piece : garment.pieces) {
        // The plane does not matter: an upright piece may have no area there.
        flat.emplace_back(piece->mesh.V.leftCols<2>());
    }
    const auto cut = sew::cutAlongSeams(garment, flat);
    if (!cut) {
        return cut.error();
    }
    geometry::DisjointSets sets(static_cast<int>(cut->V.rows()));
    for (const auto& [a, b] : cut->sewn) {
        sets.join(a, b);
    }
    Triangles joined = cut->F;
    for (int& corner : joined.reshaped()) {
        corner = sets.root(corner);
    }
    const auto isTurned = turnedPieces(*cut, joined, garment.pieces.size());
    MeshArrays surface{cut->V, Triangles(joined.rows(), 3)};
    Eigen::Index kept = 0;
    for (Eigen::Index f = 0; f < joined.rows(); ++f) {
        Eigen::RowVector3i corners = joined.row(f);
        if (corners[0] != corners[1] && corners[1] != corners[2] && corners[2] != corners[0]) {
            if (isTurned[cut->pieceOf[f]]) {
                std::swap(corners[1], corners[2]);
            }
            surface.F.row(kept++) = corners;
        }
    }
    surface.F.conservativeResize(kept, 3);
    return surface;
}

}  // namespace toile::prove
