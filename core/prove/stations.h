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

/// The points along the loops of all cloth, and which are sewn to which.
struct Stations {
    /// Per piece and loop: places (`RestLoop`), ascending within one turn; none where there is no
    /// cloth, or no loop.
    std::vector<std::vector<std::vector<double>>> places;
    std::vector<std::pair<Station, Station>> sewn;
};

/// Puts points on both sides of each seam, as many, at places that are matched, about `edge` apart
/// on the longer side; on free edges evenly. Corners and ends of seams are among them. A seam to a
/// place that has points already, as of a third layer, takes these.
/// @param atVertices  where the garment's own vertices are on free edges and on the left sides of
///                    seams, as far as they are apart
/// Cost: points of a loop, squared. Pure.
Stations placeStations(const SeamGraph& seams, const RestPattern& pattern, double edge,
                       bool atVertices);

/// Whether both sides of a seam are cloth.
bool isSewn(const Seam& seam, const RestPattern& pattern);
/// The loop of a side; precondition: it is cloth.
const RestLoop& loopOf(const SeamSide& side, const RestPattern& pattern);

}  // namespace toile::prove
