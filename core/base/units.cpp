// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/units.h"

#include <iterator>

#include "core/base/words.h"

namespace toile {
namespace {

/// In the order of the enumeration, as the numbers below.
constexpr Word<LengthUnit> kSymbols[] = {{LengthUnit::Millimetre, "mm"},
                                         {LengthUnit::Centimetre, "cm"},
                                         {LengthUnit::Metre, "m"},
                                         {LengthUnit::Inch, "in"}};
constexpr double kMillimetres[] = {1, 10, 1000, 25.4};

}  // namespace

double millimetresPer(LengthUnit unit) {
    return kMillimetres[static_cast<std::size_t>(unit)];
}

std::string_view symbol(LengthUnit unit) {
    return wordOf(kSymbols, unit);
}

std::optional<LengthUnit> parseLengthUnit(std::string_view text) {
    return parseWord(kSymbols, text);
}

}  // namespace toile
