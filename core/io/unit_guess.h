// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/length_unit.h"
#include "core/base/wording.h"

namespace toile {

/// A proposal for the unit of a file that states none.
struct UnitGuess {
    LengthUnit unit;
    bool inDoubt;    ///< the size would fit another unit nearly as well
    Wording reason;  ///< for a person: "largest extent 1.52, read as metres: 1520 mm"
};

/// Proposes a unit from the largest extent of the garment, in file units: below 3 metres, to 250
/// centimetres, above millimetres; never inches. In doubt from 3 to 25 and from 150 to 350.
UnitGuess guessUnit(double largestExtent);

}  // namespace toile
