// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/io/soup.h"
#include "core/prepare/preparation.h"

namespace toile {

/// The effect of each step.
struct ScanEffect {
    int fragments = 0;        ///< removed as debris
    double debrisArea = 0;    ///< mm2
    Problems repairs;         ///< that turn the triangles into an oriented manifold; see `repair`
    bool isSurface = true;    ///< false: one-sided, or flat beyond repair: later steps were skipped
    int holes = 0;            ///< closed
    double patchArea = 0;     ///< mm2
    int openings = 0;         ///< remaining rims
    double largestMove = 0;   ///< mm, by smoothing
    double meanMove = 0;      ///< mm
    bool isRemeshed = false;  ///< false also if it was wanted and failed
    int trianglesBefore = 0;
    int triangles = 0;
};

struct PreparedScan {
    PolygonSoup soup;         ///< in the file's unit
    std::vector<int> debris;  ///< faces of the scan removed as debris; ascending
    ScanEffect effect;
};

/// Turns a scan into a sheet by the requested steps, in this order: removes debris (`findDebris`),
/// merges equal positions, makes an oriented manifold (`repair`), closes holes (`findHoles`),
/// smooths noise, and remeshes. Large openings stay. If only debris is removed, polygons are kept.
/// Otherwise they become triangles with their faces' names; a patch has the names of an adjacent
/// face. The UV map is kept if no triangle is new. After remeshing there are neither names nor map,
/// and pieces are divided by connectivity.
/// @param millimetres  per unit of the file
/// Errors: Cancelled, checked between steps, and many times within smoothing and remeshing.
/// Cost: n log n; a second for 60 000 triangles, two more for remeshing. Same input, same output.
/// Pure.
Result<PreparedScan> prepareScan(const PolygonSoup& soup, double millimetres,
                                 const ScanSteps& steps, Progress& progress);

}  // namespace toile
