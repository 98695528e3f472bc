// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "core/export/export_source.h"

namespace toile {

struct ReportPicture {
    std::string caption;
    std::string png;  ///< in base 64
};

/// Gives reports pictures of the garment, which the core cannot draw. Not thread-safe: once, before
/// anything is written.
void provideReportPictures(std::vector<ReportPicture> (*make)(const ExportSource&));

/// The whole pattern as one page for a browser, with nothing beside it: how many pieces and seams,
/// how well they fit, the drawing, pictures of the garment where there are some, and the tables of
/// report_tables.h. The same input gives the same bytes, on another machine but for the pictures.
/// Cost: that of the drawing, of `walkGarment` and of the pictures.
std::string writeHtmlReport(const ExportSource& source);

}  // namespace toile
