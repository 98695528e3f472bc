// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/symmetry/common_lengths.h"

#include <algorithm>
#include <cmath>

namespace toile {
namespace {

constexpr int kNoSeam = -1, kSeveralSeams = -2;

/// Per seam: the seam that its sides are paired with, kNoSeam, or kSeveralSeams.
std::vector<int> pairedSeams(std::size_t seamCount, const MirrorSegments& segments,
                             const std::vector<int>& counterpart, const SegmentPairs& pairs) {
    std::vector<int> paired(seamCount, kNoSeam);
    for (std::size_t p = 0; p < segments.size(); ++p) {
        for (std::size_t i = 0; i < segments[p].size(); ++i) {
            if (pairs[p][i] >= 0) {
                const int there = segments[counterpart[p]][pairs[p][i]].seam;
                int& known = paired[segments[p][i].seam];
                known = known == kNoSeam || known == there ? there : kSeveralSeams;
            }
        }
    }
    return paired;
}

double lengthOf(const Seam& seam) {
    return seam.right.piece < 0 ? seam.length3d[0] : 0.5 * (seam.length3d[0] + seam.length3d[1]);
}

}  // namespace

std::vector<int> CommonLengths::withoutCounterpart() const {
    std::vector<int> without;
    for (int s = 0; s < static_cast<int>(mirrored.size()); ++s) {
        if (mirrored[s] < 0) {
            without.push_back(s);
        }
    }
    return without;
}

CommonLengths commonLengths(const Garment& garment, const MirrorSegments& segments,
                            const std::vector<int>& counterpart, const SegmentPairs& pairs) {
    const std::vector<Seam>& seams = garment.seams.seams;
    const std::vector<int> paired = pairedSeams(seams.size(), segments, counterpart, pairs);
    CommonLengths common{std::vector<double>(seams.size(), 1),
                         std::vector<int>(seams.size(), kNoSeam)};
    for (int s = 0; s < static_cast<int>(seams.size()); ++s) {
        const int other = paired[s];
        if (other < 0 || paired[other] != s) {
            continue;
        }
        common.mirrored[s] = other;
        const double own = lengthOf(seams[s]);
        if (other != s && own > 0) {
            common.factor[s] = 0.5 * (own + lengthOf(seams[other])) / own;
        }
    }
    return common;
}

double mirrorTolerance(double length, double mirroredLength) {
    constexpr double kLength = 2, kShare = 0.01;  // mm, and of the longer seam
    return std::max(kLength, kShare * std::max(length, mirroredLength));
}

std::vector<UnequalPieces> unequalPieces(const Garment& garment, const MirrorSegments& segments,
                                         const std::vector<int>& counterpart,
                                         const CommonLengths& lengths) {
    const std::vector<Seam>& seams = garment.seams.seams;
    std::vector<UnequalPieces> found;
    for (int p = 0; p < static_cast<int>(segments.size()); ++p) {
        const int other = counterpart[p];
        if (other < p) {
            continue;
        }
        UnequalPieces worst;
        for (const MirrorSegment& segment : segments[p]) {
            const int image = lengths.mirrored[segment.seam];
            if (image < 0) {
                continue;
            }
            const double here = lengthOf(seams[segment.seam]), there = lengthOf(seams[image]);
            const double difference = std::abs(here - there);
            const double tolerance = mirrorTolerance(here, there);
            if (difference > tolerance &&
                (worst.piece < 0 || difference * worst.tolerance > worst.difference * tolerance)) {
                const bool isLonger = here > there;
                worst = {isLonger ? p : other,
                         isLonger ? other : p,
                         isLonger ? segment.seam : image,
                         isLonger ? image : segment.seam,
                         difference,
                         tolerance};
            }
        }
        if (worst.piece >= 0) {
            found.push_back(worst);
        }
    }
    return found;
}

double largestChange(const SeamGraph& seams, const CommonLengths& lengths) {
    double change = 0;
    for (std::size_t s = 0; s < seams.seams.size(); ++s) {
        const auto& sides = seams.seams[s].length3d;
        change = std::max(change, std::abs(lengths.factor[s] - 1) * std::max(sides[0], sides[1]));
    }
    return change;
}

}  // namespace toile
