// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/units.h"

#include <algorithm>
#include <charconv>
#include <iterator>

#include "core/base/text.h"
#include "core/base/words.h"

namespace toile {
namespace {

/// In the order of the enumeration, like the numbers below.
constexpr Word<LengthUnit> kSymbols[] = {{LengthUnit::Millimetre, "mm"},
                                         {LengthUnit::Centimetre, "cm"},
                                         {LengthUnit::Decimetre, "dm"},
                                         {LengthUnit::Metre, "m"},
                                         {LengthUnit::Inch, "in"}};
constexpr double kMillimetres[] = {1, 10, 100, 1000, 25.4};
constexpr double kSmallestUnit = 1e-6, kLargestUnit = 1e6;

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

std::optional<FileUnit> FileUnit::ofMillimetres(double millimetres) {
    return millimetres >= kSmallestUnit && millimetres <= kLargestUnit
               ? std::optional(FileUnit(millimetres))
               : std::nullopt;
}

std::optional<LengthUnit> FileUnit::named() const {
    const auto found = std::ranges::find(kMillimetres, millimetres_);
    return found == std::end(kMillimetres)
               ? std::nullopt
               : std::optional(kLengthUnits[found - std::begin(kMillimetres)]);
}

std::string unitText(const FileUnit& unit) {
    const auto named = unit.named();
    return named ? std::string(symbol(*named)) : shortest(unit.millimetres()) + " mm";
}

std::optional<FileUnit> parseFileUnit(std::string_view text) {
    if (const auto named = parseLengthUnit(text)) {
        return *named;
    }
    double number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    text.remove_prefix(static_cast<std::size_t>(end - text.data()));
    if (text.starts_with(' ')) {
        text.remove_prefix(1);
    }
    const auto of = parseLengthUnit(text);
    return error == std::errc() && of ? FileUnit::ofMillimetres(number * millimetresPer(*of))
                                      : std::nullopt;
}

}  // namespace toile
