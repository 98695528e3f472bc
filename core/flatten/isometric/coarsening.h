// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "core/base/progress.h"
#include "core/flatten/boundary/length_constraints.h"
#include "core/mesh/edge_table.h"

namespace toile::isometric {

/// A disk with fewer interior vertices, and the map back to the full disk. Each removed vertex is
/// collapsed along an edge onto a neighbour, if that flips no triangle of the flat piece and makes
/// no needle in 3D. Boundary vertices stay; the others thin out about evenly. `prolonged` inserts
/// the removed vertices in reverse order, each into the kernel of its ring, so a coarse flattening
/// without flipped triangles gives a fine one without. Immutable. Cost: linear.
class Coarsening {
public:
    /// @param mesh  a disk, may have holes  @param table  its edges
    /// @param loops  its whole boundary
    /// @param Q  its flattening, #V x 2, no flipped triangle
    /// @param wanted  number of interior vertices to keep; more stay if none can be removed
    /// @param progress  only checked for cancellation; then fewer vertices are removed
    Coarsening(const MeshArrays& mesh, const EdgeTable& table, const EdgeLoops& loops,
               const Points2& Q, int wanted, const Progress& progress);

    /// Keeps a tenth of the interior vertices, for the coarse solve before the fine one.
    Coarsening(const MeshArrays& mesh, const EdgeTable& table, const EdgeLoops& loops,
               const Points2& Q, const Progress& progress);
    /// False if so many vertices had to stay that solving the coarse piece saves nothing.
    bool savesWork() const;

    /// The coarse disk and its boundary, in the same order as the fine boundary.
    const MeshArrays& mesh() const { return mesh_; }
    const EdgeLoops& loops() const { return loops_; }
    /// The fine vertex of each coarse one, ascending.
    const std::vector<int>& kept() const { return kept_; }

    /// The coarse vertices' rows of a fine flattening.
    Points2 restricted(const Points2& fine) const;

    /// The fine flattening from a coarse one. Coarse vertices stay; each other vertex keeps its
    /// mean value coordinates in its ring from 3D, or moves to the centre of the ring's kernel if
    /// that would flip a triangle. None if a ring has no kernel.
    /// @param coarse  no flipped triangle
    std::optional<Points2> prolonged(const Points2& coarse) const;

    /// The fine flattening after a motion of the coarse one. Each vertex moves by the affine map
    /// that best fits the motion of its ring, or to the centre of the ring's kernel if that would
    /// flip a triangle. None if a ring has no kernel.
    /// @param before  #V x 2  @param coarse  no flipped triangle
    std::optional<Points2> followed(const Points2& before, const Points2& coarse) const;

    /// The motion of the fine vertices, by mean value coordinates, from that of the coarse ones.
    Points2 prolongedMotion(const Points2& coarse) const;
    /// Forces on the coarse vertices that do the same work as `fine`: transposed `prolongedMotion`.
    Points2 restrictedForces(Points2 fine) const;

private:
    /// A removed vertex: its ring, anti-clockwise, is ring_[first] .. ring_[last - 1].
    struct Removal {
        int vertex, first, last;
    };

    class Thinning;

    template <class Place>
    std::optional<Points2> laidBack(const Points2& coarse, Place place) const;

    MeshArrays mesh_;
    EdgeLoops loops_;
    std::vector<int> kept_;
    Eigen::Index fineCount_;
    std::vector<Removal> removals_;
    std::vector<int> ring_;
    std::vector<double> share_;  ///< of each ring vertex; a ring's shares sum to 1
};

}  // namespace toile::isometric
