// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/widgets/percent_edit.h"

#include <QLocale>
#include <cmath>
#include <optional>

namespace toile {

namespace {

constexpr int kDecimals = 6, kDecimalsShown = 2;
constexpr double kStep = 0.5;

std::optional<double> parsed(QString text) {
    text.remove('%').replace(QChar(0x2212), '-').replace(',', '.');
    bool ok = false;
    const double value = QLocale::c().toDouble(text.simplified().remove(' '), &ok);
    return ok && std::isfinite(value) ? std::optional(value) : std::nullopt;
}

}  // namespace

PercentEdit::PercentEdit(QWidget* parent) : QDoubleSpinBox(parent) {
    setDecimals(kDecimals);
    setRange(-100, 100);
    setSingleStep(kStep);
    setKeyboardTracking(false);
    setAlignment(Qt::AlignRight);
}

QString PercentEdit::textFromValue(double percent) const {
    const double places = std::pow(10.0, kDecimalsShown);
    const double rounded = std::round(percent * places) / places;
    const QString digits = QLocale().toString(std::abs(rounded), 'g', 6);
    const QString sign = rounded > 0 ? "+" : rounded < 0 ? QString(QChar(0x2212)) : QString();
    return tr("%1 %").arg(sign + digits);
}

double PercentEdit::valueFromText(const QString& text) const {
    if (text == textFromValue(value())) {
        return value();  // the text is rounded; what was not typed is not changed by it
    }
    return parsed(text).value_or(value());
}

QValidator::State PercentEdit::validate(QString& text, int&) const {
    const auto percent = parsed(text);
    return percent && *percent >= minimum() && *percent <= maximum() ? QValidator::Acceptable
                                                                     : QValidator::Intermediate;
}

}  // namespace toile
