// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "core/toile/toile.h"

namespace toile::fuzz {

/// The whole pipeline on an OFF file in memory: pieces, cuts by a user's line and automatic ones,
/// seams, flat pieces by both methods, every format written.
/// @return the first promise that is broken, in words; empty where all are kept: indices in range,
///         no area lost by cutting, flat points finite, no NaN in a file
/// Cost: that of flattening; files of more than 400 faces are passed over. Re-entrant.
std::string whatBreaksOnTheWay(std::string bytes);

/// Promises of a garment as cut and sewn: no area lost by cutting, seams between its pieces and of
/// finite lengths. Empty where all are kept. Linear.
std::string whatBreaksIn(const Garment& garment);
/// Promises of what comes of it: flat points and all that is written are finite. Linear.
std::string whatBreaksIn(const Garment& garment, const PieceResults& results,
                         const LaidOutPattern& laid);

}  // namespace toile::fuzz
