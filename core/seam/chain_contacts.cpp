// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "core/seam/run.h"

namespace toile {
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
        if (step.swapped) {
            run.line.push_back({a + c.b0, b + c.a0, c.gap0});
            run.line.push_back({a + c.b1, b + c.a1, c.gap1});
        } else {
            run.line.push_back({a + c.a0, b + c.b0, c.gap0});
            run.line.push_back({a + c.a1, b + c.b1, c.gap1});
        }
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
        const auto at = std::lower_bound(contacts_.begin(), contacts_.end(), std::pair(a, b),
                                         [](const Contact& c, const std::pair<int, int>& key) {
                                             return std::pair(c.a, c.b) < key;
                                         });
        const bool hit = at != contacts_.end() && at->a == a && at->b == b;
        return hit ? static_cast<int>(at - contacts_.begin()) : -1;
    }

    /// Puts the facing places in order along the seam and takes out what runs back: at corners of
    /// differently sampled outlines neighbouring contacts overlap a little.
    void straighten(Run& run) const {
        const double sign = run.parallel ? 1 : -1;
        std::vector<Facing>& line = run.line;
        std::sort(line.begin(), line.end(), [sign](const Facing& p, const Facing& q) {
            const double sp = p.a + sign * p.b, sq = q.a + sign * q.b;
            return sp != sq ? sp < sq : p.a < q.a;
        });
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
