// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/settings/length_display.h"

#include <QLocale>

namespace toile {

LengthDisplay& LengthDisplay::instance() {
    static LengthDisplay only;
    return only;
}

LengthFormat LengthDisplay::format() const {
    return {unit_, inchDenominator_, QLocale().decimalPoint().toStdString()};
}

void LengthDisplay::choose(LengthUnit unit, int inchDenominator) {
    if (unit == unit_ && inchDenominator == inchDenominator_) {
        return;
    }
    unit_ = unit;
    inchDenominator_ = inchDenominator;
    emit changed();
}

}  // namespace toile
