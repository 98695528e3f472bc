// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/garment/garment.h"
#include "core/pattern/pattern.h"
#include "core/pattern/walk.h"
#include "core/seam/seam_measure.h"

namespace toile {

/// Tables of a pattern for people: on the command line, in pages and in spreadsheets.

struct ReportTable {
    std::string title, slug;  ///< "Seams", "seams"
    std::vector<std::string> head{};
    std::vector<std::vector<std::string>> rows{};  ///< as long as the head; no locale
};

struct MeasuredSeam {
    const Seam* seam;
    SeamMeasure measure;
};

/// "mirroring +4.50 mm, ease -2.00 mm"; empty for no change.
std::string changeWords(const std::vector<LengthChange>& changes);

/// The sewn seams with two flat sides, the largest error first.
std::vector<MeasuredSeam> seamsByError(const Garment& garment, const PieceResults& results);

/// Each drawn piece: its quantity, material, sizes and strains.
/// @param pattern  as cut (`asCut`)
ReportTable pieceTable(const Pattern& pattern, const PieceResults& results);

/// The seams, the largest error first: the lengths of both sides in the garment and the pattern.
ReportTable ledgerTable(const Garment& garment, const PieceResults& results);

/// The free edges of drawn pieces with allowances: their kinds and widths.
/// @param pattern  as cut
ReportTable edgeTable(const Pattern& pattern);

/// A row for each station of each seam, with the distance from the previous one.
ReportTable walkTable(const Garment& garment, const std::vector<std::vector<Notch>>& notches,
                      const std::vector<SeamWalk>& walks);

/// A table as comma-separated values (RFC 4180), with its head, UTF-8. Text that a spreadsheet
/// would read as a formula is escaped.
std::string writeCsv(const ReportTable& table);

/// "start", "notch" or "end": the station of a walk with this index.
std::string_view stationWord(const SeamWalk& walk, std::size_t station);

/// The results of walking the seams, as JSON (docs/patterns.md).
/// @param notches  per seam, those of the walks
std::string writeWalk(const Garment& garment, const std::vector<std::vector<Notch>>& notches,
                      const std::vector<SeamWalk>& walks);

}  // namespace toile
