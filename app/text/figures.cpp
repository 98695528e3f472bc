// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/text/figures.h"

#include <QLocale>
#include <cmath>

#include "app/base/translate.h"
#include "app/settings/length_display.h"
#include "app/text/method_text.h"
#include "core/base/angle.h"

namespace toile::app {

namespace {

constexpr QChar kDash(0x2013), kEllipsis(0x2026);

/// A metre of seam is then true to a micrometre.
constexpr double kExact = 1e-6;

/// Enough decimals for two telling digits, at most three.
int decimalsFor(double value) {
    const double size = std::abs(value);
    return size >= 10 ? 1 : size >= 0.1 ? 2 : 3;
}

}  // namespace

QString lengthNumber(double millimetres) {
    // Typed with a hyphen, printed with a minus.
    return QString::fromStdString(lengthNumber(millimetres, LengthDisplay::instance().format()))
        .replace('-', kMinus);
}

QString lengthWithUnit(double millimetres) {
    return QString("%1 %2").arg(lengthNumber(millimetres), lengthUnit());
}

QString lengthUnit() {
    return QString::fromUtf8(symbol(LengthDisplay::instance().format().unit));
}

QString fineLength(double millimetres) {
    return signedFineLength(millimetres).remove('+');
}

QString signedFineLength(double millimetres) {
    const LengthUnit unit = LengthDisplay::instance().format().unit;
    return signedNumber(millimetres / millimetresPer(unit), unit == LengthUnit::Millimetre ? 2 : 3);
}

QString areaNumber(double squareMillimetres) {
    const bool inches = LengthDisplay::instance().format().unit == LengthUnit::Inch;
    const double side = millimetresPer(inches ? LengthUnit::Inch : LengthUnit::Centimetre);
    return QLocale().toString(squareMillimetres / (side * side), 'f', 1);
}

QString areaWithUnit(double squareMillimetres) {
    return QString("%1 %2").arg(areaNumber(squareMillimetres), areaUnit());
}

QString areaUnit() {
    const bool inches = LengthDisplay::instance().format().unit == LengthUnit::Inch;
    return inches ? QStringLiteral("in²") : QStringLiteral("cm²");
}

QString angleWithUnit(double radians) {
    return signedNumber(radians / kDegree, 1).remove('+') + QChar(0x00B0);
}

QString percent(double fraction) {
    const double value = fraction * 100;
    return QLocale().toString(value, 'f', decimalsFor(value));
}

QString signedPercent(double fraction) {
    const double value = fraction * 100;
    if (std::abs(value) < 5e-4) {
        return QLocale().toString(0);
    }
    return (value < 0 ? QString(kMinus) : QString('+')) + percent(std::abs(fraction));
}

QString signedNumber(double value, int decimals) {
    QString size = QLocale().toString(std::abs(value), 'f', decimals);
    if (size == QLocale().toString(0.0, 'f', decimals)) {
        return size;
    }
    return (value < 0 ? QString(kMinus) : QString('+')) + size;
}

std::optional<EnteredPercent> parsePercent(QString text) {
    text.remove('%');
    text.replace(kMinus, '-');
    text = text.trimmed();
    if (text.isEmpty()) {
        return EnteredPercent{};
    }
    // Either mark divides off the decimals, whatever the language: there are no thousands here.
    text.replace(',', '.');
    QLocale plain = QLocale::c();
    plain.setNumberOptions(QLocale::RejectGroupSeparator);
    bool isNumber = false;
    const double value = plain.toDouble(text, &isNumber);
    if (!isNumber || !(value > -100 && value <= 1000)) {  // not a number either
        return std::nullopt;
    }
    return EnteredPercent{value / 100};
}

QString boundaryError(double fraction) {
    return fraction < kExact ? tr("exact") : percent(fraction);
}

QString strainRange(const PieceQuality& quality) {
    if (!quality.strainMin || !quality.strainMax) {
        return kDash;
    }
    return QString("%1 %2 %3")
        .arg(signedPercent(*quality.strainMin), QString(kEllipsis),
             signedPercent(*quality.strainMax));
}

QString methodName(Method method) {
    return tr(methodText(method)).remove('&');
}

}  // namespace toile::app
