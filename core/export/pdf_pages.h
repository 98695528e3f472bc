// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <Eigen/Geometry>

#include "core/base/result.h"
#include "core/export/export_options.h"
#include "core/mesh/mesh_arrays.h"

namespace toile {

/// Left free at the edges of every page, mm: printers cannot print there.
inline constexpr double kPageMargin = 10;
/// No page of a PDF file is longer, mm: 14 400 points.
inline constexpr double kLongestPage = 5080;

/// What of a drawing is printed, mm.
struct PrintedContent {
    Eigen::AlignedBox2d box;     ///< around all of it
    std::vector<Points2> lines;  ///< open; of closed ones the first point is repeated
    std::vector<Points2> areas;  ///< closed lines whose inside is wanted too: the cloth
};

/// A page that shows a part of the sheet, which is the drawing as it is turned for the paper.
struct PdfPage {
    int row = 0, column = 0;       ///< of the tiles, from the upper left one
    Eigen::AlignedBox2d window{};  ///< on the sheet, what is shown: from margin to margin
    Eigen::AlignedBox2d frame{};   ///< on the sheet, along which it is cut and joined to others
};

/// The middle of an edge that two pages share, on the sheet: both have half of a mark there.
struct SharedEdge {
    int page = 0, other = 0;  ///< indices into PdfPlan::pages: left and right, or upper and lower
    Eigen::Vector2d middle = Eigen::Vector2d::Zero();
};

struct PdfPlan {
    bool turned = false;       ///< the sheet is the drawing after a quarter turn anti-clockwise
    Eigen::Vector2d paper{};   ///< of each page, mm
    Eigen::Vector2d origin{};  ///< on a page, where the lower left corner of its window is, mm
    int rows = 0, columns = 0;
    std::vector<PdfPage> pages{};  ///< those that show something, row by row
    std::vector<SharedEdge> shared{};
    /// Tiles, to be joined by a map; else everything is on one page.
    bool isTiled = false;
    Eigen::Vector2d coverPaper{};  ///< of the page with the map, mm
};

/// Which pages show all of the content, and where. Papers of printers: tiles that overlap, without
/// those that would be empty. Large sheets, upright or lying, and rolls, as short as the pattern
/// turned for it allows: one page where everything fits, else tiles of that size; rolls longer than
/// kLongestPage are divided evenly.
/// @param hasMap  tiles even where everything fits on one page
/// Errors: PageTooSmall where the projector's one page would be too long, with the lengths, or
/// where there would be more than kMostTiles. Cost: linear in content and pages. Pure.
Result<PdfPlan> planPages(const PrintedContent& content, const PdfOptions& options,
                          bool hasMap = false);

inline constexpr int kMostTiles = 4000;

/// "B3": the row as letters, the column as a number.
std::string tileName(const PdfPage& page);

/// The drawing's points on the sheet, and back.
Eigen::Vector2d onSheet(const PdfPlan& plan, const Eigen::Vector2d& point);

}  // namespace toile
