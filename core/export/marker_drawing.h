// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/export/drawing.h"
#include "core/marker/cloth_marker.h"

namespace toile {

/// A marker as exports want it: labels say nothing of how often a piece is cut, as each copy lies
/// there, and nothing of its wrong side, which no image shows.
struct DrawnMarker {
    LaidOutPattern laid;  ///< of the pattern's pieces where they lie; `whole` and its pattern empty
    Drawing drawing;
};

/// The page of a marker (`draw`), with what the cloth is of as paths of its own: `cloth-<k>`, the
/// edges of each part, `cloth-<k>-zone-<z>`, holes and grades, `cloth-fold`, and what it says as
/// text, `cloth-text`.
/// @param pattern  as it lies (`patternOnCloth`)  @param title  what is written above the cloth
DrawnMarker drawMarker(const Pattern& pattern, const ClothMarker& marker,
                       const MarkerSettings& settings, const std::vector<std::string>& title,
                       DrawingWords words = {});

/// True of formats that hold a page: of those a marker is written in.
bool holdsMarkers(const std::filesystem::path& path);

}  // namespace toile
