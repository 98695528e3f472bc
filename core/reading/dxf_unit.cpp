// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/reading/dxf_unit.h"

#include <algorithm>
#include <cmath>

#include "core/base/text.h"

namespace toile {
namespace {

// Plausible sizes of the largest piece, mm: outside the outer limits it cannot be cut from cloth;
// between the inner two limits the size is usual.
constexpr double kTiny = 60, kSmall = 150, kLong = 2500, kHuge = 6000;

bool isPossible(LengthUnit unit, double extent) {
    const double size = extent * millimetresPer(unit);
    return extent == 0 || (size >= kTiny && size <= kHuge);
}

bool isUsual(LengthUnit unit, double extent) {
    const double size = extent * millimetresPer(unit);
    return extent == 0 || (size >= kSmall && size <= kLong);
}

/// The unit that gives a piece of this extent a usual size, or the nearest to it.
LengthUnit bySize(double extent) {
    for (const LengthUnit unit :
         {LengthUnit::Millimetre, LengthUnit::Centimetre, LengthUnit::Metre}) {
        if (isUsual(unit, extent)) {
            return unit;
        }
    }
    return extent > kLong ? LengthUnit::Millimetre : LengthUnit::Centimetre;
}

/// The unit that the file states, or if its size is impossible, the unit by size.
DxfUnit judged(LengthUnit said, const Wording& source, double extent) {
    const auto length = [extent](LengthUnit unit) { return figure(extent * millimetresPer(unit)); };
    if (isPossible(said, extent)) {
        if (isUsual(said, extent)) {
            return {said, source};
        }
        return {said, worded("%1; the largest piece is %2 mm then", {source, length(said)}), true};
    }
    const LengthUnit other = bySize(extent);
    return {other,
            worded("%1, but the largest piece would be %2 mm; in %3 it is %4 mm",
                   {source, length(said), Wording(std::string(symbol(other))), length(other)}),
            true};
}

}  // namespace

std::optional<LengthUnit> headerUnit(const DxfDocument& document) {
    const auto variable = document.header.find("$INSUNITS");
    if (variable == document.header.end() || variable->second.empty()) {
        return {};
    }
    const double code = variable->second.front().number().value_or(0);
    return code == 1    ? std::optional(LengthUnit::Inch)
           : code == 4  ? std::optional(LengthUnit::Millimetre)
           : code == 5  ? std::optional(LengthUnit::Centimetre)
           : code == 6  ? std::optional(LengthUnit::Metre)
           : code == 14 ? std::optional(LengthUnit::Decimetre)
                        : std::nullopt;
}

DxfUnit dxfUnit(const DxfDocument& document, const std::string& units, double extent) {
    std::string word = units;
    std::ranges::transform(word, word.begin(), lowered);
    if (word.starts_with("english") || word.starts_with("imperial") || word.starts_with("inch")) {
        return judged(LengthUnit::Inch, worded("its text says Units: %1", {Wording(units)}),
                      extent);
    }
    if (word.starts_with("metric")) {
        return judged(LengthUnit::Millimetre, worded("its text says Units: %1", {Wording(units)}),
                      extent);
    }
    if (const auto header = headerUnit(document)) {
        return judged(*header,
                      worded("$INSUNITS %1",
                             {Wording(std::string(document.header.at("$INSUNITS").front().value))}),
                      extent);
    }
    const LengthUnit unit = bySize(extent);
    return {unit,
            worded("the file says none; the largest piece is %1 mm then",
                   {figure(extent * millimetresPer(unit))}),
            true};
}

}  // namespace toile
