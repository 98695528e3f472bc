// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "seam_line.h"

namespace toile::samples {

/// The left sleeve of the T-shirt: a tube from the armhole to the cuff, cut open along the
/// underarm. Layout: y upwards from the cuff, x around the arm from the top line, front to the
/// left.
class Sleeve {
public:
    /// Both armhole seams run from the underarm to the shoulder.
    Sleeve(const SeamLine& frontArmhole, const SeamLine& backArmhole);

    /// `around` runs over [0, 1] from the underarm over front, shoulder and back; `down` over
    /// [0, 1] from the armhole to the cuff.
    Vec3 at(double around, double down) const;

    /// Point of the layout.
    Vec3 fromFlat(Vec2 p) const;

    /// Layout point of a place on the tube.
    Vec2 toFlat(double around, double down) const;

    /// Part of the way around that the front armhole takes.
    double frontPart() const { return frontPart_; }

private:
    PointCurve armhole_;
    double frontPart_;
};

}  // namespace toile::samples
