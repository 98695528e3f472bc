// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/garment/garment.h"
#include "core/pattern/line_settings.h"
#include "core/seam/outline.h"

namespace toile {

struct FoundEdge {
    EdgeKind kind = EdgeKind::Unknown;
    int opening = -1;  ///< number of the garment's opening that it belongs to; -1: it is sewn
};

/// Finds what each edge of the pieces' outlines is on the worn garment, if it is free. Free edges
/// are followed across the seams at their ends to the openings of the garment; an opening is read
/// by its place on the cloth that hangs together:
/// - A pair of openings on both sides: legs (hem) below the middle of a garment that has no other
///   lower opening; else armholes, short sleeves (hem) or long ones (cuff), by the distance from
///   the neck in shares of the opening's length.
/// - Any other opening: the top one is the neckline if there are arms, else the waist; the lower
///   ones are hems. The free edge of a band along the neck is a collar edge.
/// - An opening from top to bottom, as of a jacket, is divided by direction: its upright parts are
///   front edges. Upright parts that face each other closely in other openings are front edges
///   (plackets) at the neck, else slits.
/// Cloth that lies in a plane, or looks one way as an unsewn panel does, is Unknown.
/// @param outlines  of the garment's pieces
/// @return  per piece and edge of its outline
/// Cost: n log n in the outlines, plus the square of upright edges. Pure.
std::vector<std::vector<FoundEdge>> findEdgeKinds(const Garment& garment,
                                                  const seam::Outlines& outlines);

}  // namespace toile
