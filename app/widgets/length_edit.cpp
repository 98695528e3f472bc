// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/widgets/length_edit.h"

#include <cmath>

#include "app/settings/length_display.h"

namespace toile {

namespace {

/// A thousandth of a micrometre: what is typed in inches keeps its value.
constexpr int kLengthDecimals = 6;
constexpr double kLongest = 10'000;

double stepOf(const LengthFormat& format) {
    const double unit = millimetresPer(format.unit);
    if (format.unit == LengthUnit::Inch) {
        return unit / (format.denominator > 0 ? format.denominator : 10);
    }
    return 1;  // a millimetre, in centimetres too
}

}  // namespace

LengthEdit::LengthEdit(QWidget* parent) : QDoubleSpinBox(parent) {
    setDecimals(kLengthDecimals);
    setRange(0, kLongest);
    setKeyboardTracking(false);
    setAlignment(Qt::AlignRight);
    updateUnit();
    connect(&LengthDisplay::instance(), &LengthDisplay::changed, this, &LengthEdit::updateUnit);
}

void LengthEdit::updateUnit() {
    setSingleStep(stepOf(LengthDisplay::instance().format()));
    setDecimals(kLengthDecimals);  // writes the text anew
}

QString LengthEdit::textFromValue(double value) const {
    return QString::fromStdString(lengthText(value, LengthDisplay::instance().format()));
}

double LengthEdit::valueFromText(const QString& text) const {
    if (text == textFromValue(value())) {
        return value();  // the text is rounded; what was not typed is not changed by it
    }
    return parseLength(text.toStdString(), LengthDisplay::instance().format()).value_or(value());
}

QValidator::State LengthEdit::validate(QString& text, int&) const {
    const auto length = parseLength(text.toStdString(), LengthDisplay::instance().format());
    return length && *length >= minimum() && *length <= maximum() ? QValidator::Acceptable
                                                                  : QValidator::Intermediate;
}

}  // namespace toile
