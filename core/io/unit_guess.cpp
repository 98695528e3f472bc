// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/unit_guess.h"

#include <algorithm>
#include <cmath>

#include "core/base/text.h"

namespace toile {
namespace {

constexpr double kMetresBelow = 3;        // a garment of 3 m or 3 cm: neither is likely
constexpr double kCentimetresUpTo = 250;  // a floor-length dress has 160 cm, a child's shirt 250 mm

// Where a size would fit a neighbouring unit too: a doll's shirt of 12 cm, or 12 dm; a coat of
// 170 cm, or a sock of 170 mm.
constexpr double kDoubt[2][2] = {{3, 25}, {150, 350}};

std::string_view pluralOf(LengthUnit unit) {
    switch (unit) {
        case LengthUnit::Millimetre:
            return "millimetres";
        case LengthUnit::Centimetre:
            return "centimetres";
        case LengthUnit::Metre:
            return "metres";
        case LengthUnit::Inch:
            return "inches";
    }
    return "";
}

/// About four digits, without needless zeros: "1.52", "1520", "0.0000001".
std::string rounded(double value) {
    if (!(value > 1e-9 && value < 1e9)) {
        return shortest(value);
    }
    const int decimals = std::max(0, 3 - static_cast<int>(std::floor(std::log10(value))));
    std::string text = fixed(value, decimals);
    if (decimals > 0) {
        text.erase(text.find_last_not_of('0') + 1);
        text.erase(text.find_last_not_of('.') + 1);
    }
    return text;
}

}  // namespace

UnitGuess guessUnit(double largestExtent) {
    const double e = largestExtent;
    if (!std::isfinite(e) || e <= 0) {
        return {LengthUnit::Millimetre, true, "no extent, read as millimetres"};
    }
    const LengthUnit unit = e < kMetresBelow        ? LengthUnit::Metre
                            : e <= kCentimetresUpTo ? LengthUnit::Centimetre
                                                    : LengthUnit::Millimetre;
    const bool inDoubt = std::any_of(std::begin(kDoubt), std::end(kDoubt), [e](const auto& range) {
        return e >= range[0] && e <= range[1];
    });
    std::string reason = "largest extent " + rounded(e) + ", read as ";
    reason += pluralOf(unit);
    if (unit != LengthUnit::Millimetre) {
        reason += ": " + rounded(e * millimetresPer(unit)) + " mm";
    }
    return {unit, inDoubt, reason};
}

}  // namespace toile
