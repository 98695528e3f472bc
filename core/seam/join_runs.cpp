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
    Joiner(const Outlines& outlines, std::vector<Chosen> runs, std::vector<ArcSet>& taken)
        : outlines_(outlines), runs_(std::move(runs)), taken_(taken) {}

    std::vector<Chosen> joined() {
        std::ranges::sort(runs_, {}, [this](const Chosen& c) {
            return std::pair(groupOf(c), outlines_.list[c.run.outlineA].wrap(c.run.line.front().a));
        });
        findFollowers();
        std::vector<Chosen> whole;
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
    static std::tuple<int, int, bool, bool> groupOf(const Chosen& c) {
        return {c.run.outlineA, c.run.outlineB, c.run.parallel, c.stacked};
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

    bool follow(const Chosen& run, const Chosen& next) const {
        const bool bridge = !coincide(run.run) || !coincide(next.run);
        const double reach = bridge ? kBridge * run.run.spacing(outlines_) : 0;
        const auto near = [&](int piece, Arc gap) {
            const double least = kNoLength * outlines_.list[piece].length();
            return gap.to - gap.from <= std::max(reach, least) && isFree(piece, gap);
        };
        return near(run.run.outlineA, betweenA(run.run, next.run)) &&
               near(run.run.outlineB, betweenB(run.run, next.run));
    }

    bool coincide(const Run& run) const { return run.meanGap() < kJoined * run.spacing(outlines_); }

    bool isFree(int piece, Arc arc) const {
        double taken = arc.to - arc.from;
        for (const Arc& part : taken_[piece].outside(arc)) {
            taken -= part.to - part.from;
        }
        return taken <= kNoLength * outlines_.list[piece].length();
    }

    Chosen collect(int first) {
        Chosen whole = runs_[first];
        used_[first] = 1;
        for (int k = first; next_[k] >= 0 && !used_[next_[k]]; k = next_[k]) {
            used_[next_[k]] = 1;
            append(whole.run, runs_[next_[k]].run);
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
    std::vector<Chosen> runs_;
    std::vector<ArcSet>& taken_;
    std::vector<int> next_;
    std::vector<char> follows_, used_;
};

}  // namespace

std::vector<Chosen> joinRuns(const Outlines& outlines, std::vector<Chosen> runs,
                             std::vector<ArcSet>& taken) {
    return Joiner(outlines, std::move(runs), taken).joined();
}

}  // namespace toile
