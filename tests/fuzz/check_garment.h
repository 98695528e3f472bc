// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace toile::fuzz {

/// The whole road on an OFF file in memory: pieces, cuts by a user's line and automatic ones,
/// seams, flat pieces by both methods, every format written.
/// @return the first promise that is broken, in words; empty where all are kept: indices in range,
///         no area lost by cutting, flat points finite, no NaN in a file
/// Cost: that of flattening; files of more than 400 faces are passed over. Re-entrant.
std::string whatBreaksOnTheWay(std::string bytes);

}  // namespace toile::fuzz
