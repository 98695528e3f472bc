// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/pattern/corners.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <set>

#include "core/geometry/segment.h"

namespace toile {

double chordTurn(const geometry::Line& line, double at, double before, double after) {
    const Eigen::RowVector2d here = line.pointAt(at);
    return geometry::turnBetween(here - line.pointAt(at - before), line.pointAt(at + after) - here);
}

std::vector<int> findCorners(const Points2& points, const TurnLimit& limit) {
    const auto line = geometry::Line::closed(points);
    const int n = line.count();
    const double window = std::min(limit.chord, line.length() / 4);
    std::vector<double> own(n), chord(n);
    for (int k = 0; k < n; ++k) {
        own[k] = std::abs(line.turnAt(k));
        chord[k] = std::abs(chordTurn(line, line.arc()[k], window, window));
    }
    std::vector<int> strongest;
    for (int k = 0; k < n; ++k) {
        if (chord[k] > limit.turn) {
            strongest.push_back(k);
        }
    }
    std::ranges::stable_sort(strongest, std::greater<>(), [&own](int k) { return own[k]; });
    std::set<int> corners;
    for (const int k : strongest) {
        // Near a known corner the chords end at it, so that its turn is not counted twice.
        double before = window, after = window;
        if (!corners.empty()) {
            const auto next = corners.lower_bound(k);
            const int behind = next == corners.end() ? *corners.begin() : *next;
            const int ahead = next == corners.begin() ? *corners.rbegin() : *std::prev(next);
            before = std::min(before, line.wrap(line.arc()[k] - line.arc()[ahead]));
            after = std::min(after, line.wrap(line.arc()[behind] - line.arc()[k]));
        }
        const bool isAlone = before == window && after == window;
        const bool isSecond = own[k] > limit.turn && std::min(before, after) > kOneCorner &&
                              std::abs(chordTurn(line, line.arc()[k], before, after)) > limit.turn;
        if (isAlone || isSecond) {
            corners.insert(k);
        }
    }
    return {corners.begin(), corners.end()};
}

}  // namespace toile
