// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/garment/seam.h"
#include "core/seam/choose_runs.h"

namespace toile {

/// Makes a seam of a run: decides the kind, puts its ends on vertices that are near enough, and
/// writes down the corresponding places. No name yet.
Seam finishSeam(const Outlines& outlines, const Chosen& chosen);

/// A seam of one side: an edge sewn to nothing.
/// @param index  of the outline
Seam freeEdge(const Outlines& outlines, int index, Arc arc);

}  // namespace toile
