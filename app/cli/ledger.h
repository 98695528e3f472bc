// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <iosfwd>

#include "core/pipeline/pipeline.h"

namespace toile {

/// The seams as a table, the worst first: how long their two sides are in the garment and in the
/// pattern. Free edges are left out.
void printLedger(const Garment& garment, const PieceResults& results, std::ostream& out);

/// One line: how many seams there are, and by how much the worst of them does not fit.
void printSeamSummary(const Garment& garment, const PieceResults& results, std::ostream& out);

}  // namespace toile
