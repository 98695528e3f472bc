// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <utility>
#include <vector>

#include "core/garment/seam.h"
#include "core/prove/rest_pattern.h"

namespace toile::prove {

/// A point on a loop of a piece of cloth.
struct Station {
    int piece = 0, loop = 0;
    int number = 0;  ///< along the loop
};

/// The points along the loops of all cloth, and the pairs to sew.
struct Stations {
    /// Per piece and loop: places (`RestLoop`), ascending within one turn; empty without cloth or
    /// without a loop.
    std::vector<std::vector<std::vector<double>>> places;
    std::vector<std::pair<Station, Station>> sewn;
};

/// Puts equally many points on both sides of each seam, at matched places, about `edge` apart on
/// the longer side; evenly on free edges. Corners and ends of seams are included. A seam to a place
/// that already has points, like that of a third layer, uses those.
/// @param atVertices  use the garment's own vertices on free edges and on the left sides of seams,
///                    as far as their spacing allows
/// Cost: points of a loop, squared. Pure.
Stations placeStations(const SeamGraph& seams, const RestPattern& pattern, double edge,
                       bool atVertices);

/// Whether both sides of a seam are cloth.
bool isSewn(const Seam& seam, const RestPattern& pattern);
/// The loop of a side; precondition: it has cloth.
const RestLoop& loopOf(const SeamSide& side, const RestPattern& pattern);

}  // namespace toile::prove
