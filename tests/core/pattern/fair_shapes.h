// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/pattern/fair_outline.h"

namespace toile::test {

using Outline = std::vector<Eigen::Vector2d>;

/// The outline of a width and height, a corner in the origin.
Outline rectangle(double width, double height);
/// Every point off by up to so much in x and y.
Outline noisy(const Outline& outline, double noise, unsigned seed);
/// Points at about this distance along the sides; `corners` become their numbers among them.
Outline divided(const Outline& outline, double step, std::vector<int>& corners);

/// The outline as a reference: steps and turns at corners are those it has.
FairProblem fairProblem(const Outline& outline, const std::vector<int>& corners, double tolerance);
/// A polygon with all corners kept, in even steps of at most 2 mm.
FairProblem polygon(const Outline& outline, double tolerance = 1);
/// One with edges of about 10 mm whose ends are noisy, corners kept.
FairProblem noisyPolygon(const Outline& outline, double noise, unsigned seed);
/// A circle in steps of about 2 mm, every fifth point off by up to so much; no corner.
FairProblem noisyCircle(double radius, double noise, unsigned seed);

/// Sum of the changes of curvature from node to node, but for those at corners; 1/mm.
double variation(const Points2& points, const FairProblem& problem);
/// The largest that a step differs from what it should be, mm.
double largestLengthError(const FairLine& line, const FairProblem& problem);
/// And of the turns at corners, radians; whole rounds do not count.
double largestCornerError(const FairLine& line, const FairProblem& problem);

}  // namespace toile::test
