// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/nest/problem.h"

// For the sources of this folder only: where a copy may lie, other copies and obstacles aside.
namespace toile::nest {

/// Where a copy may lie along one axis: at `offset` and whole multiples of `step` from there; 0:
/// anywhere, infinite: only there.
struct Track {
    double offset = 0, step = 0;
};
struct Tracks {
    Track x, y;
};
Tracks tracksOf(const Item& item, const Pose& pose);

/// The pose at the nearest place that its rules allow in a strip that ends at `length`; false where
/// there is none.
bool moveInside(const Problem& problem, const Item& item, const Shape& shape, double length,
                Pose& pose);

/// The first place along the strip from `x` on; infinite where there is none.
double nextAlong(const Problem& problem, const Track& track, const Shape& shape, double x);

/// A shape from `least` to `most` moved by `at` to the nearest place between two walls on its
/// track, whatever rounding does; false where there is none.
bool moveBetween(const Track& track, double least, double most, double from, double to, double& at);

/// Whether a copy lies in the strip as its rules say.
/// @param grown  its outline as it lies, grown by half the gap
bool keepsRules(const Problem& problem, const Item& item, const Pose& pose,
                const geometry::Polygon& grown, double length);

}  // namespace toile::nest
