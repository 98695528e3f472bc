// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/io/soup.h"
#include "core/prepare/preparation.h"

namespace toile {

/// What each step did.
struct ScanEffect {
    int fragments = 0;        ///< that went as debris
    double debrisArea = 0;    ///< mm2
    Problems repairs;         ///< that make an oriented manifold of the triangles; see `repair`
    bool isSurface = true;    ///< false: one-sided, or flat beyond repair: then that was all
    int holes = 0;            ///< that were closed
    double patchArea = 0;     ///< mm2
    int openings = 0;         ///< rims that are left
    double largestMove = 0;   ///< mm, by smoothing
    double meanMove = 0;      ///< mm
    bool isRemeshed = false;  ///< false also where it was wanted and could not be done
    int trianglesBefore = 0;
    int triangles = 0;
};

struct PreparedScan {
    PolygonSoup soup;         ///< in the file's unit
    std::vector<int> debris;  ///< faces of the scan that went as debris; ascending
    ScanEffect effect;
};

/// Makes a sheet of a scan, by the steps that are wanted, in this order: debris goes
/// (`findDebris`), equal positions become one, and all becomes an oriented manifold (`repair`);
/// holes are closed (`findHoles`), noise is smoothed, triangles are made anew. Large openings stay.
/// Where nothing but debris is to be done, polygons stay as they are. Otherwise they become
/// triangles, which have their faces' names; a patch has those of a face beside it. The UV map
/// stays where no triangle is new. Remeshed, there are neither names nor map, and pieces are told
/// apart by whether they hang together.
/// @param millimetres  per unit of the file
/// Errors: Cancelled, heard between steps, and many times within smoothing and remeshing.
/// Cost: n log n; a second for 60 000 triangles, two more where they are made anew. Same input,
/// same output. Pure.
Result<PreparedScan> prepareScan(const PolygonSoup& soup, double millimetres,
                                 const ScanSteps& steps, Progress& progress);

}  // namespace toile
