// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "core/base/progress.h"
#include "core/flatten/boundary/length_constraints.h"
#include "core/mesh/edge_table.h"

namespace toile::isometric {

/// A disk with fewer interior vertices, and the way back. Interior vertices are taken out one by
/// one, each by drawing it along an edge onto a neighbour, where that flips no triangle of the flat
/// piece and leaves no needle in 3D; all boundary vertices stay, and the rest thins out about
/// evenly. On the way back they are put in again in the opposite order, each into the kernel of its
/// ring, so that a flat coarse piece without flipped triangles gives a flat fine one without.
/// Immutable. Cost: linear.
class Coarsening {
public:
    /// @param mesh  a disk, holes aside  @param table  its edges
    /// @param loops  its boundary, all of it
    /// @param Q  its flattening, #V x 2, no flipped triangle
    /// @param wanted  number of interior vertices to stop at; more stay where none can go
    /// @param progress  looked at only; once cancelled fewer vertices are taken out
    Coarsening(const MeshArrays& mesh, const EdgeTable& table, const EdgeLoops& loops,
               const Points2& Q, int wanted, const Progress& progress);

    /// The same, with a tenth of the inner vertices wanted: the coarse piece that is solved before,
    /// or beside, the fine one.
    Coarsening(const MeshArrays& mesh, const EdgeTable& table, const EdgeLoops& loops,
               const Points2& Q, const Progress& progress);
    /// False where so many vertices had to stay that solving the coarse piece saves nothing.
    bool savesWork() const;

    /// The coarse disk and its boundary, in the same order as the fine one's.
    const MeshArrays& mesh() const { return mesh_; }
    const EdgeLoops& loops() const { return loops_; }

    /// The coarse vertices' rows of a fine flattening.
    Points2 restricted(const Points2& fine) const;

    /// The fine flattening that goes on from a coarse one: coarse vertices stay, each other lies
    /// among its ring as it does in 3D (mean value coordinates), or, where that would flip a
    /// triangle, in the middle of the ring's kernel. Nothing where a ring has no kernel.
    /// @param coarse  no flipped triangle
    std::optional<Points2> prolonged(const Points2& coarse) const;

    /// The fine flattening that follows a coarse one from an earlier place of both: each vertex
    /// keeps its place among its ring but for the affine map that takes the ring along best; where
    /// that would flip a triangle, it goes to the middle of the ring's kernel. Nothing where a ring
    /// has no kernel.
    /// @param before  #V x 2  @param coarse  no flipped triangle
    std::optional<Points2> followed(const Points2& before, const Points2& coarse) const;

    /// How the fine vertices move with the coarse ones: each among its ring as in 3D. Linear.
    Points2 prolongedMotion(const Points2& coarse) const;
    /// The forces on the coarse vertices that do the same work as these on the fine ones: the
    /// transpose of `prolongedMotion`.
    Points2 restrictedForces(Points2 fine) const;

private:
    /// A vertex taken out: its ring, anti-clockwise, is ring_[first] .. ring_[last - 1].
    struct Removal {
        int vertex, first, last;
    };

    class Thinning;

    template <class Place>
    std::optional<Points2> laidBack(const Points2& coarse, Place place) const;

    MeshArrays mesh_;
    EdgeLoops loops_;
    std::vector<int> kept_;  ///< fine vertex of each coarse one, ascending
    Eigen::Index fineCount_;
    std::vector<Removal> removals_;
    std::vector<int> ring_;
    std::vector<double> share_;  ///< of each ring vertex; a ring's shares sum to 1
};

}  // namespace toile::isometric
