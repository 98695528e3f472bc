// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "core/formats/export_source.h"

namespace toile {

struct ReportPicture {
    std::string caption;
    std::string png;  ///< in base 64
};

/// Provides pictures of the garment for reports, which the core cannot draw. Not thread-safe: call
/// it once, before any export.
void provideReportPictures(std::vector<ReportPicture> (*make)(const ExportSource&));

/// The whole pattern as a self-contained page for a browser: number of pieces and seams, their
/// fit, the drawing, pictures of the garment if available, and the tables of report_tables.h. The
/// same input gives the same bytes; only pictures may differ between machines.
/// Cost: that of the drawing, of `walkGarment` and of the pictures.
std::string writeHtmlReport(const ExportSource& source);

}  // namespace toile
