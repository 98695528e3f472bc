// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/seam/run.h"

#include <algorithm>
#include <array>
#include <numbers>

namespace toile {
namespace {

// An end is a tip where its two sides are at most this many local edges apart on the outline.
constexpr double kTipReach = 1.05;

Facing between(const Facing& p, const Facing& q, double t) {
    return {p.a + t * (q.a - p.a), p.b + t * (q.b - p.b), p.gap + t * (q.gap - p.gap)};
}

/// The facing places at a place on one side; that side runs upwards times `sign`.
Facing facingAt(const std::vector<Facing>& line, double Facing::*side, double sign, double s) {
    const auto next = std::ranges::lower_bound(line, sign * s, {},
                                               [&](const Facing& f) { return sign * f.*side; });
    if (next == line.begin() || next == line.end()) {
        return next == line.end() ? line.back() : line.front();
    }
    const Facing& p = *(next - 1);
    const double before = p.*side, after = *next.*side;
    return after != s ? between(p, *next, (s - before) / (after - before)) : *next;
}

}  // namespace

void ArcSet::insert(Arc arc) {
    auto first = std::ranges::lower_bound(taken_, arc.from, {}, &Arc::to);
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
        auto next = std::ranges::lower_bound(taken_, at - turn, {}, &Arc::to);
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
    return facingAt(line, &Facing::a, 1, a);
}

Facing Run::atB(double b) const {
    return facingAt(line, &Facing::b, parallel ? 1 : -1, b);
}

Run Run::part(Arc onA) const {
    Run cut{outlineA, outlineB, parallel, certain, folded, stacked, {atA(onA.from)}};
    auto next = std::ranges::upper_bound(line, onA.from, {}, &Facing::a);
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

namespace {

// A tip with a larger inner angle lies inside the cloth: the point of a dart. A pleat's fold lies
// on a plain edge, with an angle near pi.
constexpr double kDartAngle = 1.5 * std::numbers::pi;

/// Walks from contact to contact along both outlines.
class Chainer {
public:
    Chainer(const Outlines& outlines, const std::vector<Contact>& contacts)
        : outlines_(outlines), contacts_(contacts), seen_(contacts.size(), 0) {}

    std::vector<Run> runs() {
        std::vector<Run> found;
        for (std::size_t c = 0; c < contacts_.size(); ++c) {
            if (!seen_[c]) {
                Run run = walkFrom(static_cast<int>(c));
                if (run.line.size() > 1) {
                    found.push_back(std::move(run));
                }
            }
        }
        return found;
    }

private:
    /// A contact on the walk: seen from side a, or `swapped`; edges counted on past either end.
    struct Step {
        int contact;
        int i, j;
        bool swapped;
    };

    Run walkFrom(int first) {
        const Contact& c = contacts_[first];
        Run run;
        run.outlineA = outlines_.outlineOf[c.a];
        run.outlineB = outlines_.outlineOf[c.b];
        run.parallel = c.parallel;
        run.certain = true;
        std::vector<Step> todo{{first, outlines_.local(c.a), outlines_.local(c.b), false}};
        seen_[first] = 1;
        while (!todo.empty()) {
            const Step step = todo.back();
            todo.pop_back();
            run.certain = run.certain && contacts_[step.contact].certain;
            addFacing(run, step);
            pushNeighbours(run, step, todo);
        }
        straighten(run);
        const Tips tips = tipsOf(run, outlines_);
        run.folded = tips.start != tips.end && tips.angle < kDartAngle && !run.certain;
        return run;
    }

    void addFacing(Run& run, const Step& step) const {
        const Contact& c = contacts_[step.contact];
        const double a = outlines_.list[run.outlineA].arcOf(step.i);
        const double b = outlines_.list[run.outlineB].arcOf(step.j);
        run.line.push_back(
            {a + (step.swapped ? c.b0 : c.a0), b + (step.swapped ? c.a0 : c.b0), c.gap0});
        run.line.push_back(
            {a + (step.swapped ? c.b1 : c.a1), b + (step.swapped ? c.a1 : c.b1), c.gap1});
    }

    void pushNeighbours(const Run& run, const Step& step, std::vector<Step>& todo) {
        const int along = run.parallel ? 1 : -1;
        const std::array<std::array<int, 2>, 6> moves{
            {{1, 0}, {0, along}, {1, along}, {-1, 0}, {0, -along}, {-1, -along}}};
        for (const auto& [di, dj] : moves) {
            const int i = step.i + di, j = step.j + dj;
            const int a =
                outlines_.firstEdge[run.outlineA] + outlines_.list[run.outlineA].wrapIndex(i);
            const int b =
                outlines_.firstEdge[run.outlineB] + outlines_.list[run.outlineB].wrapIndex(j);
            const int next = find(std::min(a, b), std::max(a, b));
            if (next >= 0 && !seen_[next] && contacts_[next].parallel == run.parallel) {
                seen_[next] = 1;
                todo.push_back({next, i, j, a > b});
            }
        }
    }

    int find(int a, int b) const {
        const auto at = std::ranges::lower_bound(
            contacts_, std::pair(a, b), {}, [](const Contact& c) { return std::pair(c.a, c.b); });
        const bool hit = at != contacts_.end() && at->a == a && at->b == b;
        return hit ? static_cast<int>(at - contacts_.begin()) : -1;
    }

    /// Puts the facing places in order along the seam and takes out what runs back: at corners of
    /// differently sampled outlines neighbouring contacts overlap a little.
    void straighten(Run& run) const {
        const double sign = run.parallel ? 1 : -1;
        std::vector<Facing>& line = run.line;
        std::ranges::sort(line, {},
                          [sign](const Facing& f) { return std::pair(f.a + sign * f.b, f.a); });
        for (std::size_t k = 1; k < line.size(); ++k) {
            line[k].a = std::max(line[k].a, line[k - 1].a);
            line[k].b = sign * std::max(sign * line[k].b, sign * line[k - 1].b);
        }
        const double tiny = 1e-9 * outlines_.list[run.outlineA].spacingAt(line.front().a);
        line.erase(std::unique(line.begin(), line.end(),
                               [tiny](const Facing& p, const Facing& q) {
                                   return std::abs(q.a - p.a) <= tiny &&
                                          std::abs(q.b - p.b) <= tiny;
                               }),
                   line.end());
        // A seam that closes may overlap itself by a rounding error or a corner: once round is all.
        const bool self = run.outlineA == run.outlineB;
        const double used = run.length() + (self ? run.lengthB() : 0.0);
        const double there = outlines_.list[run.outlineA].length();
        if (used > there) {
            const double from = line.front().a;
            run = run.part({from, from + run.length() * there / used});
        }
    }

    const Outlines& outlines_;
    const std::vector<Contact>& contacts_;
    std::vector<char> seen_;
};

}  // namespace

std::vector<Run> chainContacts(const Outlines& outlines, const std::vector<Contact>& contacts) {
    return Chainer(outlines, contacts).runs();
}

}  // namespace toile
