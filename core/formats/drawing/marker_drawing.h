// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/formats/drawing/drawing.h"
#include "core/marker/cloth_marker.h"

namespace toile {

/// A marker for exports: labels omit the quantity, because each copy is drawn, and the note on the
/// wrong side, which no mirrored copy shows.
struct DrawnMarker {
    LaidOutPattern laid;  ///< the pattern's pieces at their places; `whole` and its pattern empty
    Drawing drawing;
};

/// The page of a marker (`draw`), with the cloth as separate paths: `cloth-<k>`, the edges of each
/// part, `cloth-<k>-zone-<z>`, holes and grades, `cloth-fold`, and its title as text, `cloth-text`.
/// @param pattern  at its place on the cloth (`patternOnCloth`)  @param title  text above the cloth
DrawnMarker drawMarker(const Pattern& pattern, const ClothMarker& marker,
                       const MarkerSettings& settings, const std::vector<std::string>& title,
                       DrawingWords words = {});

/// Whether a marker can be written in the format: only formats with a page can.
bool holdsMarkers(const std::filesystem::path& path);

}  // namespace toile
