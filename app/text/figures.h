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

/// Short figures of a piece in the user's locale, with units.

/// Minus sign of displayed numbers; users type a hyphen.
inline constexpr QChar kMinus(0x2212);

/// The user's locale without thousands separators, as usual for measures.
QLocale ungrouped();

/// Lengths and areas are given in mm and mm² and shown in the user's unit (`LengthDisplay`).

/// "412.3", "41.23", "16 1/4": without the unit.
QString lengthNumber(double millimetres);
/// "412.3 mm", "16 1/4 in".
QString lengthWithUnit(double millimetres);
/// In the most readable unit: "5.0 mm", "14.8 cm", "1.48 m"; for inches "48.3 in", "2.25 yd".
QString saidLength(double millimetres);
/// "mm", "cm", "in".
QString lengthUnit();
/// Side of the checkerboard's squares in mm: 1 cm, or half an inch if the unit is inches.
double checkerSquare();
/// Decimals for differences too small for fractions of an inch: "0.24" mm, "0.024" cm, "0.009" in.
QString fineLength(double millimetres);
/// With a sign unless it rounds to zero: "+0.24", "−1.20", "0.00".
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
/// "+1.24", "−0.30", or "0.00" if it rounds to zero.
QString signedNumber(double value, int decimals);
/// A typed percentage; `fraction` is nullopt if the field was empty.
struct EnteredPercent {
    std::optional<double> fraction;
};
/// "2", "+2,5 %", "-3" in the user's locale or with a decimal point; nullopt unless it is a
/// percentage above -100 and at most 1000.
std::optional<EnteredPercent> parsePercent(QString text);
/// Largest relative length error of an outline: "exact" if it is smaller than any tool can cut.
QString boundaryError(double fraction);
/// Intended length changes from 3D and their reasons: "mirroring +4.50", without the unit; empty
/// for no change.
QString changeText(const std::vector<LengthChange>& changes);
/// "−1.2 … +3.4", or a dash if unknown.
QString strainRange(const PieceQuality& quality);
/// Name of a method in the window.
QString methodName(Method method);

/// Untranslated name of a method, with a mark before its menu mnemonic. For other texts use
/// `methodName`.
constexpr const char* methodText(Method method) {
    switch (method) {
        case Method::Isometric:
            return TR("Least &distortion");
        case Method::Curvature:
            return TR("Angles from c&urvature");
        case Method::Wang2005:
            return TR("&Even angles (Wang 2005)");
        case Method::Stretch:
            return TR("Least &stretch on a circle");
        case Method::Natural:
            return TR("&Free outline");
        case Method::Lscm:
            return TR("LSCM (&texture style)");
        case Method::Abf:
            return TR("A&BF (texture style)");
        case Method::Convex:
            return TR("On a ci&rcle");
    }
    return "";
}

/// Texts of an overlay and its unit.
struct OverlayWords {
    QString title;
    QString unit;  ///< "%", "°"; empty for overlays without numbers
    QString meaning;
};

OverlayWords overlayWords(Overlay overlay);
/// Size of the display unit in the overlay's stored unit: mm for lengths, else 1.
double overlayUnit(Overlay overlay);

/// At most four digits without padding: "+12.5", "−3"; without the unit.
QString overlayNumber(Overlay overlay, double value);
/// A measured value with fixed decimals and its unit: "+2.4 %", "3.1°".
QString overlayValueText(Overlay overlay, double value);

}  // namespace toile::app
