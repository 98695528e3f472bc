// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/symmetry/mirror_segments.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/seam/seam_measure.h"

namespace toile {
namespace {

using SegmentLoop = std::vector<MirrorSegment>;

/// Difference of two lengths, as a fraction of the longer.
double difference(double a, double b) {
    const double longer = std::max(a, b);
    return longer > 0 ? std::abs(a - b) / longer : 0;
}

/// Two outlines whose segments may mirror each other; the same one if a piece is symmetric.
class OutlinePair {
public:
    OutlinePair(const SegmentLoop& from, const SegmentLoop& to, const std::vector<int>& counterpart,
                const MirrorPlane& plane)
        : from_(from), to_(to), counterpart_(counterpart), plane_(plane) {}

    /// Per segment of the first outline, its partner on the second, or -1.
    std::vector<int> paired() const {
        const int rotation = bestRotation();
        const double most = rotation >= 0 ? kMaxDifferenceInOrder : kMaxDifferenceAlone;
        std::vector<int> partner(from_.size(), -1);
        for (int i = 0; i < size(); ++i) {
            const int other = rotation >= 0 ? partnerOf(i, rotation) : onlyPartner(from_[i]);
            if (other >= 0 && difference(from_[i].length, to_[other].length) <= most) {
                partner[i] = other;
            }
        }
        return partner;
    }

private:
    int size() const { return static_cast<int>(from_.size()); }

    /// The outlines run in opposite directions: the sum of two partners' indices is constant.
    int partnerOf(int i, int rotation) const { return (rotation - i + size()) % size(); }

    bool neighboursAgree(const MirrorSegment& a, const MirrorSegment& b) const {
        return mirrored(a.neighbour) == b.neighbour ||
               (isUnpaired(a.neighbour) && isUnpaired(b.neighbour));
    }
    bool isUnpaired(int piece) const { return piece >= 0 && counterpart_[piece] < 0; }
    int mirrored(int piece) const {
        constexpr int kNoPiece = -2;
        return piece < 0 ? -1 : counterpart_[piece] < 0 ? kNoPiece : counterpart_[piece];
    }

    /// -1 if no rotation gives matching neighbours.
    int bestRotation() const {
        int best = -1;
        double least = std::numeric_limits<double>::infinity();
        for (int rotation = 0; from_.size() == to_.size() && rotation < size(); ++rotation) {
            double sum = 0;
            bool agrees = true;
            for (int i = 0; i < size() && agrees; ++i) {
                const MirrorSegment& other = to_[partnerOf(i, rotation)];
                agrees = neighboursAgree(from_[i], other);
                sum += (plane_.reflected(from_[i].middle) - other.middle).squaredNorm();
            }
            if (agrees && sum < least) {
                best = rotation;
                least = sum;
            }
        }
        return best;
    }

    /// The only segment of the second outline with the same neighbour, whatever the order.
    int onlyPartner(const MirrorSegment& segment) const {
        const auto isLikeIt = [&](const MirrorSegment& a) {
            return a.neighbour == segment.neighbour;
        };
        const auto isPartner = [&](const MirrorSegment& b) {
            return mirrored(segment.neighbour) == b.neighbour;
        };
        if (std::ranges::count_if(from_, isLikeIt) != 1 ||
            std::ranges::count_if(to_, isPartner) != 1) {
            return -1;
        }
        return static_cast<int>(std::ranges::find_if(to_, isPartner) - to_.begin());
    }

    const SegmentLoop& from_;
    const SegmentLoop& to_;
    const std::vector<int>& counterpart_;
    const MirrorPlane& plane_;
};

}  // namespace

SegmentPairs pairSegments(const MirrorSegments& segments, const std::vector<int>& counterpart,
                          const MirrorPlane& plane) {
    SegmentPairs pairs(segments.size());
    for (std::size_t p = 0; p < segments.size(); ++p) {
        pairs[p].assign(segments[p].size(), -1);
    }
    for (int p = 0; p < static_cast<int>(segments.size()); ++p) {
        const int q = counterpart[p];
        if (q < p) {
            continue;
        }
        pairs[p] = OutlinePair(segments[p], segments[q], counterpart, plane).paired();
        for (std::size_t i = 0; i < pairs[p].size(); ++i) {
            if (pairs[p][i] >= 0) {
                pairs[q][pairs[p][i]] = static_cast<int>(i);
            }
        }
    }
    return pairs;
}

std::vector<SegmentPlace> unpairedSegments(const SegmentPairs& pairs) {
    std::vector<SegmentPlace> places;
    for (std::size_t p = 0; p < pairs.size(); ++p) {
        for (std::size_t i = 0; i < pairs[p].size(); ++i) {
            if (pairs[p][i] < 0) {
                places.push_back({static_cast<int>(p), static_cast<int>(i)});
            }
        }
    }
    return places;
}

namespace {

/// The point half-way along a polyline, by length.
Eigen::Vector3d middleOf(const Points3& line) {
    double rest = 0;
    for (Eigen::Index i = 1; i < line.rows(); ++i) {
        rest += 0.5 * (line.row(i) - line.row(i - 1)).norm();
    }
    for (Eigen::Index i = 1; i < line.rows(); ++i) {
        const double length = (line.row(i) - line.row(i - 1)).norm();
        if (rest <= length && length > 0) {
            return line.row(i - 1) + rest / length * (line.row(i) - line.row(i - 1));
        }
        rest -= length;
    }
    return line.rows() > 0 ? Eigen::Vector3d(line.row(line.rows() - 1)) : Eigen::Vector3d::Zero();
}

/// A segment and its start on the outline.
struct PlacedSegment {
    double at;
    MirrorSegment segment;
};

}  // namespace

MirrorSegments seamSegments(const Garment& garment) {
    std::vector<std::vector<PlacedSegment>> placed(garment.pieces.size());
    const auto add = [&](const SeamSide& side, int neighbour, int seam, bool isRight) {
        if (side.piece < 0 || side.loop != 0) {
            return;
        }
        const Points3 line = spaceLine(side, *garment.pieces[side.piece]);
        placed[side.piece].push_back(
            {std::min(side.start, side.end),
             {side.piece, neighbour, side.length(), middleOf(line), seam, isRight}});
    };
    const std::vector<Seam>& seams = garment.seams.seams;
    for (int s = 0; s < static_cast<int>(seams.size()); ++s) {
        add(seams[s].left, seams[s].right.piece, s, false);
        if (!seams[s].stacked) {
            add(seams[s].right, seams[s].left.piece, s, true);
        }
    }
    MirrorSegments segments(garment.pieces.size());
    for (std::size_t p = 0; p < placed.size(); ++p) {
        std::ranges::stable_sort(placed[p], {}, &PlacedSegment::at);
        for (const PlacedSegment& one : placed[p]) {
            segments[p].push_back(one.segment);
        }
    }
    return segments;
}

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
