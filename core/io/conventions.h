// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string_view>

#include <Eigen/Core>

#include "core/base/units.h"
#include "core/base/wording.h"

namespace toile {

/// A proposal for the unit of a file that does not state one.
struct UnitGuess {
    LengthUnit unit;
    bool inDoubt;    ///< another unit would fit nearly as well
    Wording reason;  ///< for a person: "largest extent 1.52, read as metres: 1520 mm"
};

/// Proposes a unit from the largest extent of the garment, in file units: below 3 metres, up to 250
/// centimetres, above millimetres; never inches. From 13 to 19 decimetres, the height of a person.
/// In doubt from 3 to 25 and from 150 to 350.
UnitGuess guessUnit(double largestExtent);

/// The axis of a file that points up. Inside Toile it is always y.
enum class UpAxis { Y, Z };

/// A proposal for the up axis of a file that does not state one.
struct UpGuess {
    UpAxis axis = UpAxis::Y;
    bool inDoubt = false;  ///< the other axis is as likely
    Wording reason;        ///< for a person
};

/// Proposes z if the garment is clearly flattest along y and not about as wide as deep: a body is
/// flattest from front to back, never from head to foot. Else y, which most programs write.
/// @param extents  of the bounding box, any unit
UpGuess guessUpAxis(const Eigen::Vector3d& extents);

/// Turns a point of a file so that y is up, and back. Exact: only swaps and negates.
Eigen::RowVector3d withYUp(UpAxis axis, const Eigen::RowVector3d& inFile);
Eigen::RowVector3d asInFile(UpAxis axis, const Eigen::RowVector3d& yUp);

/// "y", "z".
std::string_view name(UpAxis axis);
std::optional<UpAxis> parseUpAxis(std::string_view text);

}  // namespace toile
