// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/length_unit.h"

namespace toile {

double millimetresPer(LengthUnit unit) {
    switch (unit) {
        case LengthUnit::Millimetre:
            return 1.0;
        case LengthUnit::Centimetre:
            return 10.0;
        case LengthUnit::Metre:
            return 1000.0;
        case LengthUnit::Inch:
            return 25.4;
    }
    return 1.0;
}

std::string_view symbol(LengthUnit unit) {
    switch (unit) {
        case LengthUnit::Millimetre:
            return "mm";
        case LengthUnit::Centimetre:
            return "cm";
        case LengthUnit::Metre:
            return "m";
        case LengthUnit::Inch:
            return "in";
    }
    return "mm";
}

std::optional<LengthUnit> parseLengthUnit(std::string_view text) {
    for (const LengthUnit unit :
         {LengthUnit::Millimetre, LengthUnit::Centimetre, LengthUnit::Metre, LengthUnit::Inch}) {
        if (text == symbol(unit)) {
            return unit;
        }
    }
    return std::nullopt;
}

}  // namespace toile
