// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <Eigen/Geometry>

#include "core/base/result.h"
#include "core/formats/export_options.h"
#include "core/mesh/mesh_arrays.h"

namespace toile {

/// Free margin of every page, mm: printers cannot print there.
inline constexpr double kPageMargin = 10;
/// Maximum length of a page of a PDF file, mm: 14 400 points.
inline constexpr double kLongestPage = 5080;

/// The printed part of a drawing, mm.
struct PrintedContent {
    Eigen::AlignedBox2d box;     ///< around everything
    std::vector<Points2> lines;  ///< open; closed ones repeat the first point
    std::vector<Points2> areas;  ///< closed lines whose inside is printed too: the cloth
};

/// A page with a part of the sheet, which is the drawing after turning it for the paper.
struct PdfPage {
    int row = 0, column = 0;       ///< of the tiles, from the upper left one
    Eigen::AlignedBox2d window{};  ///< on the sheet, the visible part: from margin to margin
    Eigen::AlignedBox2d frame{};   ///< on the sheet, for cutting and joining
};

/// The middle of an edge that two pages share, on the sheet: each has half of a mark there.
struct SharedEdge {
    int page = 0, other = 0;  ///< indices into PdfPlan::pages: left and right, or upper and lower
    Eigen::Vector2d middle = Eigen::Vector2d::Zero();
};

struct PdfPlan {
    bool turned = false;       ///< the sheet is the drawing after a quarter turn anti-clockwise
    Eigen::Vector2d paper{};   ///< of each page, mm
    Eigen::Vector2d origin{};  ///< on a page, where the lower left corner of its window is, mm
    int rows = 0, columns = 0;
    std::vector<PdfPage> pages{};  ///< those with content, row by row
    std::vector<SharedEdge> shared{};
    /// Tiles, joined by a map; otherwise everything is on one page.
    bool isTiled = false;
    Eigen::Vector2d coverPaper{};  ///< of the page with the map, mm
};

/// Plans the pages that show all of the content. Printer papers: overlapping tiles, without empty
/// ones. Large sheets, upright or lying, and rolls, as short as the pattern turned for it allows:
/// one page if everything fits, else tiles of that size; rolls longer than kLongestPage are divided
/// evenly.
/// @param hasMap  tiles even if everything fits on one page
/// Errors: PageTooSmall if the projector's one page would be too long, with the lengths, or if
/// there would be more than kMaxTiles. Cost: linear in content and pages. Pure.
Result<PdfPlan> planPages(const PrintedContent& content, const PdfOptions& options,
                          bool hasMap = false);

inline constexpr int kMaxTiles = 4000;

/// "B3": the row as letters, the column as a number.
std::string tileName(const PdfPage& page);

/// The drawing's points on the sheet, and back.
Eigen::Vector2d onSheet(const PdfPlan& plan, const Eigen::Vector2d& point);

}  // namespace toile
