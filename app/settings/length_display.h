// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLocale>
#include <QObject>

#include "core/base/units.h"

namespace toile::app {

/// Format of all lengths in the window. A single instance, like QLocale's default, because every
/// label and cell uses it. Widgets that show lengths update on `changed`. GUI thread only.
class LengthDisplay : public QObject {
    Q_OBJECT

public:
    static LengthDisplay& instance() {
        static LengthDisplay only;
        return only;
    }

    /// Uses the decimal mark of the current default locale.
    LengthFormat format() const {
        return {unit_, inchDenominator_, QLocale().decimalPoint().toStdString()};
    }
    /// @param inchDenominator  denominator of inch fractions; 0: decimals
    void choose(LengthUnit unit, int inchDenominator = 0) {
        if (unit != unit_ || inchDenominator != inchDenominator_) {
            unit_ = unit;
            inchDenominator_ = inchDenominator;
            emit changed();
        }
    }

signals:
    void changed();

private:
    LengthDisplay() = default;

    LengthUnit unit_ = LengthUnit::Millimetre;
    int inchDenominator_ = 0;
};

}  // namespace toile::app
