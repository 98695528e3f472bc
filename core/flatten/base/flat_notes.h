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

/// Notes for the user about a flat piece (`FlatPiece::notes`). Places are in mm with one decimal,
/// in coordinates of the piece and of the pattern. Precondition of all: the piece has no defect.

/// OutlineCrosses: number of crossings, and where the first is in the pattern and on the piece.
/// Nothing if the outline is simple.
/// @param crossings  from findOutlineCrossings(Q, piece.boundary)
std::optional<Error> crossingNote(const Piece& piece, const Points2& Q,
                                  const std::vector<OutlineCrossing>& crossings);

/// Adds TrianglesFlipped if triangles are flipped or collapsed (`kCollapsedShare`): how many, and
/// where on the piece the worst is. Absorbs a note that the method ended early: such a pattern is
/// not usable.
void noteFlips(const Piece& piece, const Points2& Q, Problems& notes);

/// EdgesTooShort: boundary edges too short relative to the pattern for its coordinates to hold
/// their lengths. For methods that keep lengths.
/// @param targets  with which the piece was flattened
std::optional<Error> shortEdgesNote(const Piece& piece, const Points2& Q,
                                    const OutlineTargets& targets = {});

/// OutlineUncrossed, for a flattening that moved `crossings` crossings apart.
Error uncrossedNote(const Piece& piece, int crossings);

/// DegenerateTriangles: triangles lower than a millionth of their longest edge, whose angles are
/// unreliable; lists the first few by the file's face index (counted from 0) and place.
std::optional<Error> degenerateNote(const Piece& piece);

/// AnglesOutOfRange: wanted inner angles of the outline outside [0, 2 pi], beyond rounding.
/// @param angles  one per vertex of piece.boundary, radians
std::optional<Error> anglesNote(const Piece& piece, const Eigen::VectorXd& angles);

/// EndedEarly. @param how  "after 12 steps"
Error endedEarlyNote(const Piece& piece, const Wording& how);

/// RimsNotKept: the largest error of a hole's rim length.
/// @param why  appended, or empty
Error rimsNote(const Piece& piece, const Points2& Q, const Wording& why);

}  // namespace toile
