// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "core/seam/choose_runs.h"

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
    std::sort(claims.begin(), claims.end(), [](const Claim& x, const Claim& y) {
        return x.from != y.from ? x.from < y.from : x.part < y.part;
    });
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

}  // namespace

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

}  // namespace toile
