// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

namespace toile {

/// A stretch of a closed line from `from` to `to` >= from, counted on past the line's length.
struct Arc {
    double from = 0, to = 0;
};

/// A set of places on a closed line, kept as disjoint stretches.
class ArcSet {
public:
    explicit ArcSet(double length) : length_(length) {}

    void add(Arc arc);
    /// The parts of `arc` that are not in the set, in order, counted like `arc`.
    std::vector<Arc> outside(Arc arc) const;

private:
    void insert(Arc arc);

    double length_;
    std::vector<Arc> taken_;  ///< in [0, length], sorted, disjoint
};

}  // namespace toile
