// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/geometry/likeness.h"

namespace toile::geometry {

std::complex<double> likeness(const CentredPlaces& ours, const CentredPlaces& theirs,
                              std::size_t start) {
    std::complex<double> sum = 0;
    for (std::size_t k = 0; k < ours.size(); ++k) {
        sum += ours[k] * std::conj(theirs[(k + start) % theirs.size()]);
    }
    return sum;
}

double squaresOf(const CentredPlaces& places) {
    double sum = 0;
    for (const std::complex<double>& place : places) {
        sum += std::norm(place);
    }
    return sum;
}

BestLikeness bestLikeness(const CentredPlaces& ours, const CentredPlaces& theirs) {
    BestLikeness best;
    for (std::size_t start = 0; start < ours.size(); ++start) {
        const std::complex<double> like = likeness(ours, theirs, start);
        if (std::abs(like) > std::abs(best.likeness)) {
            best = {like, start};
        }
    }
    return best;
}

}  // namespace toile::geometry
