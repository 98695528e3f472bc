// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/prove/proof.h"

namespace toile {

/// What is wrong with a pattern, told.

ProofFault pieceNotThere(const Garment& garment, int piece);
ProofFault pieceNotNeeded(const FilePiece& piece);
ProofFault pieceMirrored(const Garment& garment, int piece);
/// @param other  the piece that what the pattern has for `piece` fits better
ProofFault otherPieceFits(const Garment& garment, int piece, int other, const FilePiece& there);
/// It is left out: its outline crosses itself.
ProofFault pieceCrossesItself(const Garment& garment, int piece);
/// Nothing of it is left: all of it is between sides that are sewn to each other.
ProofFault pieceSewnAway(const Garment& garment, int piece);
/// @param slip  as of `ProvenSeam`
ProofFault seamSlips(const Garment& garment, int seam, double slip);
/// @param longer  mm; below 0: shorter
ProofFault seamLengthDiffers(const Garment& garment, int seam, double longer);

/// All of the cloth is nowhere near the design. @param gap  mean, mm
ProofFault clothNowhereNear(double gap, double size);

/// The detail of an error: the lengths of the pattern are those of another unit than `read`.
/// @param times  how many times as long as the design's they are
Wording patternInOtherUnit(double times, const FileUnit& read);
/// The detail of an error: nothing of the pattern is to be sewn.
Wording nothingToSew();
/// Or nothing of the garment's own is left in a file, whose numbers have an end.
Wording patternTooSmall();
/// @param edge  asked for, mm  @param least  that makes few enough triangles
Wording edgesTooFine(double edge, double triangles, double least);
/// `Proof::source` of the designer's panels, and of the garment's own pattern.
Wording sourceIsReference();
Wording sourceIsReadBack();

}  // namespace toile
