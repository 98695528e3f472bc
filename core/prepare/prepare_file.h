// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Geometry>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/base/wording.h"
#include "core/io/soup.h"
#include "core/mesh/mesh_arrays.h"
#include "core/prepare/preparation.h"

namespace toile {

/// The mirror plane of half a garment, which contains all rims of one side.
struct HalfPlane {
    Eigen::Hyperplane<double, 3> plane;  ///< mm, in the file's axes; with unit normal
    double length = 0;                   ///< of the rims in it, mm
    bool isCompleted = false;            ///< the mirror image was added
};

/// How a file was read.
struct FileReading {
    FileKind kind = FileKind::Sheet;
    bool isStated = false;  ///< by the user; else detected
    Wording evidence;       ///< why it was detected, for display; may be empty
    std::optional<HalfPlane> half{};
    /// Per resulting face: its layer, the outermost is 0; empty if there is only one.
    std::vector<int> layerOfFace{};
    MeshArrays leftOut{Points3(0, 3), Triangles(0, 3)};  ///< mm, in the file's axes
};

struct PreparedFile {
    std::shared_ptr<const PolygonSoup> soup;  ///< the file's own soup if nothing was done
    FileReading reading;
    Problems problems;  ///< changes made, and possible problems
};

/// Prepares a file for the division into pieces. Without a choice of the user it acts only if the
/// kind of file and the intent are certain: of a shell it takes one surface. A scan is prepared if
/// the user says that it is a scan; otherwise a note says that it looks like a scan.
/// @param soup         welded   @param wasSoup  its vertices were merged by `weldSoup`
/// @param millimetres  per unit of the file   @param name  of the file, for the notes
/// Errors: Cancelled. Cost: those of `recognise`, `sheetOf` and `prepareScan`. Pure.
Result<PreparedFile> prepareFile(std::shared_ptr<const PolygonSoup> soup, bool wasSoup,
                                 const Preparation& preparation, double millimetres,
                                 const std::string& name, const Progress& progress);

}  // namespace toile
