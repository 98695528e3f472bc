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

/// The plane in which all rims of one side of a garment lie that is there by half.
struct HalfPlane {
    Eigen::Hyperplane<double, 3> plane;  ///< mm, in the file's axes; its normal is of unit length
    double length = 0;                   ///< of the rims that lie in it, mm
    bool isCompleted = false;            ///< the mirror image was added
};

/// As what a file was read.
struct FileReading {
    FileKind kind = FileKind::Sheet;
    bool isStated = false;  ///< by a person; else recognised
    Wording evidence;       ///< what it was recognised by, for a person; may be empty
    std::optional<HalfPlane> half{};
    /// Per face of what came of it: which layer it belongs to, from the outermost, 0; empty where
    /// there is but one.
    std::vector<int> layerOfFace{};
    MeshArrays leftOut{Points3(0, 3), Triangles(0, 3)};  ///< mm, in the file's axes
};

struct PreparedFile {
    std::shared_ptr<const PolygonSoup> soup;  ///< that of the file where nothing was done
    FileReading reading;
    Problems problems;  ///< what was done, and what might be
};

/// Makes of a file what can be divided into pieces. By itself it does that where it is sure what
/// the file is and what was meant: of a shell it takes one surface. A scan is prepared where a
/// person says that it is one; else that it looks like one is said.
/// @param soup         welded   @param wasSoup  its vertices were joined by `weldSoup`
/// @param millimetres  per unit of the file   @param name  of the file, for the notes
/// Errors: Cancelled. Cost: those of `recognise`, `sheetOf` and `prepareScan`. Pure.
Result<PreparedFile> prepareFile(std::shared_ptr<const PolygonSoup> soup, bool wasSoup,
                                 const Preparation& preparation, double millimetres,
                                 const std::string& name, const Progress& progress);

}  // namespace toile
