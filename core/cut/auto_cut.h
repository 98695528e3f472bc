// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/base/result.h"
#include "core/cut/cut_along.h"
#include "core/cut/fill_holes.h"

namespace toile {

struct AutoCutOptions {
    /// Loops shorter than this fraction of the longest are holes in the cloth, as others may be
    /// (sortLoops): filled for the solve and not joined to the outline by a seam. 0: treat no loop
    /// as a hole.
    double smallHole = kSmallHole;
    /// More loops than this, without small holes, mean a scan with gaps rather than a garment.
    int maxLoops = 64;
};

/// The cuts that make a piece a disk.
struct AutoCut {
    std::vector<PathPolyline> cuts;  ///< faces as in the piece
    std::vector<RimLoop> holesToFill;
};

/// Cuts for one connected piece that is not a disk. A tube, or a piece with several loops: the
/// shortest seams that join them, straight along the surface. A closed piece: a short tree through
/// its sharpest corners, along its creases. Handles: two seams each. A disk needs none. Cuts are
/// pulled tight as long as the result stays one disk, which is tested each time.
/// @param progress  reported, and polled between cuts
/// @errors  those of checkDisk that no cut repairs; SeveralLoops above the limit; a cut error for a
///         mesh of several parts; Cancelled
/// Cost: O(n log n), and one cutAlong per cut at worst. Deterministic. Re-entrant.
Result<AutoCut> proposeCuts(const MeshArrays& mesh, const EdgeTable& table,
                            const AutoCutOptions& options = {},
                            const Progress& progress = Progress());

/// Fills the holes and makes the cuts. Faces and vertices of caps have the source -1, and a place
/// without a face.
Result<CutResult> applyAutoCut(const MeshArrays& mesh, const AutoCut& proposal,
                               const CutOptions& options = {},
                               const Progress& progress = Progress());

}  // namespace toile
