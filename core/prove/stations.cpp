// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/prove/stations.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/seam/seam_measure.h"

namespace toile::prove {
namespace {

/// The points along one loop during placement. Points are numbered in order of creation until
/// `putInOrder`.
class LoopStations {
public:
    /// Points closer than this, in edge lengths, are merged.
    static constexpr double kOnePoint = 0.2;
    /// Vertices closer to a point than this, in edge lengths, do not become points.
    static constexpr double kCrowded = 0.5;

    /// @param edge  approximate distance between points, mm  Keeps a reference to the loop
    LoopStations(const RestLoop& loop, double edge) : loop_(loop), edge_(edge) {}

    const RestLoop& loop() const { return loop_; }
    const std::vector<double>& places() const { return places_; }

    /// Records the end of a seam's side.
    void addEnd(double place) { ends_.push_back(place); }
    /// The number of the point at a place, existing or new.
    int at(double place);
    /// Marks a side whose points are all sewn: no further points are added to it.
    void cover(const SeamSide& side);
    /// Whether a place is strictly inside a covered side.
    bool isCovered(double place) const;

    /// Places inside a side, counted like its own: points, corners and ends of other sides.
    std::vector<double> neededWithin(const SeamSide& side) const;
    /// The garment's vertices inside a side.
    std::vector<double> verticesWithin(const SeamSide& side) const;

    /// Fills the loop evenly, using corners, ends and optionally vertices; at least three points.
    void fill(bool atVertices);
    /// Sorts the places. @return per point its new number
    std::vector<int> putInOrder();

private:
    double apart(double a, double b) const { return loop_.apart(a, b); }
    std::vector<double> within(const std::vector<double>& places, const SeamSide& side) const;

    struct Range {
        double low, high;
    };

    const RestLoop& loop_;
    double edge_;
    std::vector<double> places_, ends_;
    std::vector<Range> covered_;
};

/// Gap between two points, in edge lengths, from which another point is inserted.
constexpr double kRoom = 1.6;

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

/// Corresponding places of the two sides.
struct PlacePair {
    double left, right;
};

bool isCloth(const SeamSide& side, const RestPattern& pattern) {
    if (side.piece < 0) {
        return false;
    }
    const auto& piece = pattern.pieces[static_cast<std::size_t>(side.piece)];
    return piece && piece->loops[static_cast<std::size_t>(side.loop)];
}

class StationPlacer {
public:
    StationPlacer(const SeamGraph& seams, const RestPattern& pattern, double edge, bool atVertices)
        : seams_(seams),
          pattern_(pattern),
          edge_(edge),
          atVertices_(atVertices),
          loops_(pattern.pieces.size()) {
        for (std::size_t p = 0; p < loops_.size(); ++p) {
            if (pattern.pieces[p]) {
                for (const auto& loop : pattern.pieces[p]->loops) {
                    loops_[p].emplace_back();
                    if (loop) {
                        loops_[p].back().emplace(*loop, edge);
                    }
                }
            }
        }
    }

    Stations placed() {
        for (const Seam& seam : seams_.seams) {
            for (const SeamSide* side : {&seam.left, &seam.right}) {
                if (isCloth(*side, pattern_) && !seam.closed) {
                    on(*side).addEnd(side->start);
                    on(*side).addEnd(side->end);
                }
            }
        }
        for (const bool stacked : {false, true}) {
            for (const Seam& seam : seams_.seams) {
                if (seam.stacked == stacked && isSewn(seam, pattern_)) {
                    sew(seam);
                }
            }
        }
        return numbered();
    }

private:
    LoopStations& on(const SeamSide& side) {
        return *loops_[static_cast<std::size_t>(side.piece)][static_cast<std::size_t>(side.loop)];
    }

    double restLength(const SeamSide& side, double a, double b) const {
        const RestLoop& loop = loopOf(side, pattern_);
        return loop.restLength(std::min(a, b), std::max(a, b));
    }

    /// Whether one side between two pairs is already covered by another seam's points.
    bool isTaken(const Seam& seam, const PlacePair& a, const PlacePair& b) {
        return on(seam.left).isCovered((a.left + b.left) / 2) ||
               on(seam.right).isCovered((a.right + b.right) / 2);
    }

    /// Pairs of places that both sides must have.
    std::vector<PlacePair> needed(const Seam& seam) {
        std::vector<PlacePair> pairs;
        for (const bool isRight : {false, true}) {
            const SeamSide& side = isRight ? seam.right : seam.left;
            for (const double place : on(side).neededWithin(side)) {
                const double across = placeAcross(seam, place, isRight);
                pairs.push_back(isRight ? PlacePair{across, place} : PlacePair{place, across});
            }
        }
        // Merge places that are close on either side.
        std::ranges::stable_sort(pairs, {}, &PlacePair::left);
        const auto [lowL, highL] = std::minmax(seam.left.start, seam.left.end);
        const auto [lowR, highR] = std::minmax(seam.right.start, seam.right.end);
        const double near = LoopStations::kOnePoint * edge_;
        std::vector<PlacePair> kept;
        for (const PlacePair& pair : pairs) {
            const bool isInside = pair.left > lowL + near && pair.left < highL - near &&
                                  pair.right > lowR + near && pair.right < highR - near;
            if (isInside && (kept.empty() || (pair.left - kept.back().left > near &&
                                              std::abs(pair.right - kept.back().right) > near))) {
                kept.push_back(pair);
            }
        }
        if (seam.left.reversed) {
            std::ranges::reverse(kept);
        }
        kept.insert(kept.begin(), {seam.left.start, seam.right.start});
        kept.push_back({seam.left.end, seam.right.end});
        return kept;
    }

    /// Adds the left side's vertices between them, if there is room.
    std::vector<PlacePair> withVertices(const Seam& seam, const std::vector<PlacePair>& stops) {
        std::vector<double> vertices = on(seam.left).verticesWithin(seam.left);
        std::ranges::sort(vertices);
        if (seam.left.reversed) {
            std::ranges::reverse(vertices);
        }
        const double room = LoopStations::kCrowded * edge_;
        std::vector<PlacePair> all{stops.front()};
        auto vertex = vertices.begin();
        for (std::size_t k = 1; k < stops.size(); ++k) {
            const auto isBefore = [&](double a, double b) {
                return seam.left.reversed ? a > b : a < b;
            };
            for (; vertex != vertices.end() && isBefore(*vertex, stops[k].left); ++vertex) {
                const PlacePair pair{*vertex, placeAcross(seam, *vertex, false)};
                const auto isApart = [&](const PlacePair& other) {
                    return std::abs(pair.left - other.left) > room &&
                           std::abs(pair.right - other.right) > room;
                };
                if (!isTaken(seam, stops[k - 1], stops[k]) && isApart(all.back()) &&
                    isApart(stops[k])) {
                    all.push_back(pair);
                }
            }
            all.push_back(stops[k]);
        }
        return all;
    }

    void sew(const Seam& seam) {
        std::vector<PlacePair> stops = needed(seam);
        if (atVertices_) {
            stops = withVertices(seam, stops);
        }
        link(seam, stops.front());
        for (std::size_t k = 0; k + 1 < stops.size(); ++k) {
            const PlacePair &a = stops[k], &b = stops[k + 1];
            const double length = std::max(restLength(seam.left, a.left, b.left),
                                           restLength(seam.right, a.right, b.right));
            int parts = std::max(1, static_cast<int>(std::lround(length / edge_)));
            parts = isTaken(seam, a, b) ? 1 : parts;
            parts = seam.closed && stops.size() == 2 ? std::max(parts, 3) : parts;
            // Offsets of the two pairs from exact correspondence.
            const double offA = a.right - placeAcross(seam, a.left, false);
            const double offB = b.right - placeAcross(seam, b.left, false);
            for (int i = 1; i < parts; ++i) {
                const double t = static_cast<double>(i) / parts;
                const double left = (1 - t) * a.left + t * b.left;
                link(seam, {left, placeAcross(seam, left, false) + (1 - t) * offA + t * offB});
            }
            link(seam, b);
        }
        on(seam.left).cover(seam.left);
        on(seam.right).cover(seam.right);
    }

    void link(const Seam& seam, const PlacePair& pair) {
        const int left = on(seam.left).at(pair.left), right = on(seam.right).at(pair.right);
        sewn_.push_back(
            {{seam.left.piece, seam.left.loop, left}, {seam.right.piece, seam.right.loop, right}});
    }

    /// Numbers all points in order along their loops, including free edges.
    Stations numbered() {
        Stations stations;
        std::vector<std::vector<std::vector<int>>> numbers(loops_.size());
        for (std::size_t p = 0; p < loops_.size(); ++p) {
            stations.places.emplace_back();
            for (auto& loop : loops_[p]) {
                if (loop) {
                    loop->fill(atVertices_);
                }
                numbers[p].push_back(loop ? loop->putInOrder() : std::vector<int>());
                stations.places[p].push_back(loop ? loop->places() : std::vector<double>());
            }
        }
        stations.sewn = std::move(sewn_);
        for (auto& [a, b] : stations.sewn) {
            for (Station* station : {&a, &b}) {
                station->number = numbers[static_cast<std::size_t>(station->piece)]
                                         [static_cast<std::size_t>(station->loop)][station->number];
            }
        }
        return stations;
    }

    const SeamGraph& seams_;
    const RestPattern& pattern_;
    double edge_;
    bool atVertices_;
    std::vector<std::vector<std::optional<LoopStations>>> loops_;
    std::vector<std::pair<Station, Station>> sewn_;
};

}  // namespace

const RestLoop& loopOf(const SeamSide& side, const RestPattern& pattern) {
    return *pattern.pieces[static_cast<std::size_t>(side.piece)]
                ->loops[static_cast<std::size_t>(side.loop)];
}

bool isSewn(const Seam& seam, const RestPattern& pattern) {
    return isCloth(seam.left, pattern) && isCloth(seam.right, pattern) && !seam.matches.empty();
}

Stations placeStations(const SeamGraph& seams, const RestPattern& pattern, double edge,
                       bool atVertices) {
    return StationPlacer(seams, pattern, edge, atVertices).placed();
}

}  // namespace toile::prove
