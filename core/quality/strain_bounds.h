// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>

#include "core/garment/fabric.h"

namespace toile {

/// Limits of a fabric along one direction, for comparison with cloth. Limits are kept above 0,
/// because rounding would exceed a limit of 0.
class StrainBounds {
public:
    /// Factor on the limit that keeps cloth exactly at its limit from exceeding it by rounding; the
    /// same as in surface.glsl.
    static constexpr double kSlack = 1.0005;

    explicit StrainBounds(const StrainLimits& stated)
        : least_(std::min(stated.least, -kMinStrainLimit)),
          most_(std::max(stated.most, kMinStrainLimit)) {}

    /// The limit on the side of this strain's sign.
    double limitFor(double strain) const { return strain < 0 ? least_ : most_; }
    /// Strain as a fraction of its limit.
    double severity(double strain) const { return strain / limitFor(strain); }
    bool isBeyond(double strain) const { return severity(strain) > kSlack; }

private:
    static constexpr double kMinStrainLimit = 1e-4;

    double least_, most_;
};

}  // namespace toile
