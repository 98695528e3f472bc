// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/widgets/stated_edit.h"

#include <QLocale>
#include <QSignalBlocker>
#include <algorithm>
#include <cmath>

namespace toile::app {

namespace {

constexpr int kStatedDecimals = 6, kStatedDigits = 6;
constexpr int kUsualDigits = 4;  // of default values

QString digitsOf(double number, int digits) {
    QLocale locale;
    locale.setNumberOptions(QLocale::OmitGroupSeparator);  // it would be parsed as a decimal mark
    return locale.toString(number, 'g', digits);
}

}  // namespace

StatedEdit::StatedEdit(double least, double most, const QString& unit, const QString& unstated,
                       QWidget* parent)
    : NumberEdit(parent), least_(least), unit_(unit), unstated_(unstated) {
    setDecimals(kStatedDecimals);
    setRange(least - 1, most);  // values below `least` mean not set
    showStated({}, {});
}

std::optional<double> StatedEdit::stated() const {
    return value() > minimum() ? std::optional(std::max(value(), least_)) : std::nullopt;
}

void StatedEdit::showStated(std::optional<double> stated, std::optional<double> usual) {
    const QSignalBlocker quiet(this);
    usual_ = usual;
    setSpecialValueText(
        usual ? tr("%1: %2").arg(unstated_, digitsOf(*usual, kUsualDigits) + ' ' + unit_)
              : unstated_);
    setValue(stated.value_or(minimum()));
    QFont font = parentWidget() ? parentWidget()->font() : this->font();
    font.setBold(stated.has_value());
    setFont(font);
}

QString StatedEdit::textFromValue(double number) const {
    return digitsOf(number, kStatedDigits) + ' ' + unit_;
}

/// Steps by a tenth of the leading digit's unit, starting at the default if no number is set.
void StatedEdit::stepBy(int steps) {
    const double from = stated().value_or(usual_.value_or(least_));
    const double step =
        std::pow(10, std::floor(std::log10(std::max({from, 10 * least_, 1.0}))) - 1);
    setValue(stated() ? std::max(from + steps * step, least_) : from);
    selectAll();
}

std::optional<double> StatedEdit::parsed(const QString& text) const {
    const QString typed = text.trimmed();
    if (typed.isEmpty() || typed == specialValueText()) {
        return minimum();
    }
    QString number = typed.endsWith(unit_) ? typed.chopped(unit_.size()) : typed;
    bool ok = false;
    const double value =
        QLocale::c().toDouble(number.replace(',', '.').simplified().remove(' '), &ok);
    return ok && std::isfinite(value) ? std::optional(value) : std::nullopt;
}

}  // namespace toile::app
