// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/seam/run.h"

#include <algorithm>
#include <numbers>

namespace toile {
namespace {

// An end is a tip where its two sides are at most this many local edges apart on the outline.
constexpr double kTipReach = 1.05;

Facing between(const Facing& p, const Facing& q, double t) {
    return {p.a + t * (q.a - p.a), p.b + t * (q.b - p.b), p.gap + t * (q.gap - p.gap)};
}

}  // namespace

void ArcSet::insert(Arc arc) {
    auto first = std::lower_bound(taken_.begin(), taken_.end(), arc.from,
                                  [](const Arc& a, double from) { return a.to < from; });
    auto last = first;
    for (; last != taken_.end() && last->from <= arc.to; ++last) {
        arc.from = std::min(arc.from, last->from);
        arc.to = std::max(arc.to, last->to);
    }
    taken_.insert(taken_.erase(first, last), arc);
}

void ArcSet::add(Arc arc) {
    const double from = arc.from - std::floor(arc.from / length_) * length_;
    const double to = from + std::min(arc.to - arc.from, length_);
    insert({from, std::min(to, length_)});
    if (to > length_) {
        insert({0, to - length_});
    }
}

std::vector<Arc> ArcSet::outside(Arc arc) const {
    std::vector<Arc> parts;
    double at = arc.from;
    double turn = std::floor(arc.from / length_) * length_;
    while (turn < arc.to) {
        auto next = std::lower_bound(taken_.begin(), taken_.end(), at - turn,
                                     [](const Arc& a, double s) { return a.to < s; });
        for (; next != taken_.end() && turn + next->from < arc.to; ++next) {
            if (turn + next->from > at) {
                parts.push_back({at, turn + next->from});
            }
            at = std::max(at, turn + next->to);
        }
        turn += length_;
    }
    if (at < arc.to) {
        parts.push_back({at, arc.to});
    }
    return parts;
}

Arc Run::arcB() const {
    return parallel ? Arc{line.front().b, line.back().b} : Arc{line.back().b, line.front().b};
}

Facing Run::atA(double a) const {
    const auto next = std::lower_bound(line.begin(), line.end(), a,
                                       [](const Facing& f, double s) { return f.a < s; });
    if (next == line.begin() || next == line.end()) {
        return next == line.end() ? line.back() : line.front();
    }
    const Facing& p = *(next - 1);
    return next->a > a ? between(p, *next, (a - p.a) / (next->a - p.a)) : *next;
}

Facing Run::atB(double b) const {
    const double sign = parallel ? 1 : -1;
    const auto next =
        std::lower_bound(line.begin(), line.end(), b,
                         [sign](const Facing& f, double s) { return sign * f.b < sign * s; });
    if (next == line.begin() || next == line.end()) {
        return next == line.end() ? line.back() : line.front();
    }
    const Facing& p = *(next - 1);
    return next->b != b ? between(p, *next, (b - p.b) / (next->b - p.b)) : *next;
}

Run Run::part(Arc onA) const {
    Run cut{outlineA, outlineB, parallel, certain, folded, {atA(onA.from)}};
    auto next = std::upper_bound(line.begin(), line.end(), onA.from,
                                 [](double s, const Facing& f) { return s < f.a; });
    for (; next != line.end() && next->a < onA.to; ++next) {
        cut.line.push_back(*next);
    }
    if (onA.to > onA.from) {
        cut.line.push_back(atA(onA.to));
    }
    return cut;
}

Run Run::partOnB(Arc onB) const {
    const double first = atB(onB.from).a, second = atB(onB.to).a;
    return part({std::min(first, second), std::max(first, second)});
}

double Run::meanGap() const {
    double sum = 0;
    for (std::size_t k = 1; k < line.size(); ++k) {
        sum += (line[k].a - line[k - 1].a) * 0.5 * (line[k].gap + line[k - 1].gap);
    }
    return length() > 0 ? sum / length() : line.front().gap;
}

double Run::spacing(const Outlines& outlines) const {
    const Facing middle = atA(0.5 * (line.front().a + line.back().a));
    return 0.5 * (outlines.list[outlineA].spacingAt(middle.a) +
                  outlines.list[outlineB].spacingAt(middle.b));
}

Tips tipsOf(const Run& run, const Outlines& outlines) {
    Tips tips;
    if (run.outlineA != run.outlineB || run.parallel) {
        return tips;
    }
    const Outline& outline = outlines.list[run.outlineA];
    const auto meet = [&](const Facing& f, double step) {
        // From the end of one side on to the end of the other, in the direction away from the run.
        const double apart = outline.wrap(step * (f.b - f.a));
        const double reach = kTipReach * outline.spacingAt(f.a);
        return apart < reach || outline.length() - apart < 0.01 * reach;
    };
    tips.end = meet(run.line.back(), 1);
    tips.start = meet(run.line.front(), -1);
    if (tips.start != tips.end) {
        const Facing& f = tips.end ? run.line.back() : run.line.front();
        double apart = outline.wrap(f.b - f.a);
        apart = apart > 0.5 * outline.length() ? apart - outline.length() : apart;
        const double tip = outline.wrap(f.a + 0.5 * apart);
        const int k = outline.edgeAt(tip);
        const bool first = tip - outline.arc[k] < outline.arc[k + 1] - tip;
        const bool atVertex =
            std::abs(outline.nearestVertex(tip) - tip) < 0.25 * outline.spacingAt(tip);
        tips.angle =
            atVertex ? outline.angle[first ? k : outline.wrapIndex(k + 1)] : std::numbers::pi;
    }
    return tips;
}

}  // namespace toile
