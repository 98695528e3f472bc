// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLocale>
#include <QObject>

#include "core/base/units.h"

namespace toile::app {

/// How lengths are written everywhere in the window. One for the whole program, as QLocale's
/// default is, since every label and cell writes lengths; those who show one write it again on
/// `changed`. GUI thread only.
class LengthDisplay : public QObject {
    Q_OBJECT

public:
    static LengthDisplay& instance() {
        static LengthDisplay only;
        return only;
    }

    /// With the decimal mark of the default locale at this time.
    LengthFormat format() const {
        return {unit_, inchDenominator_, QLocale().decimalPoint().toStdString()};
    }
    /// @param inchDenominator  inches in fractions of this; 0: in decimals
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
