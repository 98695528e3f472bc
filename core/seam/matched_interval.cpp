// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/seam/matched_interval.h"

#include <algorithm>
#include <array>
#include <numbers>
#include <tuple>

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
