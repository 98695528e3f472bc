// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string_view>

#include <Eigen/Core>

#include "core/base/wording.h"

namespace toile {

/// The axis of a file that points up. Inside Toile it is always y.
enum class UpAxis { Y, Z };

/// A proposal for the up axis of a file that states none.
struct UpGuess {
    UpAxis axis = UpAxis::Y;
    bool inDoubt = false;  ///< the other axis would be as likely
    Wording reason;        ///< for a person
};

/// Proposes z where the garment is flattest along y, by far, and no wider than deep by chance: a
/// body is flattest from front to back, never from head to foot. Else y, which most programs write.
/// @param extents  of the bounding box, any unit
UpGuess guessUpAxis(const Eigen::Vector3d& extents);

/// Turns a point of a file so that y is up, and back. Exact: coordinates change places and signs.
Eigen::RowVector3d withYUp(UpAxis axis, const Eigen::RowVector3d& inFile);
Eigen::RowVector3d asInFile(UpAxis axis, const Eigen::RowVector3d& yUp);

/// "y", "z".
std::string_view name(UpAxis axis);
std::optional<UpAxis> parseUpAxis(std::string_view text);

}  // namespace toile
