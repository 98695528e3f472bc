// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <numeric>
#include <tuple>

#include "core/seam/matched_interval.h"

namespace toile::seam {
namespace {

// Cuts closer to each other than this fraction of the local edge length are merged. Parts that
// overlap by less do not compete.
constexpr double kMargin = 0.25;
// Below this fraction of the edge length two sides coincide: smaller gaps count as equal.
constexpr double kNoGap = 1e-3;
// A fold of a pleat is accepted only if no other seam competes for the place, or if that seam is
// this many times farther away: in a stack of layers everything is near.
constexpr double kFoldFactor = 10;

/// A part of a candidate: the unit of choice.
struct Part {
    int parent = 0;  ///< the candidate
    MatchedInterval interval;
    double cost = 0;         ///< gap relative to the local edge length; 0 if the sides coincide
    bool contested = false;  ///< another part overlaps this one
};

/// Those of the sorted places (in [0, length)) that lie inside `arc`, counted on like the arc.
std::vector<double> inside(const std::vector<double>& places, double length, Arc arc) {
    std::vector<double> found;
    double turn = std::floor(arc.from / length) * length;
    while (turn < arc.to) {
        auto at = std::lower_bound(places.begin(), places.end(), arc.from - turn);
        for (; at != places.end() && turn + *at < arc.to; ++at) {
            found.push_back(turn + *at);
        }
        turn += length;
    }
    return found;
}

std::vector<std::vector<double>> intervalEnds(const Outlines& outlines,
                                              const std::vector<MatchedInterval>& intervals) {
    std::vector<std::vector<double>> ends(outlines.list.size());
    for (const MatchedInterval& interval : intervals) {
        for (const Correspondence& f : {interval.line.front(), interval.line.back()}) {
            ends[interval.outlineA].push_back(outlines.list[interval.outlineA].wrap(f.a));
            ends[interval.outlineB].push_back(outlines.list[interval.outlineB].wrap(f.b));
        }
    }
    for (auto& places : ends) {
        std::sort(places.begin(), places.end());
    }
    return ends;
}

double costOf(const MatchedInterval& interval, const Outlines& outlines) {
    double cost = interval.meanGap() / interval.spacing(outlines);
    cost = cost < kNoGap ? 0 : cost;
    return interval.folded ? kFoldFactor * std::max(cost, kNoGap) : cost;
}

struct Claim {
    double from, to;
    int part;
};

/// Marks the parts that overlap another part on one outline.
void markContested(std::vector<Claim>& claims, double margin, std::vector<Part>& parts) {
    std::ranges::sort(claims, {}, [](const Claim& c) { return std::pair(c.from, c.part); });
    std::vector<Claim> open;
    for (const Claim& claim : claims) {
        std::erase_if(open, [&](const Claim& c) { return c.to <= claim.from + margin; });
        for (const Claim& other : open) {
            if (claim.to > claim.from + margin && other.part != claim.part) {
                parts[other.part].contested = parts[claim.part].contested = true;
            }
        }
        open.push_back(claim);
    }
}

void findContests(const Outlines& outlines, std::vector<Part>& parts) {
    std::vector<std::vector<Claim>> claims(outlines.list.size());
    const auto claim = [&](int piece, Arc arc, int part) {
        const Outline& outline = outlines.list[piece];
        const double from = outline.wrap(arc.from), to = from + arc.to - arc.from;
        claims[piece].push_back({from, std::min(to, outline.length()), part});
        if (to > outline.length()) {
            claims[piece].push_back({0, to - outline.length(), part});
        }
    };
    for (std::size_t k = 0; k < parts.size(); ++k) {
        claim(parts[k].interval.outlineA, parts[k].interval.arcA(), static_cast<int>(k));
        claim(parts[k].interval.outlineB, parts[k].interval.arcB(), static_cast<int>(k));
    }
    for (std::size_t p = 0; p < claims.size(); ++p) {
        const Outline& outline = outlines.list[p];
        if (outline.size() > 0) {
            markContested(claims[p], kMargin * outline.length() / outline.size(), parts);
        }
    }
}

/// Splits every interval where others begin or end on either of its outlines, and finds the parts
/// that compete.
std::vector<Part> cutIntoParts(const Outlines& outlines,
                               const std::vector<MatchedInterval>& intervals) {
    const auto ends = intervalEnds(outlines, intervals);
    std::vector<Part> parts;
    for (std::size_t k = 0; k < intervals.size(); ++k) {
        const MatchedInterval& interval = intervals[k];
        std::vector<double> cuts = inside(
            ends[interval.outlineA], outlines.list[interval.outlineA].length(), interval.arcA());
        for (const double b : inside(ends[interval.outlineB],
                                     outlines.list[interval.outlineB].length(), interval.arcB())) {
            cuts.push_back(interval.atB(b).a);
        }
        std::sort(cuts.begin(), cuts.end());
        const double margin = kMargin * interval.spacing(outlines);
        double from = interval.line.front().a;
        const double to = interval.line.back().a;
        const auto add = [&](double until) {
            Part part{.parent = static_cast<int>(k), .interval = interval.part({from, until})};
            part.cost = costOf(part.interval, outlines);
            parts.push_back(std::move(part));
            from = until;
        };
        for (const double cut : cuts) {
            if (cut > from + margin && cut < to - margin) {
                add(cut);
            }
        }
        add(to);
    }
    findContests(outlines, parts);
    return parts;
}

// Remainders beside chosen intervals that are shorter than this many local edges are end effects.
constexpr double kMinRest = 0.25;
// The same for edges that certainly match: only rounding is shorter.
constexpr double kMinCertain = 1e-9;
// If a garment's seams are closed more tightly than the tolerance, an interval is accepted only if
// its gap is below this many times the median, or below this fraction of the edge length.
constexpr double kGapTimesMedian = 10;
constexpr double kGapAlways = 0.05;
// Intervals found by proximity that are shorter than this many local edges are rejected.
constexpr double kShortest = 0.9;
// Sides closer than this many local edges coincide.
constexpr double kCoincident = 1e-4;
// A third layer must lie this close, relative to the local edge length.
constexpr double kStackedGap = 0.05;

class Chooser {
public:
    Chooser(const Outlines& outlines, const std::vector<MatchedInterval>& candidates)
        : outlines_(outlines), candidates_(candidates), parts_(cutIntoParts(outlines, candidates)) {
        revisit({});
    }

    std::vector<MatchedInterval> choose() {
        const std::vector<int> order = orderOfChoice();
        std::vector<MatchedInterval> chosen;
        for (const int k : order) {
            takeFree(parts_[k], chosen);
        }
        chosen = joinIntervals(outlines_, std::move(chosen), taken_);
        accept(chosen);
        revisit(chosen);
        std::vector<MatchedInterval> layers;
        for (const int k : order) {
            takeStacked(parts_[k], layers);
        }
        layers = joinIntervals(outlines_, std::move(layers), taken_);
        accept(layers);
        chosen.insert(chosen.end(), layers.begin(), layers.end());
        return chosen;
    }

private:
    std::vector<int> orderOfChoice() const {
        std::vector<double> undisputed(candidates_.size(), 0);
        for (const Part& part : parts_) {
            undisputed[part.parent] += part.contested ? 0 : part.interval.length();
        }
        std::vector<int> order(parts_.size());
        std::iota(order.begin(), order.end(), 0);
        std::ranges::stable_sort(order, {}, [&](int k) {
            const Part& part = parts_[k];
            return std::tuple(part.cost, -undisputed[part.parent], -part.interval.length());
        });
        return order;
    }

    void take(const MatchedInterval& interval) {
        taken_[interval.outlineA].add(interval.arcA());
        taken_[interval.outlineB].add(interval.arcB());
    }

    /// Chooses the stretches of the part that are free on both sides.
    void takeFree(const Part& part, std::vector<MatchedInterval>& chosen) {
        const double least =
            (part.interval.certain ? kMinCertain : kMinRest) * part.interval.spacing(outlines_);
        for (const Arc& a : taken_[part.interval.outlineA].outside(part.interval.arcA())) {
            const MatchedInterval half = part.interval.part(a);
            if (half.line.size() < 2 || half.length() < least) {
                continue;
            }
            for (const Arc& b : taken_[half.outlineB].outside(half.arcB())) {
                const MatchedInterval rest = half.partOnB(b);
                if (rest.line.size() > 1 && std::min(rest.length(), rest.lengthB()) >= least) {
                    chosen.push_back(rest);
                    take(rest);
                }
            }
        }
    }

    /// Chooses the stretches of the part that are free on one side only.
    void takeStacked(const Part& part, std::vector<MatchedInterval>& chosen) {
        if (part.cost > kStackedGap || part.interval.folded) {
            return;
        }
        const MatchedInterval& interval = part.interval;
        for (const Arc& a : taken_[interval.outlineA].outside(interval.arcA())) {
            takeLayer(interval.part(a), chosen);
        }
        for (const Arc& b : taken_[interval.outlineB].outside(interval.arcB())) {
            takeLayer(interval.partOnB(b), chosen);
        }
    }

    void takeLayer(const MatchedInterval& interval, std::vector<MatchedInterval>& chosen) {
        if (interval.line.size() > 1 &&
            interval.length() >= kMinRest * interval.spacing(outlines_)) {
            chosen.push_back(interval);
            chosen.back().stacked = true;
            take(interval);
        }
    }

    /// Removes intervals that are too short, or gape far more than this garment's seams.
    void accept(std::vector<MatchedInterval>& intervals) {
        const auto gapOf = [&](const MatchedInterval& interval) {
            return interval.meanGap() / interval.spacing(outlines_);
        };
        if (widest_ < 0) {
            std::vector<std::pair<double, double>> gaps;  // gap, length
            double total = 0;
            for (const MatchedInterval& interval : intervals) {
                gaps.emplace_back(gapOf(interval), interval.length());
                total += interval.length();
            }
            std::sort(gaps.begin(), gaps.end());
            double median = 0, below = 0;
            for (std::size_t k = 0; k < gaps.size() && below < 0.5 * total; ++k) {
                median = gaps[k].first;
                below += gaps[k].second;
            }
            widest_ = std::max(kGapAlways, kGapTimesMedian * median);
        }
        std::erase_if(intervals, [&](const MatchedInterval& interval) {
            // A whole edge that coincides with another is no accident; proximity needs more length.
            const double gap = gapOf(interval);
            const double least = gap < kCoincident ? kMinRest : kShortest;
            const double length = std::min(interval.length(), interval.lengthB());
            return !interval.certain &&
                   (length < least * interval.spacing(outlines_) || gap > widest_);
        });
    }

    void revisit(const std::vector<MatchedInterval>& intervals) {
        taken_.clear();
        for (const Outline& outline : outlines_.list) {
            taken_.emplace_back(outline.length());
        }
        for (const MatchedInterval& interval : intervals) {
            take(interval);
        }
    }

    const Outlines& outlines_;
    const std::vector<MatchedInterval>& candidates_;
    std::vector<Part> parts_;
    std::vector<ArcSet> taken_;
    double widest_ = -1;  ///< largest accepted gap in local edge lengths; negative: not yet known
};

}  // namespace

std::vector<MatchedInterval> chooseIntervals(const Outlines& outlines,
                                             const std::vector<MatchedInterval>& candidates) {
    return Chooser(outlines, candidates).choose();
}

}  // namespace toile::seam
