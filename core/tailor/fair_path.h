// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "core/cut/surface_paths.h"

// For the sources of this folder only.
namespace toile::tailor {

struct Fairness {
    double near;    ///< mm: how far the line may leave its way
    double step;    ///< mm: from one of its points to the next, at most
    int roundings;  ///< how often it is shortened around each of them
};

/// The line on the surface that a way along edges stands for: the fewest shortest ways that stay
/// near it, and the kinks between them rounded.  @param way  vertices, at least two
/// @return geodesics of even length, one after the other, from its first vertex to its last
/// Cost: some shortest ways (`geodesicPath`) and dozens of shortenings (`straightened`). Pure.
std::vector<PathPolyline> fairPath(const SurfaceLinks& links, std::span<const int> way,
                                   const Fairness& fairness);

}  // namespace toile::tailor
