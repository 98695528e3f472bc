// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "core/pattern/pattern.h"
#include "core/pattern/walk.h"
#include "core/seam/seam_measure.h"

namespace toile {

/// The figures of a pattern as people read them: on the command line, in pages and in spreadsheets.

struct ReportTable {
    std::string title, slug;  ///< "Seams", "seams"
    std::vector<std::string> head{};
    std::vector<std::vector<std::string>> rows{};  ///< as long as the head; numbers in no locale
};

struct MeasuredSeam {
    const Seam* seam;
    SeamMeasure measure;
};

/// "mirroring +4.50 mm, ease -2.00 mm"; empty for no change.
std::string changeWords(const std::vector<LengthChange>& changes);

/// The sewn seams of which both sides are flat, the worst first.
std::vector<MeasuredSeam> seamsByError(const Garment& garment, const PieceResults& results);

/// Each piece that is drawn: how often it is cut, what from, its sizes and strains.
/// @param pattern  as it is cut (`asCut`)
ReportTable pieceTable(const Pattern& pattern, const PieceResults& results);

/// The seams, the worst first: how long their two sides are in the garment and in the pattern.
ReportTable ledgerTable(const Garment& garment, const PieceResults& results);

/// A row for each station of each seam, with the way there from the one before.
ReportTable walkTable(const Garment& garment, const std::vector<std::vector<Notch>>& notches,
                      const std::vector<SeamWalk>& walks);

/// A table as comma-separated values (RFC 4180), with its head, UTF-8. What a spreadsheet would
/// take for a formula is kept from being one.
std::string writeCsv(const ReportTable& table);

}  // namespace toile
