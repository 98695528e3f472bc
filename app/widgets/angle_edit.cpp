// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/widgets/angle_edit.h"

#include <QLocale>
#include <numbers>

#include "core/base/angle.h"
#include "core/base/length_text.h"

namespace toile {

namespace {

constexpr int kAngleDecimals = 6, kAngleDecimalsShown = 2;

}  // namespace

AngleEdit::AngleEdit(QWidget* parent) : QDoubleSpinBox(parent) {
    setDecimals(kAngleDecimals);
    setRange(-180, 180);
    setSingleStep(1);
    setWrapping(true);
    setKeyboardTracking(false);
    setAlignment(Qt::AlignRight);
}

double AngleEdit::radians() const {
    return value() * kDegree;
}

void AngleEdit::setRadians(double angle) {
    setValue(angle / kDegree);
}

QString AngleEdit::textFromValue(double degrees) const {
    return QString::fromStdString(
        angleText(degrees * kDegree, kAngleDecimalsShown, QLocale().decimalPoint().toStdString()));
}

double AngleEdit::valueFromText(const QString& text) const {
    if (text == textFromValue(value())) {
        return value();  // the text is rounded; what was not typed is not changed by it
    }
    const auto angle = parseAngle(text.toStdString());
    return angle ? *angle / kDegree : value();
}

QValidator::State AngleEdit::validate(QString& text, int&) const {
    const auto angle = parseAngle(text.toStdString());
    // Room for the rounding of the way through radians.
    constexpr double kSlack = 1e-9;
    return angle && *angle / kDegree >= minimum() - kSlack && *angle / kDegree <= maximum() + kSlack
               ? QValidator::Acceptable
               : QValidator::Intermediate;
}

}  // namespace toile
