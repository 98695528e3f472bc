// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/prove/proof.h"

namespace toile {

/// Faults of a pattern, with their texts.

Finding pieceNotThere(const Garment& garment, int piece);
Finding pieceNotNeeded(const FilePiece& piece);
Finding pieceMirrored(const Garment& garment, int piece);
/// @param other  the piece that fits the pattern's piece for `piece` better
Finding otherPieceFits(const Garment& garment, int piece, int other, const FilePiece& there);
/// The piece is left out: its outline crosses itself.
Finding pieceCrossesItself(const Garment& garment, int piece);
/// The piece disappears: all of it is between sides that are sewn to each other.
Finding pieceSewnAway(const Garment& garment, int piece);
/// @param slip  see `ProvenSeam`
Finding seamSlips(const Garment& garment, int seam, double slip);
/// @param longer  mm; negative: shorter
Finding seamLengthDiffers(const Garment& garment, int seam, double longer);

/// All cloth is far from the design. @param gap  mean, mm
Finding clothNowhereNear(double gap, double size);

/// Error detail: the lengths of the pattern suggest another unit than `read`.
/// @param times  ratio of its lengths to the design's
Wording patternInOtherUnit(double times, const FileUnit& read);
/// Error detail: no piece of the pattern can be sewn.
Wording nothingToSew();
/// Error detail: the garment's own pattern vanishes in a file, because numbers are rounded.
Wording patternTooSmall();
/// @param edge  requested, mm  @param least  that gives few enough triangles
Wording edgesTooFine(double edge, double triangles, double least);
/// `Proof::source` for the designer's panels, and for the garment's own pattern.
Wording sourceIsReference();
Wording sourceIsReadBack();

}  // namespace toile
