// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/text/figures.h"

#include <QCoreApplication>
#include <QLocale>
#include <QStringList>
#include <cmath>

#include "app/base/text.h"
#include "app/settings/length_display.h"
#include "core/base/units.h"

namespace toile::app {
namespace {

constexpr QChar kDash(0x2013), kEllipsis(0x2026);

/// Accurate to a micrometre per metre of seam.
constexpr double kExact = 1e-6;

/// Decimals for two significant digits, at most three.
int decimalsFor(double value) {
    const double size = std::abs(value);
    return size >= 10 ? 1 : size >= 0.1 ? 2 : 3;
}

}  // namespace

QLocale ungrouped() {
    QLocale locale;
    locale.setNumberOptions(QLocale::OmitGroupSeparator);
    return locale;
}

QString lengthNumber(double millimetres) {
    // Input uses a hyphen, display a minus sign.
    return QString::fromStdString(lengthNumber(millimetres, LengthDisplay::instance().format()))
        .replace('-', kMinus);
}

QString lengthWithUnit(double millimetres) {
    return QString("%1 %2").arg(lengthNumber(millimetres), lengthUnit());
}

QString saidLength(double millimetres) {
    constexpr double kYard = 914.4;
    const QLocale locale;
    const LengthFormat format = LengthDisplay::instance().format();
    if (format.unit == LengthUnit::Inch) {
        return millimetres >= 2 * kYard
                   ? tr("%1 yd").arg(locale.toString(millimetres / kYard, 'f', 2))
               : format.denominator > 0
                   ? lengthWithUnit(millimetres)
                   : tr("%1 in").arg(
                         locale.toString(millimetres / millimetresPer(LengthUnit::Inch), 'f', 1));
    }
    return millimetres < 10     ? tr("%1 mm").arg(locale.toString(millimetres, 'f', 1))
           : millimetres < 1000 ? tr("%1 cm").arg(locale.toString(millimetres / 10, 'f', 1))
                                : tr("%1 m").arg(locale.toString(millimetres / 1000, 'f', 2));
}

QString lengthUnit() {
    return QString::fromUtf8(symbol(LengthDisplay::instance().format().unit));
}

double checkerSquare() {
    const bool inches = LengthDisplay::instance().format().unit == LengthUnit::Inch;
    return inches ? millimetresPer(LengthUnit::Inch) / 2 : millimetresPer(LengthUnit::Centimetre);
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
    return ungrouped().toString(squareMillimetres / (side * side), 'f', 1);
}

QString areaWithUnit(double squareMillimetres) {
    constexpr double kSquareMetre = 1e6, kSquareYard = 914.4 * 914.4;
    const bool inches = LengthDisplay::instance().format().unit == LengthUnit::Inch;
    if (const double large = inches ? kSquareYard : kSquareMetre; squareMillimetres >= large) {
        return QString("%1 %2").arg(ungrouped().toString(squareMillimetres / large, 'f', 2),
                                    inches ? QStringLiteral("yd²") : QStringLiteral("m²"));
    }
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
    // Accept either decimal mark in any language; percentages have no thousands separators.
    text.replace(',', '.');
    QLocale plain = QLocale::c();
    plain.setNumberOptions(QLocale::RejectGroupSeparator);
    bool isNumber = false;
    const double value = plain.toDouble(text, &isNumber);
    if (!isNumber || !(value > -100 && value <= 1000)) {  // also rejects NaN
        return std::nullopt;
    }
    return EnteredPercent{value / 100};
}

QString boundaryError(double fraction) {
    return fraction < kExact ? tr("exact") : percent(fraction);
}

QString changeText(const std::vector<LengthChange>& changes) {
    const auto causeText = [](LengthCause cause) {
        return cause == LengthCause::Mirroring   ? tr("mirroring %1")
               : cause == LengthCause::Length    ? tr("set length %1")
               : cause == LengthCause::Improving ? tr("improvement %1")
                                                 : tr("ease %1");
    };
    QStringList words;
    for (const LengthChange& change : changes) {
        words << causeText(change.cause).arg(signedFineLength(change.millimetres));
    }
    return words.join(", ");
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

namespace {

QString unitText(OverlayUnit unit) {
    return unit == OverlayUnit::Percent   ? QStringLiteral("%")
           : unit == OverlayUnit::Degrees ? QStringLiteral("°")
           : unit == OverlayUnit::Length  ? lengthUnit()
                                          : QString();
}

QString withSign(Overlay overlay, double value, const QString& digits) {
    // No sign if the value rounds to zero.
    const bool isZero = QLocale().toDouble(digits) == 0;
    if (isZero || (value > 0 && !traits(overlay).hasSign)) {
        return digits;
    }
    return (value < 0 ? QString(kMinus) : QString('+')) + digits;
}

}  // namespace

OverlayWords overlayWords(Overlay overlay) {
    const OverlayTraits& known = traits(overlay);
    const bool inInches = LengthDisplay::instance().format().unit == LengthUnit::Inch;
    const char* meaning = overlay == Overlay::Checker && inInches
                              ? TR("squares of 1/2 in on the flat cloth")
                              : known.meaning;
    // In menus, overlays of a proof also name the sewn cloth.
    const char* title = isOfProof(overlay) ? known.action.shortText : known.action.text;
    return {tr(title).remove('&'), unitText(known.unit), tr(meaning)};
}

double overlayUnit(Overlay overlay) {
    return traits(overlay).unit == OverlayUnit::Length
               ? millimetresPer(LengthDisplay::instance().format().unit)
               : 1;
}

QString overlayNumber(Overlay overlay, double value) {
    // More digits of a limit in inches are not useful.
    const int digits = traits(overlay).unit == OverlayUnit::Length ? 3 : 4;
    return withSign(overlay, value,
                    QLocale().toString(std::abs(value) / overlayUnit(overlay), 'g', digits));
}

QString overlayValueText(Overlay overlay, double value) {
    const OverlayTraits& known = traits(overlay);
    if (known.unit == OverlayUnit::Length) {
        return signedFineLength(value) + QChar(0x202F) + lengthUnit();
    }
    const double size = std::abs(value);
    // Decimals are meaningless for such large values, as at a torn triangle.
    const QString digits = QLocale().toString(size, 'f', size >= 1000 ? 0 : known.decimals);
    const QString number = withSign(overlay, value, digits);
    const QString unit = unitText(known.unit);
    // A narrow no-break space precedes the percent sign, but not the degree sign.
    return known.unit == OverlayUnit::Degrees ? number + unit : number + QChar(0x202F) + unit;
}

}  // namespace toile::app
