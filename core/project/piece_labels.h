// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>
#include <vector>

#include "core/garment/garment.h"

namespace toile {

/// How a person tells a piece from the others.
struct PieceLabel {
    std::string name{};  ///< shown in place of the piece's own; empty: that one
    int colour = -1;     ///< number of its colour on screen; negative: none yet

    bool operator==(const PieceLabel&) const = default;
};

/// By id; also of pieces that are not there at the time, since a cut that is taken back brings them
/// back.
using PieceLabels = std::map<PieceId, PieceLabel>;

/// Gives every piece a colour that no other has: its own; else that of the piece that it was, where
/// that is not there any more; else one that none ever had.
/// @param before  null: the garment is new  Cost: that of `predecessors`. Pure.
PieceLabels withColours(PieceLabels labels, const Garment* before, const Garment& after);

/// One number per piece: that of its place where it has none.
std::vector<int> coloursOf(const PieceLabels& labels, const Garment& garment);

/// What a piece is called.
const std::string& nameOf(const PieceLabels& labels, const Piece& piece);
/// The subject by the name that a person gave it, where it is a piece with one.
Subject labelled(const PieceLabels& labels, Subject subject);

}  // namespace toile
