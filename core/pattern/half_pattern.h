// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/flatten/base/piece_result.h"
#include "core/pattern/grain_line.h"
#include "core/pattern/pattern.h"

namespace toile {

/// Half patterns (`Cutting::byHalf`): what is drawn once of two halves, or of two pieces, that are
/// mirror images of each other to the last digits. What is not drawn so is never called a half.

/// What mirrors what, as outlines are drawn. Nothing does that has holes, whose rims are not drawn,
/// that is not drawn as planned, or whose outline crosses its mirror line elsewhere.
/// @return one per result  Cost: linear in the outlines. Pure.
std::vector<DrawnMirror> drawnMirrors(const PieceResults& results);

/// @param byHalf  of the piece or of its counterpart
CutAs cutAs(const DrawnMirror& mirror, bool byHalf);

/// The pattern as it is drawn in files. Of a piece that is cut on the fold the outline up to the
/// mirror line and straight back along it (its last edge), with what lies on it. Its cutting line
/// is that of the whole piece, clipped at the mirror line (its last edge too). Of a pair the
/// leading piece, as often as that is cut, while the other has no outline any more. A pair has both
/// sides already: `mirroredPair` adds nothing to it. A piece on the fold is its own image:
/// `mirroredPair` doubles how often it is cut. Numbers are those of what is drawn.
/// The strips of facings become pieces after the others, in order, as often as what they are of.
/// @param whole  of `makePattern`, with the `Cutting` of each piece  Cost: linear. Pure.
Pattern asCut(Pattern whole);

/// Clears `PatternPiece::mirror` of pieces whose cutting lines are no mirror images: someone has
/// set another allowance, corner or extension on one side only, so one half cannot stand for both.
/// Cost: linear in the cutting lines.
void dropUnequalMirrors(std::vector<PatternPiece>& pieces);

/// The line on which the cloth is folded, for a half pattern and for a whole piece that is
/// symmetric; along the half's outline, cloth on the left.  Precondition: it is one of both.
Chord foldOf(const PatternPiece& piece);

/// The same of a half pattern as far as its cutting line reaches, over the allowances at both ends:
/// the last edge of `edgeOf`.  Precondition: it is cut on the fold.
Chord foldOfEdge(const PatternPiece& piece);

}  // namespace toile
