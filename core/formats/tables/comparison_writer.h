// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "core/compare/comparison.h"
#include "core/garment/garment.h"

namespace toile {

/// A comparison for people; every row is as long as the head. Cells are ASCII numbers, independent
/// of the locale, "-" if there is no figure. Optional columns without any figure may be left out
/// (CriterionTraits::isOptional).
struct ComparisonTable {
    std::string title;  ///< the files or one piece, and their contents
    std::vector<std::string> head;
    std::vector<std::vector<std::string>> rows;  ///< one per method
};

/// The comparison of the whole garment and, if wanted, of each piece in the garment's order.
std::vector<ComparisonTable> comparisonTables(const Garment& garment, const Comparison& comparison,
                                              bool perPiece);

/// "nearer to the given panels than any method that keeps seam lengths: lscm (2.10 mm against 2.41
/// of isometric)"; empty if that is not true.
std::string nearerSentence(const Comparison& comparison);

/// The tables as GitHub's Markdown, the whole garment's first, with the sentence below it.
/// @param perPiece  adds a table per piece
std::string writeComparisonMarkdown(const Garment& garment, const Comparison& comparison,
                                    bool perPiece);

/// All figures with full digits, per method and per piece, as JSON (docs/comparison.md). Never NaN
/// or Infinity: null.
std::string writeComparison(const Garment& garment, const Comparison& comparison);

}  // namespace toile
