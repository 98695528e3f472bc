// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "core/flatten/base/piece_result.h"
#include "core/garment/garment.h"
#include "core/project/piece_settings.h"

namespace toile {

/// What a person calls pieces, wherever pieces and seams are named. No two pieces of a garment are
/// called the same, so that files can be read by their names.

inline constexpr std::size_t kMaxPieceName = 60;  ///< letters of a name that a person gives

/// The labels with another name for a piece; with a number where another piece of the garment is
/// called so.
/// @param name  blanks around it do not count; none, or the piece's own: its own again
PieceLabels withName(PieceLabels labels, const Garment& garment, int piece, std::string name);

/// What a seam is called: as the garment has it, with the names that its pieces were given.
std::string nameOf(const PieceLabels& labels, const Garment& garment, const Seam& seam);

/// The garment with the names that a person has given: what files and tables are made of. Pieces
/// that nobody renamed are the same pointers; all ids stay.
/// Cost: a copy of each renamed piece. Pure.
Garment named(Garment garment, const PieceLabels& labels);

/// Results for the garment's pieces under other names (`named`).
/// @param results  one per piece of the garment, null where there is none
PieceResults resultsFor(const Garment& named, PieceResults results);

}  // namespace toile
