// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

namespace toile {

/// The span of values a colour bar covers, in the unit shown (percent or degrees).
struct OverlayScale {
    double low = 0, high = 1;
    bool below = false, above = false;  ///< some values lie outside and are clamped

    /// Place of a value on the bar, clamped to [0, 1].
    double position(double value) const;
};

/// Smallest of 1, 2 or 5 times a power of ten that is at least `value`.
double roundedUp(double value);
/// The same among 1, 1.5, 2, 3, 4, 5, 6 and 8 times a power of ten: closer, still easy to read.
double roundedUpClosely(double value);

/// A scale that shows 98 % of the values: symmetric about 0 where `signedValues`, else from 0, its
/// end rounded up, and never finer than `finest`, so that rounding noise of a perfectly flat piece
/// is not blown up into colours.
OverlayScale robustScale(std::vector<float> values, bool signedValues, double finest);

}  // namespace toile
