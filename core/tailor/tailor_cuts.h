// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/base/progress.h"
#include "core/cut/user_cuts.h"
#include "core/garment/piece.h"
#include "core/tailor/tailor_seams.h"

namespace toile {

/// A cut that a tailor would make, with its evidence.
struct TailorCut {
    UserCut cut;  ///< mm; named "left side", "right armhole"; without an id
    TailorLine line = TailorLine::Style;
    int side = 0;               ///< of the mirror plane: -1, 1; 0 in the middle
    double likeliness = 0;      ///< of a seam of the mesh there, 0 to 1
    bool isFileBorder = false;  ///< most of it runs along a border of the file
};

/// The name of a kind of line: "armhole".
const char* wordOf(TailorLine line);

/// Proposes cuts for one connected, worn piece: `readBody`, `tailorSeams`, then smoothing of their
/// lines. Cuts along a line of the mesh follow its edges; elsewhere their zigzag is smoothed on the
/// surface. Cuts that meet share a point. If the piece is its own mirror image within 0.5 mm, the
/// cuts of one side are the reflected cuts of the other.
/// @return empty if no body is recognised
/// Cost: a second for 20 000 triangles, half of it the mirror plane. Deterministic. Pure.
std::vector<TailorCut> tailorCuts(const std::shared_ptr<const Piece>& piece,
                                  const Progress& progress = {});

/// The same for a known body, next to cuts that are made in any case: proposals run to these, end
/// on them, and do not run along them again.
/// @param body     of this piece
/// @param borders  per edge, from `fileBorders`; may be empty
std::vector<TailorCut> tailorCuts(const Piece& piece, const GarmentBody& body,
                                  const std::vector<UserCut>& own, const Progress& progress = {},
                                  const std::vector<char>& borders = {});

}  // namespace toile
