// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include "core/pipeline/pipeline.h"

namespace toile {

/// Figures of a piece as a person reads them: in the user's locale, with units, short.

/// "412.3 cm²" without the unit: one decimal.
QString squareCentimetres(double squareMillimetres);
QString centimetres(double millimetres);
/// Fraction as percent with a sign: "+1.24", "−0.30", "0".
QString signedPercent(double fraction);
QString percent(double fraction);
/// Largest relative length error of an outline: "exact" where it is below what any tool can cut.
QString boundaryError(double fraction);
/// "−1.2 … +3.4", or a dash where unknown.
QString strainRange(const PieceQuality& quality);
/// How a method is called in the window.
QString methodName(Method method);

}  // namespace toile
