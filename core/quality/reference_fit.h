// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/mesh_arrays.h"

namespace toile {

/// How far a flat piece lies from a given flat panel after the best rigid motion, or the best
/// motion with a reflection where that fits better. Over all vertices, millimetres.
struct ReferenceFit {
    double rms = 0;
    double max = 0;
    bool mirrored = false;
};

/// @param flat, reference  #V x 2 each, vertex by vertex, at least one vertex. Pure; linear.
ReferenceFit fitToReference(const Points2& flat, const Points2& reference);

/// The given panel laid on the flat piece by that motion: #V x 2, mm, in the flat piece's
/// coordinates. `fitToReference` tells how far the points then lie from the piece's. Pure; linear.
Points2 placedReference(const Points2& flat, const Points2& reference);

}  // namespace toile
