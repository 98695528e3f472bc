// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/marker/cloth_marker.h"
#include "core/nest/nest.h"

// For the sources of this folder and the marker in the window.
namespace toile::cloth {

/// Sheets or hides one after the other along x; empty for a roll. One sheet for each copy, but no
/// more than fit the range of a nest's coordinates.
std::vector<ClothPart> clothParts(const MarkerSettings& settings, std::size_t copies);

/// Width of all of them, or of the roll; half of it for folded cloth.
double widthOnCloth(const MarkerSettings& settings, const Fabric& fabric);

/// Adds the ends of the parts to the nest, and the zones that items must avoid.
/// @param grades  worst allowed grade of each item of the instance, 0: any
void addParts(const std::vector<ClothPart>& parts, const std::vector<int>& grades,
              NestInstance& instance);

/// Sets the parts used and the use of a marker with placed copies. Its length is at least the
/// stored one, and reaches the last copy.
void measureOn(const std::vector<ClothPart>& parts, const Pattern& pattern, ClothMarker& marker);

/// Index of the part that a line is on, by the line's leftmost point.
int partAt(const std::vector<ClothPart>& parts, double x);

/// Area of the part without its holes, mm2.
double areaOf(const ClothPart& part);

}  // namespace toile::cloth
