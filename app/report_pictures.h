// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/export/html_report.h"

namespace toile::app {

/// What the HTML report shows beside the drawing: the garment and its pattern as the views have
/// them, with the checkerboard and with the strain. None where there is no OpenGL without a window.
/// Any thread without a context of its own, one at a time; before there is an application, the main
/// thread: it makes one then, without a screen, that stays to the end of the program. Cost: that of
/// the scene, and tenths of a second where the processor draws.
std::vector<ReportPicture> reportPictures(const ExportSource& source);

}  // namespace toile::app
