// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>

#include "core/garment/fabric.h"

namespace toile {

/// The limits of a fabric along one direction, as cloth is held against them: a limit of 0 would
/// make rounding a strain beyond it.
class StrainBounds {
public:
    /// Nor does rounding put cloth that is just at its limit beyond it: so many times the limit; as
    /// in surface.glsl.
    static constexpr double kSlack = 1.0005;

    explicit StrainBounds(const StrainLimits& stated)
        : least_(std::min(stated.least, -kLeastLimit)), most_(std::max(stated.most, kLeastLimit)) {}

    /// Of cloth that is strained like this.
    double limitFor(double strain) const { return strain < 0 ? least_ : most_; }
    /// As a part of its limit.
    double severity(double strain) const { return strain / limitFor(strain); }
    bool isBeyond(double strain) const { return severity(strain) > kSlack; }

private:
    static constexpr double kLeastLimit = 1e-4;

    double least_, most_;
};

}  // namespace toile
