// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/symmetry/mirror_segments.h"

#include <algorithm>
#include <cmath>
#include <limits>

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

}  // namespace toile
