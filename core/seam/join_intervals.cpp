// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <tuple>

#include "core/seam/matched_interval.h"

namespace toile::seam {
namespace {

// Intervals separated by fewer local edges than this are one seam, with a small gap or with sides
// that diverge at a corner.
constexpr double kBridge = 2.5;
// Intervals whose sides are closer than this many local edges coincide. An edge between two such
// intervals that does not coincide is not sewn, and is not bridged.
constexpr double kJoined = 1e-4;
// Ends that differ by less than this fraction of the perimeter are equal.
constexpr double kNoLength = 1e-9;

class Joiner {
public:
    Joiner(const Outlines& outlines, std::vector<MatchedInterval> intervals,
           std::vector<ArcSet>& taken)
        : outlines_(outlines), intervals_(std::move(intervals)), taken_(taken) {}

    std::vector<MatchedInterval> joined() {
        std::ranges::sort(intervals_, {}, [this](const MatchedInterval& interval) {
            return std::pair(groupOf(interval),
                             outlines_.list[interval.outlineA].wrap(interval.line.front().a));
        });
        findFollowers();
        std::vector<MatchedInterval> whole;
        // First intervals without a predecessor; the remaining ones form closed lines.
        for (const bool closedLines : {false, true}) {
            for (std::size_t k = 0; k < intervals_.size(); ++k) {
                if (!used_[k] && (closedLines || !follows_[k])) {
                    whole.push_back(collect(static_cast<int>(k)));
                }
            }
        }
        return whole;
    }

private:
    /// Properties that two consecutive intervals must share.
    static std::tuple<int, int, bool, bool> groupOf(const MatchedInterval& interval) {
        return {interval.outlineA, interval.outlineB, interval.parallel, interval.stacked};
    }

    void findFollowers() {
        const int n = static_cast<int>(intervals_.size());
        next_.assign(n, -1);
        follows_.assign(n, 0);
        used_.assign(n, 0);
        for (int from = 0, to = 0; from < n; from = to) {
            while (to < n && groupOf(intervals_[to]) == groupOf(intervals_[from])) {
                ++to;
            }
            for (int k = from; k < to; ++k) {
                const int next = k + 1 < to ? k + 1 : from;
                if (next != k && follow(intervals_[k], intervals_[next])) {
                    next_[k] = next;
                    follows_[next] = 1;
                }
            }
        }
    }

    /// The arc from the end of the first to the beginning of the second.
    static Arc between(Arc first, Arc second, const Outline& outline) {
        const double apart = outline.wrap(second.from - first.to);
        return {first.to, first.to + (apart > (1 - kNoLength) * outline.length() ? 0 : apart)};
    }

    Arc betweenA(const MatchedInterval& interval, const MatchedInterval& next) const {
        return between(interval.arcA(), next.arcA(), outlines_.list[interval.outlineA]);
    }

    Arc betweenB(const MatchedInterval& interval, const MatchedInterval& next) const {
        const Outline& outline = outlines_.list[interval.outlineB];
        return interval.parallel ? between(interval.arcB(), next.arcB(), outline)
                                 : between(next.arcB(), interval.arcB(), outline);
    }

    bool follow(const MatchedInterval& interval, const MatchedInterval& next) const {
        const bool bridge = !coincide(interval) || !coincide(next);
        const double longest = bridge ? kBridge * interval.spacing(outlines_) : 0;
        const auto near = [&](int piece, Arc gap) {
            const double least = kNoLength * outlines_.list[piece].length();
            return gap.to - gap.from <= std::max(longest, least) && isFree(piece, gap);
        };
        return near(interval.outlineA, betweenA(interval, next)) &&
               near(interval.outlineB, betweenB(interval, next));
    }

    bool coincide(const MatchedInterval& interval) const {
        return interval.meanGap() < kJoined * interval.spacing(outlines_);
    }

    bool isFree(int piece, Arc arc) const {
        double taken = arc.to - arc.from;
        for (const Arc& part : taken_[piece].outside(arc)) {
            taken -= part.to - part.from;
        }
        return taken <= kNoLength * outlines_.list[piece].length();
    }

    MatchedInterval collect(int first) {
        MatchedInterval whole = intervals_[first];
        used_[first] = 1;
        for (int k = first; next_[k] >= 0 && !used_[next_[k]]; k = next_[k]) {
            used_[next_[k]] = 1;
            append(whole, intervals_[next_[k]]);
        }
        return whole;
    }

    void append(MatchedInterval& interval, const MatchedInterval& next) {
        const Arc a = betweenA(interval, next), b = betweenB(interval, next);
        taken_[interval.outlineA].add(a);
        taken_[interval.outlineB].add(b);
        const double shiftA = a.to - next.line.front().a;
        const double shiftB =
            (interval.parallel ? b.to : interval.line.back().b - (b.to - b.from)) -
            next.line.front().b;
        const bool touching = a.to == a.from && b.to == b.from;
        for (std::size_t k = touching ? 1 : 0; k < next.line.size(); ++k) {
            const Correspondence& f = next.line[k];
            interval.line.push_back({f.a + shiftA, f.b + shiftB, f.gap});
        }
        interval.certain = interval.certain && next.certain;
        interval.folded = interval.folded || next.folded;
    }

    const Outlines& outlines_;
    std::vector<MatchedInterval> intervals_;
    std::vector<ArcSet>& taken_;
    std::vector<int> next_;
    std::vector<char> follows_, used_;
};

}  // namespace

std::vector<MatchedInterval> joinIntervals(const Outlines& outlines,
                                           std::vector<MatchedInterval> intervals,
                                           std::vector<ArcSet>& taken) {
    return Joiner(outlines, std::move(intervals), taken).joined();
}

}  // namespace toile::seam
