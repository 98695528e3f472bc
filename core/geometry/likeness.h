// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <complex>
#include <vector>

namespace toile::geometry {

/// Points in the plane relative to their centroid, evenly spaced along a closed line.
using CentredPlaces = std::vector<std::complex<double>>;

/// Correlation of two lists, the second starting at index `start` and wrapping around. Its angle is
/// the anti-clockwise turn that best aligns the second with the first; its size measures likeness.
/// The remaining squared distance is the sum of both `squaresOf` less twice this size.
/// Precondition: both have the same size.  Cost: linear. Pure.
std::complex<double> likeness(const CentredPlaces& ours, const CentredPlaces& theirs,
                              std::size_t start = 0);

/// Sum of the squared distances from the centroid.
double squaresOf(const CentredPlaces& places);

struct BestLikeness {
    std::complex<double> likeness = 0;
    std::size_t start = 0;
};
/// The start with the greatest likeness, the first of equals.  Cost: quadratic. Pure.
BestLikeness bestLikeness(const CentredPlaces& ours, const CentredPlaces& theirs);

}  // namespace toile::geometry
