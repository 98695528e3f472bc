// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "core/base/progress.h"
#include "core/base/wording.h"
#include "core/prepare/file_surface.h"

namespace toile {

/// Sheets that lie inside each other, as a lining in its shell.
struct Layers {
    std::vector<int> of;  ///< per triangle, from the outermost, 0
    int count = 0;
    double apart = 0;  ///< how far one lies from the next, mm, by area
    /// Which side is the outer one was seen by the garment's shape. False of flat sheets, which
    /// might as well be front and back: then the file's first sheet is the outermost.
    bool isSure = false;
};

/// Finds the layers of a file by its connected parts: one that has others outside it, near it over
/// most of its area, is as many layers further in as these are. A part that lies on none belongs to
/// the layer that it is sewn to; so does a small one that would be a layer of its own, as a button
/// on a lining. How faces are turned does not matter. None where less than a tenth of the area lies
/// inside other parts.
/// @param surface  mm; faces may be there twice  @param progress  cancelled, nothing is found
/// Cost: n log n, and rays of at most 400 triangles of each part. Pure.
std::optional<Layers> findLayers(const FileSurface& surface, const Progress& progress);

/// "surfaces that lie on each other, 4.0 mm apart"
Wording inWords(const Layers& layers);

}  // namespace toile
