// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <optional>

#include "core/pipeline/pipeline.h"

namespace toile {

/// Figures of a piece as a person reads them: in the user's locale, with units, short.

/// "412.3 cm²" without the unit: one decimal.
QString squareCentimetres(double squareMillimetres);
QString centimetres(double millimetres);
/// Fraction as percent with a sign: "+1.24", "−0.30", "0".
QString signedPercent(double fraction);
QString percent(double fraction);
/// "412.3": one decimal, without the unit.
QString millimetres(double value);
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
/// "−1.2 … +3.4", or a dash where unknown.
QString strainRange(const PieceQuality& quality);
/// How a method is called in the window, in the list of pieces as in the menu.
QString methodName(Method method);

}  // namespace toile
