// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/conventions.h"

#include <algorithm>
#include <cmath>

#include "core/base/text.h"
#include "core/base/wording.h"

namespace toile {
namespace {

constexpr double kMetresBelow = 3;        // a garment of 3 m or 3 cm: neither is likely
constexpr double kCentimetresUpTo = 250;  // a floor-length dress has 160 cm, a child's shirt 250 mm
constexpr double kDecimetres[2] = {13, 19};  // MakeHuman's: a suit of 16 dm, hardly one of 16 cm

// A size that would fit a neighbouring unit too: a doll's shirt of 12 cm, or 12 dm; a coat of 170
// cm, or a sock of 170 mm.
constexpr double kDoubt[2][2] = {{3, 25}, {150, 350}};

Wording reasonFor(LengthUnit unit, const std::vector<Wording>& extents) {
    return unit == LengthUnit::Metre ? worded("largest extent %1, read as metres: %2 mm", extents)
           : unit == LengthUnit::Decimetre
               ? worded("largest extent %1, read as decimetres: %2 mm", extents)
           : unit == LengthUnit::Centimetre
               ? worded("largest extent %1, read as centimetres: %2 mm", extents)
               : worded("largest extent %1, read as millimetres", extents);
}

/// About four digits, without trailing zeros: "1.52", "1520", "0.0000001".
Wording rounded(double value) {
    if (!(value > 1e-9 && value < 1e9)) {
        return shortest(value);
    }
    int decimals = std::max(0, 3 - static_cast<int>(std::floor(std::log10(value))));
    while (decimals > 0 && fixed(value, decimals).back() == '0') {
        --decimals;
    }
    return figure(value, decimals);
}

}  // namespace

UnitGuess guessUnit(double largestExtent) {
    const double e = largestExtent;
    if (!std::isfinite(e) || e <= 0) {
        return {LengthUnit::Millimetre, true, worded("no extent, read as millimetres")};
    }
    const bool isPerson = e >= kDecimetres[0] && e <= kDecimetres[1];
    const LengthUnit unit = e < kMetresBelow        ? LengthUnit::Metre
                            : isPerson              ? LengthUnit::Decimetre
                            : e <= kCentimetresUpTo ? LengthUnit::Centimetre
                                                    : LengthUnit::Millimetre;
    const bool inDoubt = std::any_of(std::begin(kDoubt), std::end(kDoubt), [e](const auto& range) {
        return e >= range[0] && e <= range[1];
    });
    return {unit, inDoubt, reasonFor(unit, {rounded(e), rounded(e * millimetresPer(unit))})};
}

namespace {

constexpr Word<UpAxis> kAxes[] = {{UpAxis::Y, "y"}, {UpAxis::Z, "z"}};
constexpr double kFlatBySure = 0.4;   // of the extent along z: a body's depth to its height
constexpr double kFlatPerhaps = 0.6;  // a wide shirt; but a cap with its brim too
constexpr double kAlike = 0.25;       // a skirt is about as wide as deep: no evidence

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
