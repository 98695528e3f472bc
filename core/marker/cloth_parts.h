// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/marker/cloth_marker.h"
#include "core/nest/nest.h"

// For the sources of this folder and the marker in the window.
namespace toile::cloth {

/// Sheets or hides as they lie, one after the other along x; none: a roll. Sheets one for each
/// copy, but no more than a nest's numbers hold.
std::vector<ClothPart> clothParts(const MarkerSettings& settings, std::size_t copies);

/// Across all of them, or of the roll; of folded cloth half of it.
double widthOnCloth(const MarkerSettings& settings, const Fabric& fabric);

/// Tells the nest where the parts end, and which items may not lie in which zones.
/// @param grades  the worst that each item of the instance may have, 0: any
void addParts(const std::vector<ClothPart>& parts, const std::vector<int>& grades,
              NestInstance& instance);

/// Of a marker whose copies lie where they are to: on which parts, how much of these is used. Its
/// length is at least what it says, and up to the last copy.
void measureOn(const std::vector<ClothPart>& parts, const Pattern& pattern, ClothMarker& marker);

/// Index of the part in which a line lies, by its leftmost point.
int partAt(const std::vector<ClothPart>& parts, double x);

/// Area of the part without its holes, mm2.
double areaOf(const ClothPart& part);

}  // namespace toile::cloth
