// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "core/pattern/cubic_curve.h"

namespace toile {

/// The two parts of a curve, before and after a parameter.
/// @param t  in (0, 1)
std::array<CubicCurve, 2> dividedAt(const CubicCurve& curve, double t);

/// A chain of curves divided at these arc lengths along it, each curve its own again.
/// @param places  mm, ascending; those within `near` of a joint divide nothing
/// Cost: some twenty lengths for each place. Pure.
std::vector<CubicCurve> dividedChain(const std::vector<CubicCurve>& chain,
                                     const std::vector<double>& places, double near);

/// Arc lengths of the joints inside of a chain, mm, ascending: one less than curves.
std::vector<double> jointsOf(const std::vector<CubicCurve>& chain);

}  // namespace toile
