// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/pattern/pattern.h"
#include "core/pattern/placement.h"

namespace toile {

/// How much of a cloth one of each piece takes as the pieces lie, the warp upwards.
struct ClothNeed {
    std::string material;  ///< what these pieces are cut from; empty: the garment's own fabric
    double length = 0;     ///< along the warp, mm
    double across = 0;     ///< mm
    double width = 0;      ///< of the cloth (Fabric::width), mm

    bool fits() const { return across <= width; }
    bool operator==(const ClothNeed&) const = default;
};

/// One for each cloth that flat pieces are cut from, the garment's own first, then by name; with
/// allowances where there are some.
/// @param placements  one per piece of the pattern, as for `layOut`, or none
/// Cost: linear. Pure.
std::vector<ClothNeed> clothNeeds(const Pattern& pattern,
                                  const std::vector<std::optional<Placement>>& placements,
                                  const Fabric& own);

/// "1072 mm of cloth 1400 mm wide", "the pieces lie 1500 mm wide, wider than the cloth: 1400 mm".
std::string sentence(const ClothNeed& need);

}  // namespace toile
