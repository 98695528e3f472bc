// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "core/base/error.h"
#include "core/base/progress.h"
#include "core/cut/user_cuts.h"
#include "core/garment/piece.h"
#include "core/garment/records.h"
#include "core/geometry/point_index.h"

namespace toile {

/// Two vertices coincide if they are no farther apart than this part of the diagonal of all pieces:
/// the rounding of a file, far below any gap between two layers.
inline constexpr double kRimTolerance = 1e-6;

/// The rim edges of pieces, and which of them coincide.
class RimPairs {
public:
    static constexpr int kNone = -1;
    static constexpr int kSeveral = -2;

    struct Edge {
        int piece;
        int tail, head;    ///< vertices of the piece, cloth on the left
        int next = kNone;  ///< the edge that continues from `head`; none if ambiguous
        int prev = kNone;
        /// The edge with the same two ends in the opposite direction; `kSeveral` if more than two
        /// edges coincide there.
        int mate = kNone;
    };

    /// @param pieces  null entries are skipped
    /// Cost: linear in the triangles, n log n in the rim edges.
    explicit RimPairs(const Pieces& pieces);

    const Edge& edge(int e) const { return edges_[e]; }
    /// Per piece: its edges, in the order of its table.
    const std::vector<std::vector<int>>& rims() const { return rims_; }

    /// Replaces two pieces by their union, or one piece by a new version if both are the same. It
    /// gets the index `left`, and has only points of the two. Cost: as above, of these pieces only.
    void replace(int left, int right, const Piece& made);

private:
    using Ends = std::pair<int, int>;  ///< places of tail and head

    /// @param numbers  indices to use first
    void add(const Piece& piece, int index, std::vector<int> numbers);
    void link(const std::vector<int>& rim, Eigen::Index vertexCount);
    void findMates(const Ends& ends);

    std::vector<Edge> edges_;
    std::vector<std::vector<int>> rims_;
    std::vector<Eigen::Vector3d> places_;
    geometry::PointIndex index_;                ///< of the places
    std::vector<Ends> ends_;                    ///< per edge
    std::map<Ends, std::vector<int>> between_;  ///< edges by their ends
};

/// Consecutive edges on one piece whose mates are consecutive too: the stretch of seam around an
/// edge that has a mate. Closed if the last continues with the first.
struct PairedChain {
    std::vector<int> edges;  ///< each side of the seam once
    bool closed = false;
};

PairedChain chainAround(const RimPairs& rims, int seed);

/// Pieces after joining, with records.
struct JoinedPieces {
    Pieces pieces;
    std::vector<AppliedJoin> joins;
    Problems problems;  ///< JoinImpossible, for each seam that could not be removed
};

/// Removes seams one after the other: if two rims have the same vertices along the points of a
/// join, they are merged. The first piece keeps its position in the list, its vertices and faces
/// their indices; those of the second follow, without the merged vertices. Both sides may belong to
/// one piece: the two edges of a dart, or of a tube. Area, winding and sources are kept; the
/// reference panel is dropped, since two panels are not one. If the result is not a disk, it gets a
/// defect. Pieces without a join are returned by the same pointer.
/// Rejected, each with its reason, without affecting other joins: points far from any rim; a rim
/// there without exactly one other rim that has the same vertices; pieces of two files; results
/// that would not be a surface.
/// @param progress  reported; after a cancel the result is meaningless
/// Cost: linear in all triangles, and for every join in those of its two pieces and in the edges of
/// all rims; nothing without joins. Deterministic. Re-entrant.
JoinedPieces joinPieces(const Pieces& uncut, const std::vector<UserJoin>& joins,
                        const Progress& progress = Progress());

}  // namespace toile
