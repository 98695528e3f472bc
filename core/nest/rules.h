// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/nest/problem.h"

// For the sources of this folder only: where a copy may lie, ignoring other copies and obstacles.
namespace toile::nest {

/// Allowed positions of a copy along one axis: at `offset` and whole multiples of `step` from
/// there; 0: anywhere, infinite: only at `offset`.
struct Track {
    double offset = 0, step = 0;
};
struct Tracks {
    Track x, y;
};
Tracks tracksOf(const Item& item, const Pose& pose);

/// Moves the pose to the closest place that its rules allow in a strip that ends at `length`; false
/// if there is none.
bool moveInside(const Problem& problem, const Item& item, const Shape& shape, double length,
                Pose& pose);

/// The first place along the strip from `x` on; infinite if there is none.
double nextAlong(const Problem& problem, const Track& track, const Shape& shape, double x);

/// Moves a shape from `least` to `most` by `at` to the closest place between two walls on its
/// track, robust to rounding; false if there is none.
bool moveBetween(const Track& track, double least, double most, double from, double to, double& at);

/// Whether a copy in the strip satisfies its rules.
/// @param grown  its outline as placed, offset by half the gap
bool keepsRules(const Problem& problem, const Item& item, const Pose& pose,
                const geometry::Polygon& grown, double length);

}  // namespace toile::nest
