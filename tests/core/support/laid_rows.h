// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/toile/toile.h"

namespace toile {

/// The pattern of a garment in rows, with the usual settings of its pieces.
inline LaidOutPattern inRows(const Garment& garment, const PieceResults& results,
                             const LineSettings& lines = {}, bool byHalf = false) {
    return makePattern(garment, results, {.lines = lines, .byHalf = byHalf}).laid;
}

}  // namespace toile
