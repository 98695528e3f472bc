// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <numeric>
#include <tuple>

#include "core/seam/run.h"

namespace toile {
namespace {

// Cuts nearer to each other than this fraction of the local edge length are one cut, and parts that
// overlap by less do not compete.
constexpr double kMargin = 0.25;
// Below this fraction of the edge length two sides coincide: a smaller gap is no better.
constexpr double kNoGap = 1e-3;
// A pleat's fold is believed only where no other seam wants the place, unless that lies this much
// farther off: in a stack of layers everything is near.
constexpr double kFoldFactor = 10;

/// A part of a candidate run: the unit of choice.
struct Part {
    int parent = 0;  ///< the candidate run
    Run run;
    double cost = 0;         ///< gap relative to the local edge length, 0 where it coincides
    bool contested = false;  ///< another part lies on the same place
};

/// Places inside `arc` of the sorted places (in [0, length)), counted on like the arc.
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

std::vector<std::vector<double>> runEnds(const Outlines& outlines, const std::vector<Run>& runs) {
    std::vector<std::vector<double>> ends(outlines.list.size());
    for (const Run& run : runs) {
        for (const Facing& f : {run.line.front(), run.line.back()}) {
            ends[run.outlineA].push_back(outlines.list[run.outlineA].wrap(f.a));
            ends[run.outlineB].push_back(outlines.list[run.outlineB].wrap(f.b));
        }
    }
    for (auto& places : ends) {
        std::sort(places.begin(), places.end());
    }
    return ends;
}

double costOf(const Run& run, const Outlines& outlines) {
    double cost = run.meanGap() / run.spacing(outlines);
    cost = cost < kNoGap ? 0 : cost;
    return run.folded ? kFoldFactor * std::max(cost, kNoGap) : cost;
}

struct Claim {
    double from, to;
    int part;
};

/// Marks the parts that lie on a place of another, on one outline.
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
        claim(parts[k].run.outlineA, parts[k].run.arcA(), static_cast<int>(k));
        claim(parts[k].run.outlineB, parts[k].run.arcB(), static_cast<int>(k));
    }
    for (std::size_t p = 0; p < claims.size(); ++p) {
        const Outline& outline = outlines.list[p];
        if (outline.size() > 0) {
            markContested(claims[p], kMargin * outline.length() / outline.size(), parts);
        }
    }
}

/// Cuts every run at the places where others begin or end on either of its outlines, and finds out
/// which parts compete.
std::vector<Part> cutIntoParts(const Outlines& outlines, const std::vector<Run>& runs) {
    const auto ends = runEnds(outlines, runs);
    std::vector<Part> parts;
    for (std::size_t k = 0; k < runs.size(); ++k) {
        const Run& run = runs[k];
        std::vector<double> cuts =
            inside(ends[run.outlineA], outlines.list[run.outlineA].length(), run.arcA());
        for (const double b :
             inside(ends[run.outlineB], outlines.list[run.outlineB].length(), run.arcB())) {
            cuts.push_back(run.atB(b).a);
        }
        std::sort(cuts.begin(), cuts.end());
        const double margin = kMargin * run.spacing(outlines);
        double from = run.line.front().a;
        const double to = run.line.back().a;
        const auto add = [&](double until) {
            Part part{.parent = static_cast<int>(k), .run = run.part({from, until})};
            part.cost = costOf(part.run, outlines);
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

// Rests shorter than this many local edges, left over beside runs already chosen, are end effects.
constexpr double kLeastRest = 0.25;
// The same for edges that are certainly one: only rounding is less.
constexpr double kLeastCertain = 1e-9;
// Where the seams of a garment are closed more tightly than the tolerance, a run is believed if its
// gap is below this many times the garment's own, or below this fraction of the edge length.
constexpr double kGapTimesMedian = 10;
constexpr double kGapAlways = 0.05;
// A run found by nearness that is shorter than this many local edges is not believed.
constexpr double kShortest = 0.9;
// Sides closer than this many local edges coincide.
constexpr double kCoincident = 1e-4;
// A third layer must lie this close, relative to the local edge length.
constexpr double kStackedGap = 0.05;

class Chooser {
public:
    Chooser(const Outlines& outlines, const std::vector<Run>& candidates)
        : outlines_(outlines), candidates_(candidates), parts_(cutIntoParts(outlines, candidates)) {
        retake({});
    }

    std::vector<Run> choose() {
        const std::vector<int> order = orderOfChoice();
        std::vector<Run> chosen;
        for (const int k : order) {
            takeFree(parts_[k], chosen);
        }
        chosen = joinRuns(outlines_, std::move(chosen), taken_);
        believe(chosen);
        retake(chosen);
        std::vector<Run> layers;
        for (const int k : order) {
            takeStacked(parts_[k], layers);
        }
        layers = joinRuns(outlines_, std::move(layers), taken_);
        believe(layers);
        chosen.insert(chosen.end(), layers.begin(), layers.end());
        return chosen;
    }

private:
    std::vector<int> orderOfChoice() const {
        std::vector<double> undisputed(candidates_.size(), 0);
        for (const Part& part : parts_) {
            undisputed[part.parent] += part.contested ? 0 : part.run.length();
        }
        std::vector<int> order(parts_.size());
        std::iota(order.begin(), order.end(), 0);
        std::ranges::stable_sort(order, {}, [&](int k) {
            const Part& part = parts_[k];
            return std::tuple(part.cost, -undisputed[part.parent], -part.run.length());
        });
        return order;
    }

    void take(const Run& run) {
        taken_[run.outlineA].add(run.arcA());
        taken_[run.outlineB].add(run.arcB());
    }

    /// Takes what of the part is free on both sides.
    void takeFree(const Part& part, std::vector<Run>& chosen) {
        const double least =
            (part.run.certain ? kLeastCertain : kLeastRest) * part.run.spacing(outlines_);
        for (const Arc& a : taken_[part.run.outlineA].outside(part.run.arcA())) {
            const Run half = part.run.part(a);
            if (half.line.size() < 2 || half.length() < least) {
                continue;
            }
            for (const Arc& b : taken_[half.outlineB].outside(half.arcB())) {
                const Run rest = half.partOnB(b);
                if (rest.line.size() > 1 && std::min(rest.length(), rest.lengthB()) >= least) {
                    chosen.push_back(rest);
                    take(rest);
                }
            }
        }
    }

    /// Takes what of the part is free on one side only.
    void takeStacked(const Part& part, std::vector<Run>& chosen) {
        if (part.cost > kStackedGap || part.run.folded) {
            return;
        }
        const Run& run = part.run;
        for (const Arc& a : taken_[run.outlineA].outside(run.arcA())) {
            takeLayer(run.part(a), chosen);
        }
        for (const Arc& b : taken_[run.outlineB].outside(run.arcB())) {
            takeLayer(run.partOnB(b), chosen);
        }
    }

    void takeLayer(const Run& run, std::vector<Run>& chosen) {
        if (run.line.size() > 1 && run.length() >= kLeastRest * run.spacing(outlines_)) {
            chosen.push_back(run);
            chosen.back().stacked = true;
            take(run);
        }
    }

    /// Takes out runs that are too short, or gape more than this garment's seams do.
    void believe(std::vector<Run>& runs) {
        const auto gapOf = [&](const Run& run) { return run.meanGap() / run.spacing(outlines_); };
        if (widest_ < 0) {
            std::vector<std::pair<double, double>> gaps;  // gap, length
            double total = 0;
            for (const Run& run : runs) {
                gaps.emplace_back(gapOf(run), run.length());
                total += run.length();
            }
            std::sort(gaps.begin(), gaps.end());
            double median = 0, below = 0;
            for (std::size_t k = 0; k < gaps.size() && below < 0.5 * total; ++k) {
                median = gaps[k].first;
                below += gaps[k].second;
            }
            widest_ = std::max(kGapAlways, kGapTimesMedian * median);
        }
        std::erase_if(runs, [&](const Run& run) {
            // One whole edge that coincides with another is no accident; nearness needs more.
            const double gap = gapOf(run);
            const double least = gap < kCoincident ? kLeastRest : kShortest;
            const double length = std::min(run.length(), run.lengthB());
            return !run.certain && (length < least * run.spacing(outlines_) || gap > widest_);
        });
    }

    void retake(const std::vector<Run>& runs) {
        taken_.clear();
        for (const Outline& outline : outlines_.list) {
            taken_.emplace_back(outline.length());
        }
        for (const Run& run : runs) {
            take(run);
        }
    }

    const Outlines& outlines_;
    const std::vector<Run>& candidates_;
    std::vector<Part> parts_;
    std::vector<ArcSet> taken_;
    double widest_ = -1;  ///< largest believable gap in local edge lengths; negative: not yet known
};

}  // namespace

std::vector<Run> chooseRuns(const Outlines& outlines, const std::vector<Run>& candidates) {
    return Chooser(outlines, candidates).choose();
}

}  // namespace toile
