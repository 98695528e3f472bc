// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <complex>
#include <vector>

namespace toile::geometry {

/// Places of the plane around their middle, at even shares of a closed line.
using CentredPlaces = std::vector<std::complex<double>>;

/// How like each other two lists are, the second begun at number `start` and going round: the angle
/// is that which turns the second nearest to the first, anti-clockwise; the more like, the larger.
/// What remains between them are then the squares of both less twice the size of this.
/// @param theirs  as many  Cost: linear. Pure.
std::complex<double> likeness(const CentredPlaces& ours, const CentredPlaces& theirs,
                              std::size_t start = 0);

/// Sum of the squared distances from the middle.
double squaresOf(const CentredPlaces& places);

struct BestLikeness {
    std::complex<double> likeness = 0;
    std::size_t start = 0;
};
/// Begun where they are most alike, the first of equals.  Cost: quadratic. Pure.
BestLikeness bestLikeness(const CentredPlaces& ours, const CentredPlaces& theirs);

}  // namespace toile::geometry
