// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/figures.h"

#include <QCoreApplication>
#include <QLocale>
#include <cmath>

namespace toile {

namespace {

constexpr QChar kMinus(0x2212), kDash(0x2013), kEllipsis(0x2026);

/// A metre of seam is then true to a micrometre.
constexpr double kExact = 1e-6;

QString tr(const char* text) {
    return QCoreApplication::translate("Figures", text);
}

/// Enough decimals for two telling digits, at most three.
int decimalsFor(double value) {
    const double size = std::abs(value);
    return size >= 10 ? 1 : size >= 0.1 ? 2 : 3;
}

}  // namespace

QString squareCentimetres(double squareMillimetres) {
    return QLocale().toString(squareMillimetres / 100, 'f', 1);
}

QString centimetres(double millimetres) {
    return QLocale().toString(millimetres / 10, 'f', 1);
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

QString millimetres(double value) {
    return QLocale().toString(value, 'f', 1);
}

QString signedNumber(double value, int decimals) {
    const QString size = QLocale().toString(std::abs(value), 'f', decimals);
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
    bool isNumber = false;
    double value = QLocale().toDouble(text, &isNumber);
    if (!isNumber) {
        value = QLocale::c().toDouble(text, &isNumber);
    }
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
    switch (method) {
        case Method::Isometric:
            return tr("Least distortion");
        case Method::Curvature:
            return tr("Angles follow the curvature");
        case Method::Wang2005:
            return tr("Angles spread evenly (Wang 2005)");
        case Method::Stretch:
            return tr("Least stretch on a circle (Yoshizawa 2004)");
        case Method::Natural:
            return tr("Free outline (Desbrun 2002)");
        case Method::Lscm:
            return tr("Free outline, least squares (Lévy 2002)");
        case Method::Abf:
            return tr("Free outline, by angles (Sheffer 2005)");
        case Method::Convex:
            return tr("On a circle (Floater 2003)");
    }
    return {};
}

}  // namespace toile
