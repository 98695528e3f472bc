// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/flatten/base/piece_result.h"
#include "core/pattern/pattern.h"
#include "core/pattern/piece_grain.h"

namespace toile {

/// Half patterns (`Cutting::byHalf`): a single drawing for two halves or two pieces that are mirror
/// images of each other to the last digits. Anything else is never called a half.

/// Finds the mirror images among drawn outlines. Excludes pieces with holes (their rims are not
/// drawn), pieces not drawn as planned, and outlines that cross their mirror line elsewhere.
/// @return one per result  Cost: linear in the outlines. Pure.
std::vector<DrawnMirror> drawnMirrors(const PieceResults& results);

/// @param byHalf  set on the piece or on its counterpart
CutAs cutAs(const DrawnMirror& mirror, bool byHalf);

/// The pattern as drawn in files. A piece cut on the fold has its outline up to the mirror line and
/// straight back along it (its last edge), with everything on that half; its cutting line is that
/// of the whole piece, clipped at the mirror line (also its last edge). A pair has the leading
/// piece, with its quantity, while the other has no outline. A pair has both sides already, so
/// `mirroredPair` adds nothing; a piece on the fold is its own image, so `mirroredPair` doubles its
/// quantity. Only drawn pieces are numbered.
/// Facings are added as pieces at the end, in order, with the quantity of their piece.
/// @param whole  of `makePattern`, with the `Cutting` of each piece  Cost: linear. Pure.
Pattern asCut(Pattern whole);

/// Clears `PatternPiece::mirror` of pieces whose cutting lines are no mirror images, because an
/// allowance, corner or extension was set on one side only, so one half cannot stand for both.
/// Cost: linear in the cutting lines.
void dropUnequalMirrors(std::vector<PatternPiece>& pieces);

/// The fold line of the cloth, for a half pattern or a whole symmetric piece; directed along the
/// half's outline, cloth on the left.  Precondition: it is one of both.
Chord foldOf(const PatternPiece& piece);

/// The same for a half pattern, extended over the allowances at both ends to its cutting line: the
/// last edge of `edgeOf`.  Precondition: it is cut on the fold.
Chord foldOfEdge(const PatternPiece& piece);

}  // namespace toile
