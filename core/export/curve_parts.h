// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "core/pattern/cubic_curve.h"

namespace toile {

/// The two parts of a curve, before and after a parameter.
/// @param t  in (0, 1)
std::array<CubicCurve, 2> dividedAt(const CubicCurve& curve, double t);

/// Divides a chain of curves at these arc lengths; every part is a curve of its own.
/// @param places  mm, ascending; those within `near` of a joint divide nothing
/// Cost: about twenty length computations per place. Pure.
std::vector<CubicCurve> dividedChain(const std::vector<CubicCurve>& chain,
                                     const std::vector<double>& places, double near);

/// Arc lengths of the inner joints of a chain, mm, ascending: one fewer than curves.
std::vector<double> jointsOf(const std::vector<CubicCurve>& chain);

}  // namespace toile
