// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/pattern/fair_outline.h"
#include "core/pattern/outline_reference.h"

namespace toile {

/// The outline with what the plan wants straight as straight lines, and its darts as triangles of
/// their two legs, straight, and the intake that was typed: the boundary problem with each of them
/// as one edge, laid over the outline as it was. Every length along it is kept, and the ends of
/// a run take half each of what it turned by. As it was where the plan wants neither.
/// @return vertices and ends of runs; the first is vertex 0
/// Errors: LineNotDrawn where legs do not reach across an intake; those of `solveBoundary`.
/// Cost: a boundary problem. Pure.
Result<OutlineReference> reshapedOutline(const OutlineReference& reference, const OutlinePlan& plan,
                                         const Progress& progress);

}  // namespace toile
