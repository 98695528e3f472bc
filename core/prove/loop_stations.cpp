// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/prove/loop_stations.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace toile::prove {
namespace {

/// Of the edge: where two points are farther apart there is room for another.
constexpr double kRoom = 1.6;

}  // namespace

double LoopStations::apart(double a, double b) const {
    const double way = std::fmod(std::abs(a - b), loop_.length());
    return std::min(way, loop_.length() - way);
}

int LoopStations::at(double place) {
    const auto far = [&](double other) { return apart(other, place); };
    const auto nearest = std::ranges::min_element(places_, {}, far);
    if (nearest != places_.end() && far(*nearest) < kOnePoint * edge_) {
        return static_cast<int>(nearest - places_.begin());
    }
    places_.push_back(place - std::floor(place / loop_.length()) * loop_.length());
    return static_cast<int>(places_.size()) - 1;
}

void LoopStations::cover(const SeamSide& side) {
    const auto [low, high] = std::minmax(side.start, side.end);
    covered_.push_back({low, high});
}

bool LoopStations::isCovered(double place) const {
    const double turn = loop_.length();
    return std::ranges::any_of(covered_, [&](const Range& range) {
        const double at = place + (std::floor((range.low - place) / turn) + 1) * turn;
        return at < range.high;
    });
}

std::vector<double> LoopStations::within(const std::vector<double>& places,
                                         const SeamSide& side) const {
    const double turn = loop_.length();
    const auto [low, high] = std::minmax(side.start, side.end);
    std::vector<double> inside;
    for (const double place : places) {
        double at = place + std::ceil((low - place) / turn) * turn;
        while (at < high) {
            if (at > low + kOnePoint * edge_ && at < high - kOnePoint * edge_) {
                inside.push_back(at);
            }
            at += turn;
        }
    }
    return inside;
}

std::vector<double> LoopStations::neededWithin(const SeamSide& side) const {
    std::vector<double> needed = within(places_, side);
    for (const auto& more : {within(loop_.corners(), side), within(ends_, side)}) {
        needed.insert(needed.end(), more.begin(), more.end());
    }
    return needed;
}

std::vector<double> LoopStations::verticesWithin(const SeamSide& side) const {
    return within(loop_.vertices(), side);
}

void LoopStations::fill(bool atVertices) {
    for (const std::vector<double>* needed : {&std::as_const(ends_), &loop_.corners()}) {
        for (const double place : *needed) {
            if (!isCovered(place)) {
                at(place);
            }
        }
    }
    for (const double vertex : loop_.vertices()) {
        if (atVertices && !isCovered(vertex) && std::ranges::none_of(places_, [&](double place) {
                return apart(place, vertex) < kCrowded * edge_;
            })) {
            at(vertex);
        }
    }
    if (places_.empty()) {
        places_.push_back(0);
    }
    std::vector<double> sorted = places_;
    std::ranges::sort(sorted);
    const std::size_t least = sorted.size() < 3 ? 3 : 1;  // in each gap
    for (std::size_t k = 0; k < sorted.size(); ++k) {
        const double a = sorted[k];
        const double b = k + 1 < sorted.size() ? sorted[k + 1] : sorted[0] + loop_.length();
        const double length = loop_.restLength(a, b);
        auto parts = static_cast<std::size_t>(std::max(1L, std::lround(length / edge_)));
        const bool isWhole = length < kRoom * edge_ || isCovered((a + b) / 2);
        parts = isWhole ? least : std::max(parts, least);
        for (std::size_t i = 1; i < parts; ++i) {
            const double place = a + (b - a) * static_cast<double>(i) / static_cast<double>(parts);
            places_.push_back(place < loop_.length() ? place : place - loop_.length());
        }
    }
}

std::vector<int> LoopStations::putInOrder() {
    std::vector<int> order, number(places_.size());
    for (int k = 0; k < static_cast<int>(places_.size()); ++k) {
        order.push_back(k);
    }
    std::ranges::stable_sort(order, {}, [&](int k) { return places_[k]; });
    std::vector<double> sorted;
    for (std::size_t k = 0; k < order.size(); ++k) {
        number[order[k]] = static_cast<int>(k);
        sorted.push_back(places_[order[k]]);
    }
    places_ = std::move(sorted);
    return number;
}

}  // namespace toile::prove
