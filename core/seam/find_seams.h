// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include "core/base/progress.h"
#include "core/garment/piece.h"
#include "core/garment/seam.h"

namespace toile {

struct SeamOptions {
    /// Largest distance between the two sides of a seam, as a fraction of the local edge length.
    /// Never more than a small part of the garment (kGapOfGarment), and where the garment's seams
    /// are closed more tightly than that, looser ones are not believed.
    double gap = 0.25;
};

/// Finds which outlines are sewn to which, in three ways that share one machinery:
/// - edges between the same two positions of one file are the same line of a welded garment;
/// - edges that coincide, and edges that lie close and run in opposite directions, sampled alike or
///   not, become contacts, unless vertices that coincide speak against them (`dropContradicted`);
///   contacts in a row on both outlines become intervals (so every interval
///   is mutual and monotone); where they compete for a place the closer one has it, then the longer
///   one.
/// Outlines of consistently wound pieces run against each other along a seam. A piece wound the
/// other way is recognised by the balance of its contacts and matched along instead.
///
/// The rim of a hole is an outline of its own: a patch that was cut out of a piece is sewn to it. A
/// hole that nothing is sewn to stays out of the graph.
///
/// A place belongs to one seam. Where three layers meet in one line, the pair that continues an
/// undisputed seam is taken first; the third layer is reported as a seam of its own, `stacked`
/// on the place already taken, so that no layer is lost and no two pairs are mixed up.
/// A seam is as long as its partner does not change; corners do not split it. The two sides of a
/// narrow strip of cloth are not sewn to each other, however near.
///
/// @param pieces  mm, of any size and place; a piece with a defect has no outline and no seams
/// Where edges crowd (`nearbyEdges`) none are found by nearness; `SeamGraph::notes` says so, and
/// how many seams were found by nearness alone, with the greatest gap. Deterministic; does not
/// depend on the order of vertices and faces but for the numbering of equal names. Cost: n log n in
/// the outline edges and linear in the meshes. Re-entrant.
/// @param progress  reported; once it is cancelled, what is returned is worth nothing
SeamGraph findSeams(const std::vector<std::shared_ptr<const Piece>>& pieces,
                    const SeamOptions& options = {}, const Progress& progress = Progress());

}  // namespace toile
