// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "core/flatten/base/piece_result.h"
#include "core/garment/garment.h"
#include "core/project/piece_settings.h"

namespace toile {

/// Names that the user gives to pieces, used wherever pieces and seams are named. Names within a
/// garment are unique, so that files can refer to pieces by name.

inline constexpr std::size_t kMaxPieceName = 60;  ///< letters of a user-given name

/// The labels with a new name for a piece; a number is appended if another piece of the garment has
/// that name.
/// @param name  surrounding blanks are ignored; empty or the piece's own: resets the name
PieceLabels withName(PieceLabels labels, const Garment& garment, int piece, std::string name);

/// The name of a seam, with the names that the user gave its pieces.
std::string nameOf(const PieceLabels& labels, const Garment& garment, const Seam& seam);

/// The garment with the user's names, for files and tables. Pieces without a new name keep their
/// pointers; all ids stay.
/// Cost: a copy of each renamed piece. Pure.
Garment named(Garment garment, const PieceLabels& labels);

/// Results for the garment's pieces under other names (`named`).
/// @param results  one per piece of the garment, null if there is none
PieceResults resultsFor(const Garment& named, PieceResults results);

}  // namespace toile
