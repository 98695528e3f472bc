// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>

#include "core/base/error.h"
#include "core/flatten/base/outline_targets.h"
#include "core/mesh/mesh_arrays.h"
#include "core/quality/outline_crossings.h"

namespace toile {

struct Piece;

/// What the user should know of a flat piece (`FlatPiece::notes`). Places are in mm with one
/// decimal, the piece's and the pattern's. Precondition of all: the piece has no defect.

/// OutlineCrosses: how many crossings, and where the first is in the pattern and on the piece.
/// Nothing where the outline is simple.
/// @param crossings  from findOutlineCrossings(Q, piece.boundary)
std::optional<Error> crossingNote(const Piece& piece, const Points2& Q,
                                  const std::vector<OutlineCrossing>& crossings);

/// Adds TrianglesFlipped, where there are any or some have collapsed (`kCollapsedShare`): how many,
/// and where on the piece the worst is. A
/// note that the method ended early becomes part of it: such a pattern cannot be used as it is.
void noteFlips(const Piece& piece, const Points2& Q, Problems& notes);

/// EdgesTooShort: boundary edges so short next to the pattern that the digits of its coordinates
/// do not hold their lengths. For methods that keep lengths.
/// @param targets  that the piece was flattened with
std::optional<Error> shortEdgesNote(const Piece& piece, const Points2& Q,
                                    const OutlineTargets& targets = {});

/// OutlineUncrossed, for a flattening that moved `crossings` crossings apart.
Error uncrossedNote(const Piece& piece, int crossings);

/// DegenerateTriangles: those of less height than a millionth of their longest edge, too flat for
/// their angles to say much; the first few by the file's face index (counted from 0) and place.
std::optional<Error> degenerateNote(const Piece& piece);

/// AnglesOutOfRange: wanted inner angles of the outline outside [0, 2 pi], rounding aside.
/// @param angles  one per vertex of piece.boundary, radians
std::optional<Error> anglesNote(const Piece& piece, const Eigen::VectorXd& angles);

/// EndedEarly. @param how  "after 12 steps"
Error endedEarlyNote(const Piece& piece, const Wording& how);

/// RimsNotKept: how far the rim of a hole is from its length that is furthest off.
/// @param why  said after it, or empty
Error rimsNote(const Piece& piece, const Points2& Q, const Wording& why);

}  // namespace toile
