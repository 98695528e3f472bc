// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/garment/piece.h"

namespace toile {

/// True where one may take the other's place: the same name, mesh and origin in the file.
/// Cost: linear. Pure.
bool isSamePiece(const Piece& a, const Piece& b);

}  // namespace toile
