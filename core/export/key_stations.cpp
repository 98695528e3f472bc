// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/export/key_stations.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <queue>
#include <utility>

#include "core/geometry/segment.h"

namespace toile {
namespace {

/// Places nearer to each other than this coincide, mm.
constexpr double kSamePlace = 1e-6;

/// The error of a chord between two stations, mm.
struct ChordCost {
    double lost = 0;                ///< length
    double far = 0;                 ///< largest distance of a vertex from the chord
    std::optional<double> split{};  ///< place of the vertex nearest to the middle
};

ChordCost chordCost(const geometry::Line& line, double from, double to) {
    const Eigen::RowVector2d a = line.pointAt(from), b = line.pointAt(to);
    ChordCost cost;
    cost.lost = std::max(0.0, (to - from) - (b - a).norm());
    const double middle = 0.5 * (from + to);
    const int end = line.firstAfter(to - kSamePlace);
    for (int k = line.firstAfter(from + kSamePlace); k < end; ++k) {
        const double at = line.placeOf(k);
        const Eigen::RowVector2d point = line.point(k);
        cost.far =
            std::max(cost.far, (a + geometry::nearestShare(point, a, b) * (b - a) - point).norm());
        if (!cost.split || std::abs(at - middle) < std::abs(*cost.split - middle)) {
            cost.split = at;
        }
    }
    return cost.split ? cost : ChordCost{};
}

/// The part between two neighbouring stations, on both sides.
struct Part {
    double from = 0, to = 1;  ///< shares
    ChordCost costs[2] = {};

    double lost() const { return std::max(costs[0].lost, costs[1].lost); }
    double far() const { return std::max(costs[0].far, costs[1].far); }
    bool operator<(const Part& other) const {
        // Parts too far from their line come first.
        const bool isFar = far() > kKeyFar, otherIsFar = other.far() > kKeyFar;
        return isFar != otherIsFar      ? otherIsFar
               : lost() != other.lost() ? lost() < other.lost()
                                        : from < other.from;
    }
};

class Stations {
public:
    explicit Stations(std::span<const KeyStretch> sides) : sides_(sides) {}

    void add(double from, double to) {
        const Part part = measured(from, to);
        for (std::size_t s = 0; s < sides_.size(); ++s) {
            lost_[s] += part.costs[s].lost;
        }
        parts_.push(part);
    }

    /// Halves parts until both sides are within the tolerances.
    void refine() {
        while (!parts_.empty() &&
               (std::max(lost_[0], lost_[1]) > kKeyLost || parts_.top().far() > kKeyFar)) {
            const Part part = parts_.top();
            const std::size_t side = worseSide(part);
            const KeyStretch& stretch = sides_[side];
            if (!part.costs[side].split) {
                return;  // no further gain
            }
            parts_.pop();
            for (std::size_t s = 0; s < sides_.size(); ++s) {
                lost_[s] -= part.costs[s].lost;
            }
            const double share =
                (*part.costs[side].split - stretch.from) / (stretch.to - stretch.from);
            const double middle = stretch.reversed ? 1 - share : share;
            add(part.from, middle);
            add(middle, part.to);
        }
    }

    std::vector<double> starts() {
        std::vector<double> shares;
        shares.reserve(parts_.size() + 1);
        for (; !parts_.empty(); parts_.pop()) {
            shares.push_back(parts_.top().from);
        }
        std::ranges::sort(shares);
        return shares;
    }

    /// Removes stations that length and shape do not need, except the fixed ones.
    std::vector<double> thinned(std::vector<double> shares, const std::vector<double>& fixed) {
        std::vector<std::size_t> before(shares.size()), after(shares.size()), order;
        std::vector<double> saved(shares.size());
        for (std::size_t k = 0; k < shares.size(); ++k) {
            before[k] = k - 1;
            after[k] = k + 1;
            if (k > 0 && k + 1 < shares.size() && !std::ranges::binary_search(fixed, shares[k])) {
                saved[k] = measured(shares[k - 1], shares[k + 1]).lost();
                order.push_back(k);
            }
        }
        std::ranges::stable_sort(order, {}, [&](std::size_t k) { return saved[k]; });
        std::vector<bool> isGone(shares.size());
        for (const std::size_t k : order) {
            if (isSpared(shares[before[k]], shares[k], shares[after[k]])) {
                isGone[k] = true;
                after[before[k]] = after[k];
                before[after[k]] = before[k];
            }
        }
        std::vector<double> kept;
        for (std::size_t k = 0; k < shares.size(); ++k) {
            if (!isGone[k]) {
                kept.push_back(shares[k]);
            }
        }
        return kept;
    }

private:
    Part measured(double from, double to) const {
        Part part{from, to};
        for (std::size_t s = 0; s < sides_.size(); ++s) {
            const double a = sides_[s].at(from), b = sides_[s].at(to);
            part.costs[s] = chordCost(*sides_[s].line, std::min(a, b), std::max(a, b));
        }
        return part;
    }

    std::size_t worseSide(const Part& part) const {
        const auto isWorse = [&](double a, double b) -> bool { return b > a; };
        const bool second = part.far() > kKeyFar ? isWorse(part.costs[0].far, part.costs[1].far)
                                                 : isWorse(part.costs[0].lost, part.costs[1].lost);
        return second ? 1 : 0;
    }

    bool isSpared(double from, double at, double to) {
        const Part whole = measured(from, to), first = measured(from, at),
                   second = measured(at, to);
        if (whole.far() > kKeyFar) {
            return false;
        }
        double more[2] = {0, 0};
        for (std::size_t s = 0; s < sides_.size(); ++s) {
            more[s] = whole.costs[s].lost - first.costs[s].lost - second.costs[s].lost;
            if (lost_[s] + more[s] > kKeyLost) {
                return false;
            }
        }
        lost_[0] += more[0];
        lost_[1] += more[1];
        return true;
    }

    std::span<const KeyStretch> sides_;
    std::priority_queue<Part> parts_;
    double lost_[2] = {0, 0};  ///< mm, of each side
};

}  // namespace

std::vector<double> keyShares(std::span<const KeyStretch> sides, std::vector<double> fixed) {
    double shortest = sides.front().to - sides.front().from;
    for (const KeyStretch& side : sides) {
        shortest = std::min(shortest, side.to - side.from);
    }
    if (!(shortest > kSamePlace)) {
        return {0, 1};
    }
    const double same = kSamePlace / shortest;
    fixed.insert(fixed.end(), {0.0, 1.0});
    std::erase_if(fixed, [&](double share) {
        return !(share >= 0 && share <= 1) || (share > 0 && share < same) ||
               (share < 1 && share > 1 - same);
    });
    std::ranges::sort(fixed);
    fixed.erase(
        std::unique(fixed.begin(), fixed.end(), [&](double a, double b) { return b - a < same; }),
        fixed.end());
    Stations stations(sides);
    for (std::size_t k = 0; k + 1 < fixed.size(); ++k) {
        stations.add(fixed[k], fixed[k + 1]);
    }
    stations.refine();
    std::vector<double> shares = stations.starts();
    shares.push_back(1);
    return stations.thinned(std::move(shares), fixed);
}

}  // namespace toile
