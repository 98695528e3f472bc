// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/up_axis.h"

#include <cmath>

#include "core/base/words.h"

namespace toile {
namespace {

constexpr Word<UpAxis> kAxes[] = {{UpAxis::Y, "y"}, {UpAxis::Z, "z"}};
constexpr double kFlatBySure = 0.4;   // of the extent along z: a body's depth to its height
constexpr double kFlatPerhaps = 0.6;  // a wide shirt; but a cap with its brim too
constexpr double kAlike = 0.25;       // a skirt is about as wide as deep: nothing to see there

}  // namespace

UpGuess guessUpAxis(const Eigen::Vector3d& extents) {
    const double x = extents.x();
    const double y = extents.y();
    const double z = extents.z();
    const bool wideAsDeep = std::abs(x - z) <= kAlike * std::max(x, z);
    if (y < x && y < kFlatBySure * z && !wideAsDeep) {
        return {UpAxis::Z, false,
                worded("flattest along y, as a body is from front to back: z is up")};
    }
    if (y < x && y < kFlatPerhaps * z && !wideAsDeep) {
        return {UpAxis::Y, true, worded("flatter along y than along z: z may be up")};
    }
    return {UpAxis::Y, false, worded("y is up, as in most files")};
}

Eigen::RowVector3d withYUp(UpAxis axis, const Eigen::RowVector3d& inFile) {
    return axis == UpAxis::Y ? inFile : Eigen::RowVector3d(inFile.x(), inFile.z(), -inFile.y());
}

Eigen::RowVector3d asInFile(UpAxis axis, const Eigen::RowVector3d& yUp) {
    return axis == UpAxis::Y ? yUp : Eigen::RowVector3d(yUp.x(), -yUp.z(), yUp.y());
}

std::string_view name(UpAxis axis) {
    return wordOf(kAxes, axis);
}

std::optional<UpAxis> parseUpAxis(std::string_view text) {
    return parseWord(kAxes, text);
}

}  // namespace toile
