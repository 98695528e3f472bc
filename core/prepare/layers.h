// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "core/base/progress.h"
#include "core/base/wording.h"
#include "core/prepare/file_surface.h"

namespace toile {

/// Sheets inside each other, like a lining in its shell.
struct Layers {
    std::vector<int> of;  ///< per triangle, the outermost is 0
    int count = 0;
    double apart = 0;  ///< distance between layers, mm, weighted by area
    /// Whether the garment's shape shows the outer side. False for flat sheets, which might be
    /// front and back: then the file's first sheet is the outermost.
    bool isSure = false;
};

/// Finds the layers of a file by its connected parts: a part with others outside it, close to it
/// over most of its area, is as many layers further in. A part that lies on no other belongs to the
/// layer that it is sewn to; so does a small one that would be a layer of its own, like a button on
/// a lining. The winding of faces does not matter. Nothing if less than a tenth of the area lies
/// inside other parts.
/// @param surface  mm; faces may be doubled  @param progress  if cancelled, nothing is found
/// Cost: n log n, and rays of at most 400 triangles of each part. Pure.
std::optional<Layers> findLayers(const FileSurface& surface, const Progress& progress);

/// "surfaces that lie on each other, 4.0 mm apart"
Wording inWords(const Layers& layers);

}  // namespace toile
