// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <optional>
#include <vector>

#include "app/document/view_state.h"
#include "core/base/setting.h"
#include "core/flatten/base/flat_piece.h"
#include "core/seam/seam_measure.h"
#include "core/toile/pipeline.h"

class QLocale;

namespace toile::app {

/// Figures of a piece as a person reads them: in the user's locale, with units, short.

/// What numbers below zero begin with; a hyphen is what is typed.
inline constexpr QChar kMinus(0x2212);

/// The person's locale without marks between thousands, as measures are written.
QLocale ungrouped();

/// Lengths and areas are in the person's unit (`LengthDisplay`), given in mm and mm².

/// "412.3", "41.23", "16 1/4": without the unit.
QString lengthNumber(double millimetres);
/// "412.3 mm", "16 1/4 in".
QString lengthWithUnit(double millimetres);
/// As a person says it: "5.0 mm", "14.8 cm", "1.48 m"; where inches are shown "48.3 in", "2.25 yd".
QString saidLength(double millimetres);
/// "mm", "cm", "in".
QString lengthUnit();
/// Side of the checkerboard's squares: 1 cm, or half an inch where inches are shown; mm.
double checkerSquare();
/// Differences too small for fractions of an inch, in decimals: "0.24" mm, "0.024" cm, "0.009" in.
QString fineLength(double millimetres);
/// With a sign, and none for what rounds to nothing: "+0.24", "−1.20", "0.00".
QString signedFineLength(double millimetres);
/// "412.3": one decimal, without the unit.
QString areaNumber(double squareMillimetres);
/// "412.3 cm²".
QString areaWithUnit(double squareMillimetres);
/// "cm²", "in²".
QString areaUnit();

/// "12.5°", "−3.0°".
QString angleWithUnit(double radians);

/// Fraction as percent with a sign: "+1.24", "−0.30", "0".
QString signedPercent(double fraction);
QString percent(double fraction);
/// "+1.24", "−0.30", and "0.00" for what rounds to nothing.
QString signedNumber(double value, int decimals);
/// What a person typed for a percentage; no fraction where the field was left empty.
struct EnteredPercent {
    std::optional<double> fraction;
};
/// "2", "+2,5 %", "-3" in the user's locale or with a point; nothing where it is no percentage
/// above -100 and up to 1000.
std::optional<EnteredPercent> parsePercent(QString text);
/// Largest relative length error of an outline: "exact" where it is below what any tool can cut.
QString boundaryError(double fraction);
/// Why lengths differ from 3D on purpose, and by how much: "mirroring +4.50", the length unit left
/// out; empty for no change.
QString changeText(const std::vector<LengthChange>& changes);
/// "−1.2 … +3.4", or a dash where unknown.
QString strainRange(const PieceQuality& quality);
/// How a method is called in the window, in the list of pieces as in the menu.
QString methodName(Method method);

/// How a method is called in the window, untranslated, with a mark before the letter that chooses
/// it in the menu; `methodName` (figures.h) is what a person reads elsewhere.
constexpr const char* methodText(Method method) {
    switch (method) {
        case Method::Isometric:
            return TR("Least &distortion");
        case Method::Curvature:
            return TR("Angles follow the c&urvature");
        case Method::Wang2005:
            return TR("Angles spread &evenly");
        case Method::Stretch:
            return TR("Least &stretch on a circle");
        case Method::Natural:
            return TR("&Free outline");
        case Method::Lscm:
            return TR("Free outline, leas&t squares");
        case Method::Abf:
            return TR("Free outline, by an&gles");
        case Method::Convex:
            return TR("On a ci&rcle");
    }
    return "";
}

/// What an overlay is called and how its numbers are read.
struct OverlayWords {
    QString title;
    QString unit;  ///< "%", "°"; empty where there are no numbers
    QString meaning;
};

OverlayWords overlayWords(Overlay overlay);
/// What one of an overlay's units is of what its numbers are in: mm where these are lengths,
/// else 1.
double overlayUnit(Overlay overlay);

/// Digits as they come, at most four: "+12.5", "−3"; without the unit.
QString overlayNumber(Overlay overlay, double value);
/// A measured value, always with the same decimals, and its unit: "+2.4 %", "3.1°".
QString overlayValueText(Overlay overlay, double value);

}  // namespace toile::app
