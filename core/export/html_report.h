// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "core/export/export_source.h"

namespace toile {

/// The whole pattern as one page for a browser, with nothing beside it: how many pieces and seams,
/// how well they fit, the drawing, and the tables of report_tables.h. The same input gives the same
/// bytes. Cost: that of the drawing and of `walkGarment`. Pure.
std::string writeHtmlReport(const ExportSource& source);

}  // namespace toile
