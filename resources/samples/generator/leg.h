// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "torso.h"

namespace toile::samples {

/// The left half of the trousers. Every level is an ellipse around the leg, cut off by the plane
/// x = 0 where left and right half overlap: that cut is the crotch seam. `turn` runs from the
/// side seam (0) to the crotch seam or the inseam (up to 180 degrees).
/// Layout: y is the height, x the way around from the side seam.
class Leg {
public:
    static constexpr double kCrotchHeight = 782.0;

    /// Point at `turn` radians from the side seam, `height` mm above the floor.
    Vec3 at(Half half, double turn, double height) const;

    /// Where the level ends: at the crotch seam, or at the inseam (180 degrees).
    double innerTurn(double height) const;

    /// Point of the layout.
    Vec3 fromFlat(Half half, Vec2 p) const;

    /// Layout point of a place on the leg.
    Vec2 toFlat(Half half, double turn, double height) const;

private:
    double overlapAt(double height) const;
    double radiusAt(Half half, double height) const;

    Profile outerX_{{{85, 172},
                     {300, 166},
                     {480, 168},
                     {700, 186},
                     {800, 189},
                     {880, 184},
                     {960, 166},
                     {1040, 142},
                     {1080, 138}}};
    Profile innerX_{{{85, 36}, {300, 32}, {480, 29}, {660, 23}, {745, 16}, {kCrotchHeight, 0}}};
    Profile frontDepth_{{{85, 76},
                         {300, 80},
                         {480, 88},
                         {700, 106},
                         {800, 114},
                         {900, 117},
                         {1040, 108},
                         {1080, 106}}};
    Profile backDepth_{{{85, 80},
                        {300, 84},
                        {480, 90},
                        {700, 112},
                        {800, 124},
                        {890, 128},
                        {1040, 104},
                        {1080, 102}}};
    std::vector<Mound> belly_{{40, 955, 60, 60, 60, 5}};
    std::vector<Mound> seat_{{78, 885, 50, 60, 55, 16}};
};

}  // namespace toile::samples
