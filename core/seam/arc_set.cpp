// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/seam/arc_set.h"

#include <algorithm>
#include <cmath>

namespace toile {

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
    for (double turn = std::floor(arc.from / length_) * length_; turn < arc.to; turn += length_) {
        auto next = std::lower_bound(taken_.begin(), taken_.end(), at - turn,
                                     [](const Arc& a, double s) { return a.to < s; });
        for (; next != taken_.end() && turn + next->from < arc.to; ++next) {
            if (turn + next->from > at) {
                parts.push_back({at, turn + next->from});
            }
            at = std::max(at, turn + next->to);
        }
    }
    if (at < arc.to) {
        parts.push_back({at, arc.to});
    }
    return parts;
}

}  // namespace toile
