// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/widgets/number_edits.h"

#include <QKeyEvent>
#include <QLocale>
#include <QSignalBlocker>
#include <cmath>

#include "app/settings/length_display.h"
#include "core/base/units.h"

namespace toile::app {

namespace {

/// A nanometre, so that values typed in inches are exact enough.
constexpr int kDecimals = 6;
constexpr int kDecimalsShown = 2;  ///< for angles and percentages
constexpr double kLongest = 10'000;
/// Tolerance for rounding when an angle is converted to radians and back.
constexpr double kSlack = 1e-9;

double stepOf(const LengthFormat& format) {
    const double unit = millimetresPer(format.unit);
    if (format.unit == LengthUnit::Inch) {
        return unit / (format.denominator > 0 ? format.denominator : 10);
    }
    return 1;  // 1 mm, for centimetres too
}

/// True if no typed text is waiting to be committed.
bool isSettled(const QDoubleSpinBox& field) {
    const bool isSpecial =
        field.value() == field.minimum() && field.text() == field.specialValueText();
    return isSpecial ||
           field.text() == field.prefix() + field.textFromValue(field.value()) + field.suffix();
}

}  // namespace

NumberEdit::NumberEdit(QWidget* parent) : QDoubleSpinBox(parent) {
    setKeyboardTracking(false);
    setAlignment(Qt::AlignRight);
}

double NumberEdit::valueFromText(const QString& text) const {
    return text == textFromValue(value()) ? value() : parsed(text).value_or(value());
}

QValidator::State NumberEdit::validate(QString& text, int&) const {
    const auto number = parsed(text);
    return number && *number >= minimum() - kSlack && *number <= maximum() + kSlack
               ? QValidator::Acceptable
               : QValidator::Intermediate;
}

AngleEdit::AngleEdit(QWidget* parent) : NumberEdit(parent) {
    setDecimals(kDecimals);
    setRange(-180, 180);
    setWrapping(true);
}

QString AngleEdit::textFromValue(double degrees) const {
    return QString::fromStdString(
        angleText(degrees * kDegree, kDecimalsShown, QLocale().decimalPoint().toStdString()));
}

std::optional<double> AngleEdit::parsed(const QString& text) const {
    const auto angle = parseAngle(text.toStdString());
    return angle ? std::optional(*angle / kDegree) : std::nullopt;
}

LengthEdit::LengthEdit(QWidget* parent) : NumberEdit(parent) {
    setDecimals(kDecimals);
    setRange(0, kLongest);
    updateUnit();
    connect(&LengthDisplay::instance(), &LengthDisplay::changed, this, &LengthEdit::updateUnit);
}

void LengthEdit::updateUnit() {
    setSingleStep(stepOf(LengthDisplay::instance().format()));
    setDecimals(kDecimals);  // also updates the text
}

QString LengthEdit::textFromValue(double millimetres) const {
    return QString::fromStdString(lengthText(millimetres, LengthDisplay::instance().format()));
}

std::optional<double> LengthEdit::parsed(const QString& text) const {
    return parseLength(text.toStdString(), LengthDisplay::instance().format());
}

void showLength(LengthEdit& field, double millimetres, bool isStated) {
    const QSignalBlocker quiet(field);
    field.setValue(millimetres);
    QFont font = field.parentWidget()->font();
    font.setBold(isStated);
    field.setFont(font);
}

PercentEdit::PercentEdit(QWidget* parent) : NumberEdit(parent) {
    setDecimals(kDecimals);
    setRange(-100, 100);
    setSingleStep(0.5);
}

QString PercentEdit::textFromValue(double percent) const {
    const double places = std::pow(10.0, kDecimalsShown);
    const double rounded = std::round(percent * places) / places;
    const QString digits = QLocale().toString(std::abs(rounded), 'g', 6);
    const QString sign = rounded > 0 ? "+" : rounded < 0 ? QString(QChar(0x2212)) : QString();
    return tr("%1 %").arg(sign + digits);
}

std::optional<double> PercentEdit::parsed(const QString& text) const {
    QString number = text;
    number.remove('%').replace(QChar(0x2212), '-').replace(',', '.');
    bool ok = false;
    const double value = QLocale::c().toDouble(number.simplified().remove(' '), &ok);
    return ok && std::isfinite(value) ? std::optional(value) : std::nullopt;
}

void FieldGuard::install(QWidget& field) {
    field.installEventFilter(this);
}

bool FieldGuard::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::Wheel && !static_cast<QWidget*>(watched)->hasFocus()) {
        event->ignore();
        return true;
    }
    if (event->type() == QEvent::ShortcutOverride) {
        const auto* key = static_cast<QKeyEvent*>(event);
        const auto* field = qobject_cast<QDoubleSpinBox*>(watched);
        if (field && isSettled(*field) &&
            (key->matches(QKeySequence::Undo) || key->matches(QKeySequence::Redo))) {
            event->ignore();
            return true;
        }
    }
    return QObject::eventFilter(watched, event);
}

}  // namespace toile::app
