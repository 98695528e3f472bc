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

/// A cut that a tailor would make, with what speaks for it.
struct TailorCut {
    UserCut cut;  ///< mm; called "left side", "right armhole"; without an id
    TailorLine line = TailorLine::Style;
    int side = 0;               ///< of the mirror plane: -1, 1; 0 in the middle
    double likeliness = 0;      ///< that the mesh has a seam there, 0 to 1
    bool isFileBorder = false;  ///< most of it runs along a border of the file
};

/// What such a line is called: "armhole".
const char* wordOf(TailorLine line);

/// Proposes cuts for one connected piece that is worn: `readBody`, `tailorSeams`, and their lines
/// made smooth. Where a line of the mesh leads a cut follows its edges; elsewhere its teeth are
/// ironed out, on the surface. Cuts that meet share the point where they do. Where the piece is its
/// own mirror image to 0.5 mm, the cuts of one side are those of the other, reflected.
/// @return empty where no body is recognised
/// Cost: a second for 20 000 triangles, half of it the mirror plane. Deterministic. Pure.
std::vector<TailorCut> tailorCuts(const std::shared_ptr<const Piece>& piece,
                                  const Progress& progress = {});

/// The same of a body that has been read, beside cuts that are made anyhow: proposals are led to
/// these, end on them, and do not run along them again.
/// @param body     of this piece
/// @param borders  per edge, as of `fileBorders`; may be empty
std::vector<TailorCut> tailorCuts(const Piece& piece, const GarmentBody& body,
                                  const std::vector<UserCut>& own, const Progress& progress = {},
                                  const std::vector<char>& borders = {});

}  // namespace toile
