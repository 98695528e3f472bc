// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/pattern/fair_outline.h"
#include "core/pattern/outline_reference.h"

namespace toile {

/// The outline with the plan's straight stretches as straight lines, and its darts as triangles of
/// their two straight legs and the set intake: solves the boundary problem with each of these as a
/// single edge, and lays it over the original outline. Every length along it is kept, and each end
/// of a run takes half of the run's turn. Unchanged if the plan has neither.
/// @return vertices and ends of runs; the first point is vertex 0
/// Errors: LineNotDrawn if legs do not reach across an intake; those of `solveBoundary`.
/// Cost: a boundary problem. Pure.
Result<OutlineReference> reshapedOutline(const OutlineReference& reference, const OutlinePlan& plan,
                                         const Progress& progress);

}  // namespace toile
