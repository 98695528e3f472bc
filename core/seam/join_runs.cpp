// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <tuple>

#include "core/seam/run.h"

namespace toile {
namespace {

// Runs with fewer local edges than this between them are one seam: one that gapes a little, or
// whose sides turn too far apart at a corner.
constexpr double kBridge = 2.5;
// Runs whose sides are closer than this many local edges coincide: between two such, an edge that
// does not coincide is not sewn, and there is nothing to bridge.
constexpr double kJoined = 1e-4;
// Ends that differ by less than this fraction of the perimeter are one place.
constexpr double kNoLength = 1e-9;

class Joiner {
public:
    Joiner(const Outlines& outlines, std::vector<Run> runs, std::vector<ArcSet>& taken)
        : outlines_(outlines), runs_(std::move(runs)), taken_(taken) {}

    std::vector<Run> joined() {
        std::ranges::sort(runs_, {}, [this](const Run& run) {
            return std::pair(groupOf(run), outlines_.list[run.outlineA].wrap(run.line.front().a));
        });
        findFollowers();
        std::vector<Run> whole;
        // First from the runs that follow no other; what is left then are closed lines.
        for (const bool closedLines : {false, true}) {
            for (std::size_t k = 0; k < runs_.size(); ++k) {
                if (!used_[k] && (closedLines || !follows_[k])) {
                    whole.push_back(collect(static_cast<int>(k)));
                }
            }
        }
        return whole;
    }

private:
    /// What two runs that follow each other have in common.
    static std::tuple<int, int, bool, bool> groupOf(const Run& run) {
        return {run.outlineA, run.outlineB, run.parallel, run.stacked};
    }

    void findFollowers() {
        const int n = static_cast<int>(runs_.size());
        next_.assign(n, -1);
        follows_.assign(n, 0);
        used_.assign(n, 0);
        for (int from = 0, to = 0; from < n; from = to) {
            while (to < n && groupOf(runs_[to]) == groupOf(runs_[from])) {
                ++to;
            }
            for (int k = from; k < to; ++k) {
                const int next = k + 1 < to ? k + 1 : from;
                if (next != k && follow(runs_[k], runs_[next])) {
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

    Arc betweenA(const Run& run, const Run& next) const {
        return between(run.arcA(), next.arcA(), outlines_.list[run.outlineA]);
    }

    Arc betweenB(const Run& run, const Run& next) const {
        const Outline& outline = outlines_.list[run.outlineB];
        return run.parallel ? between(run.arcB(), next.arcB(), outline)
                            : between(next.arcB(), run.arcB(), outline);
    }

    bool follow(const Run& run, const Run& next) const {
        const bool bridge = !coincide(run) || !coincide(next);
        const double reach = bridge ? kBridge * run.spacing(outlines_) : 0;
        const auto near = [&](int piece, Arc gap) {
            const double least = kNoLength * outlines_.list[piece].length();
            return gap.to - gap.from <= std::max(reach, least) && isFree(piece, gap);
        };
        return near(run.outlineA, betweenA(run, next)) && near(run.outlineB, betweenB(run, next));
    }

    bool coincide(const Run& run) const { return run.meanGap() < kJoined * run.spacing(outlines_); }

    bool isFree(int piece, Arc arc) const {
        double taken = arc.to - arc.from;
        for (const Arc& part : taken_[piece].outside(arc)) {
            taken -= part.to - part.from;
        }
        return taken <= kNoLength * outlines_.list[piece].length();
    }

    Run collect(int first) {
        Run whole = runs_[first];
        used_[first] = 1;
        for (int k = first; next_[k] >= 0 && !used_[next_[k]]; k = next_[k]) {
            used_[next_[k]] = 1;
            append(whole, runs_[next_[k]]);
        }
        return whole;
    }

    void append(Run& run, const Run& next) {
        const Arc a = betweenA(run, next), b = betweenB(run, next);
        taken_[run.outlineA].add(a);
        taken_[run.outlineB].add(b);
        const double shiftA = a.to - next.line.front().a;
        const double shiftB =
            (run.parallel ? b.to : run.line.back().b - (b.to - b.from)) - next.line.front().b;
        const bool touching = a.to == a.from && b.to == b.from;
        for (std::size_t k = touching ? 1 : 0; k < next.line.size(); ++k) {
            const Facing& f = next.line[k];
            run.line.push_back({f.a + shiftA, f.b + shiftB, f.gap});
        }
        run.certain = run.certain && next.certain;
        run.folded = run.folded || next.folded;
    }

    const Outlines& outlines_;
    std::vector<Run> runs_;
    std::vector<ArcSet>& taken_;
    std::vector<int> next_;
    std::vector<char> follows_, used_;
};

}  // namespace

std::vector<Run> joinRuns(const Outlines& outlines, std::vector<Run> runs,
                          std::vector<ArcSet>& taken) {
    return Joiner(outlines, std::move(runs), taken).joined();
}

}  // namespace toile
