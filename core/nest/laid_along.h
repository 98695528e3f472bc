// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <vector>

#include "core/nest/shape.h"

// For the sources of this folder only.
namespace toile::nest {

struct Laid {
    const Shape* shape;
    double x, y;
    double left() const { return x + shape->box.left; }
    double right() const { return x + shape->box.right; }
};

/// What lies somewhere along the strip, by where it begins.
class LaidAlong {
public:
    explicit LaidAlong(double cell) : cell_(cell) {}

    void add(const Laid& laid) {
        const std::size_t at = cellOf(laid.left());
        cells_.resize(std::max(cells_.size(), at + 1));
        cells_[at].push_back(laid);
        widest_ = std::max(widest_, laid.right() - laid.left());
        end_ = std::max(end_, laid.right());
    }
    double end() const { return end_; }
    /// Each that reaches into this, in some order.
    template <typename Does>
    void forEach(double left, double right, Does does) const {
        const std::size_t last = std::min(cellOf(right) + 1, cells_.size());
        for (std::size_t at = cellOf(left - widest_); at < last; ++at) {
            for (const Laid& laid : cells_[at]) {
                if (laid.right() > left && laid.left() < right) {
                    does(laid);
                }
            }
        }
    }

private:
    std::size_t cellOf(double x) const {
        return static_cast<std::size_t>(std::clamp(x / cell_, 0.0, kMostCells));
    }

    static constexpr double kMostCells = 1e5;
    double cell_, widest_ = 0, end_ = 0;
    std::vector<std::vector<Laid>> cells_;
};

}  // namespace toile::nest
