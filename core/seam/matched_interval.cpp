// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/seam/matched_interval.h"

#include <algorithm>
#include <array>
#include <numbers>

namespace toile::seam {
namespace {

// An end is a fold end if its two sides are at most this many local edges apart on the outline.
constexpr double kMaxFoldEndGap = 1.05;

Correspondence between(const Correspondence& p, const Correspondence& q, double t) {
    return {p.a + t * (q.a - p.a), p.b + t * (q.b - p.b), p.gap + t * (q.gap - p.gap)};
}

/// The facing places at a place on one side. That side's places increase times `sign`.
Correspondence correspondenceAt(const std::vector<Correspondence>& line,
                                double Correspondence::*side, double sign, double s) {
    const auto next = std::ranges::lower_bound(
        line, sign * s, {}, [&](const Correspondence& f) { return sign * f.*side; });
    if (next == line.begin() || next == line.end()) {
        return next == line.end() ? line.back() : line.front();
    }
    const Correspondence& p = *(next - 1);
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

Arc MatchedInterval::arcB() const {
    return parallel ? Arc{line.front().b, line.back().b} : Arc{line.back().b, line.front().b};
}

Correspondence MatchedInterval::atA(double a) const {
    return correspondenceAt(line, &Correspondence::a, 1, a);
}

Correspondence MatchedInterval::atB(double b) const {
    return correspondenceAt(line, &Correspondence::b, parallel ? 1 : -1, b);
}

MatchedInterval MatchedInterval::part(Arc onA) const {
    MatchedInterval cut{outlineA, outlineB, parallel, certain, folded, stacked, {atA(onA.from)}};
    auto next = std::ranges::upper_bound(line, onA.from, {}, &Correspondence::a);
    for (; next != line.end() && next->a < onA.to; ++next) {
        cut.line.push_back(*next);
    }
    if (onA.to > onA.from) {
        cut.line.push_back(atA(onA.to));
    }
    return cut;
}

MatchedInterval MatchedInterval::partOnB(Arc onB) const {
    const double first = atB(onB.from).a, second = atB(onB.to).a;
    return part({std::min(first, second), std::max(first, second)});
}

double MatchedInterval::meanGap() const {
    double sum = 0;
    for (std::size_t k = 1; k < line.size(); ++k) {
        sum += (line[k].a - line[k - 1].a) * 0.5 * (line[k].gap + line[k - 1].gap);
    }
    return length() > 0 ? sum / length() : line.front().gap;
}

double MatchedInterval::spacing(const Outlines& outlines) const {
    const Correspondence middle = atA(0.5 * (line.front().a + line.back().a));
    return 0.5 * (outlines.list[outlineA].spacingAt(middle.a) +
                  outlines.list[outlineB].spacingAt(middle.b));
}

FoldEnds foldEndsOf(const MatchedInterval& interval, const Outlines& outlines) {
    FoldEnds foldEnds;
    if (interval.outlineA != interval.outlineB || interval.parallel) {
        return foldEnds;
    }
    const Outline& outline = outlines.list[interval.outlineA];
    const auto meet = [&](const Correspondence& f, double step) {
        // From the end of one side to that of the other, away from the interval.
        const double apart = outline.wrap(step * (f.b - f.a));
        const double most = kMaxFoldEndGap * outline.spacingAt(f.a);
        return apart < most || outline.length() - apart < 0.01 * most;
    };
    foldEnds.end = meet(interval.line.back(), 1);
    foldEnds.start = meet(interval.line.front(), -1);
    if (foldEnds.start != foldEnds.end) {
        const Correspondence& f = foldEnds.end ? interval.line.back() : interval.line.front();
        double apart = outline.wrap(f.b - f.a);
        apart = apart > 0.5 * outline.length() ? apart - outline.length() : apart;
        const double tip = outline.wrap(f.a + 0.5 * apart);
        const int k = outline.edgeAt(tip);
        const bool first = tip - outline.arcOf(k) < outline.arcOf(k + 1) - tip;
        const bool atVertex =
            std::abs(outline.nearestVertex(tip) - tip) < 0.25 * outline.spacingAt(tip);
        foldEnds.angle =
            atVertex ? outline.angle[first ? k : outline.wrapIndex(k + 1)] : std::numbers::pi;
    }
    return foldEnds;
}

namespace {

// A larger inner angle is the tip of a dart, inside the cloth. A pleat folds on a plain edge, with
// an angle near pi.
constexpr double kDartAngle = 1.5 * std::numbers::pi;

/// Follows contacts along both outlines.
class Chainer {
public:
    Chainer(const Outlines& outlines, const std::vector<Contact>& contacts)
        : outlines_(outlines), contacts_(contacts), seen_(contacts.size(), 0) {}

    std::vector<MatchedInterval> intervals() {
        std::vector<MatchedInterval> found;
        for (std::size_t c = 0; c < contacts_.size(); ++c) {
            if (!seen_[c]) {
                MatchedInterval interval = walkFrom(static_cast<int>(c));
                if (interval.line.size() > 1) {
                    found.push_back(std::move(interval));
                }
            }
        }
        return found;
    }

private:
    /// A contact on the walk, seen from side a or `swapped`; edge numbers continue past either end.
    struct Step {
        int contact;
        int i, j;
        bool swapped;
    };

    MatchedInterval walkFrom(int first) {
        const Contact& c = contacts_[first];
        MatchedInterval interval;
        interval.outlineA = outlines_.outlineOf[c.a];
        interval.outlineB = outlines_.outlineOf[c.b];
        interval.parallel = c.parallel;
        interval.certain = true;
        std::vector<Step> todo{{first, outlines_.local(c.a), outlines_.local(c.b), false}};
        seen_[first] = 1;
        while (!todo.empty()) {
            const Step step = todo.back();
            todo.pop_back();
            interval.certain = interval.certain && contacts_[step.contact].certain;
            addCorrespondence(interval, step);
            pushNeighbours(interval, step, todo);
        }
        straighten(interval);
        const FoldEnds foldEnds = foldEndsOf(interval, outlines_);
        interval.folded =
            foldEnds.start != foldEnds.end && foldEnds.angle < kDartAngle && !interval.certain;
        return interval;
    }

    void addCorrespondence(MatchedInterval& interval, const Step& step) const {
        const Contact& c = contacts_[step.contact];
        const double a = outlines_.list[interval.outlineA].arcOf(step.i);
        const double b = outlines_.list[interval.outlineB].arcOf(step.j);
        interval.line.push_back(
            {a + (step.swapped ? c.b0 : c.a0), b + (step.swapped ? c.a0 : c.b0), c.gap0});
        interval.line.push_back(
            {a + (step.swapped ? c.b1 : c.a1), b + (step.swapped ? c.a1 : c.b1), c.gap1});
    }

    void pushNeighbours(const MatchedInterval& interval, const Step& step,
                        std::vector<Step>& todo) {
        const int along = interval.parallel ? 1 : -1;
        const std::array<std::array<int, 2>, 6> moves{
            {{1, 0}, {0, along}, {1, along}, {-1, 0}, {0, -along}, {-1, -along}}};
        for (const auto& [di, dj] : moves) {
            const int i = step.i + di, j = step.j + dj;
            const int a = outlines_.firstEdge[interval.outlineA] +
                          outlines_.list[interval.outlineA].wrapIndex(i);
            const int b = outlines_.firstEdge[interval.outlineB] +
                          outlines_.list[interval.outlineB].wrapIndex(j);
            const int next = find(std::min(a, b), std::max(a, b));
            if (next >= 0 && !seen_[next] && contacts_[next].parallel == interval.parallel) {
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

    /// Sorts the facing places along the seam and removes those that run backwards: contacts
    /// overlap a little at corners of differently sampled outlines.
    void straighten(MatchedInterval& interval) const {
        const double sign = interval.parallel ? 1 : -1;
        std::vector<Correspondence>& line = interval.line;
        std::ranges::sort(
            line, {}, [sign](const Correspondence& f) { return std::pair(f.a + sign * f.b, f.a); });
        for (std::size_t k = 1; k < line.size(); ++k) {
            line[k].a = std::max(line[k].a, line[k - 1].a);
            line[k].b = sign * std::max(sign * line[k].b, sign * line[k - 1].b);
        }
        const double tiny = 1e-9 * outlines_.list[interval.outlineA].spacingAt(line.front().a);
        line.erase(std::unique(line.begin(), line.end(),
                               [tiny](const Correspondence& p, const Correspondence& q) {
                                   return std::abs(q.a - p.a) <= tiny &&
                                          std::abs(q.b - p.b) <= tiny;
                               }),
                   line.end());
        // A closed seam may overlap itself by rounding or at a corner: limit it to one turn.
        const bool self = interval.outlineA == interval.outlineB;
        const double used = interval.length() + (self ? interval.lengthB() : 0.0);
        const double there = outlines_.list[interval.outlineA].length();
        if (used > there) {
            const double from = line.front().a;
            interval = interval.part({from, from + interval.length() * there / used});
        }
    }

    const Outlines& outlines_;
    const std::vector<Contact>& contacts_;
    std::vector<char> seen_;
};

}  // namespace

std::vector<MatchedInterval> chainContacts(const Outlines& outlines,
                                           const std::vector<Contact>& contacts) {
    return Chainer(outlines, contacts).intervals();
}

}  // namespace toile::seam
