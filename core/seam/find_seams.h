// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include "core/base/progress.h"
#include "core/garment/garment.h"
#include "core/garment/piece.h"
#include "core/garment/seam.h"

namespace toile {

struct SeamOptions {
    /// Largest distance between the two sides of a seam, as a fraction of the local edge length.
    /// Never more than a small part of the garment (kGapOfGarment). If the garment's seams are
    /// closed more tightly than that, looser ones are rejected.
    double gap = 0.25;
};

/// Finds which outlines are sewn together, in three ways that share one algorithm:
/// - edges between the same two positions of one file are the same line of a welded garment;
/// - edges that coincide, and edges that are near and run in opposite directions, with equal or
///   different sampling, become contacts, unless coincident vertices contradict
///   (`dropContradicted`); consecutive contacts on both outlines become intervals (so every
///   interval is mutual and monotone); the closer of two competing intervals wins, then the longer
///   one.
/// Outlines of consistently wound pieces run against each other along a seam. A piece with
/// opposite winding is recognised by the balance of its contacts and matched in the same direction.
///
/// The rim of a hole is a separate outline: a patch that was cut out of a piece is sewn to it.
/// Holes that nothing is sewn to are not in the graph.
///
/// A place belongs to one seam. If three layers meet in one line, the pair that continues an
/// undisputed seam is chosen first; the third layer becomes a seam of its own, `stacked` on the
/// place already used, so that no layer is lost and pairs are not mixed up.
/// A seam continues while its partner stays the same; corners do not split it. The two sides of a
/// narrow strip of cloth are never sewn to each other.
///
/// @param pieces  mm, of any size and position; a piece with a defect has no outline and no seams
/// In crowded places (`nearbyEdges`) no seams are found by proximity; `SeamGraph::notes` reports
/// this, and how many seams were found by proximity alone, with the largest gap. Deterministic;
/// vertex and face order affect only the numbering of equal names. Cost: n log n in the outline
/// edges and linear in the meshes. Re-entrant.
/// @param progress  reported; after a cancel the result is invalid
SeamGraph findSeams(const Pieces& pieces, const SeamOptions& options = {},
                    const Progress& progress = Progress());

/// Names the seams along which a completed half meets its mirror image: "mirror seam", or "mirror
/// seam 1", "mirror seam 2" in the order of the graph. Seams made by a cut keep their name. Names
/// stay unique.
/// @param seams  of the garment's pieces  Cost: the vertices of the seams. Pure.
void nameMirrorSeams(SeamGraph& seams, const Garment& garment);

}  // namespace toile
