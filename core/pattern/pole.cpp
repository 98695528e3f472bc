// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/pattern/pole.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <span>
#include <utility>

#include "core/geometry/buckets.h"
#include "core/geometry/polygon.h"
#include "core/geometry/segment.h"

namespace toile {
namespace {

using Eigen::Vector2d;

constexpr int kMaxSquares = 20000;
constexpr std::size_t kMaxLooks = 300000, kMaxLooksPerEdge = 60;  // limit of distance tests

/// A segment of a line, in coordinates in which the shape at room 1 is the unit circle, or the
/// square of half side 1.
struct PoleEdge {
    Vector2d a, b;
    int ring;
};
constexpr int kOpenLine = -1;
constexpr int kClothRing = 0;  // number of all loops; closed obstacles have their own from 1 on

/// Distance of a segment from the origin in the maximum norm: at an end, or where it crosses a
/// diagonal.
double squareDistance(const Vector2d& a, const Vector2d& b) {
    double least = std::min(a.cwiseAbs().maxCoeff(), b.cwiseAbs().maxCoeff());
    for (const double sign : {-1.0, 1.0}) {
        const double from = a.x() + sign * a.y(), to = b.x() + sign * b.y();
        if ((from < 0) != (to < 0)) {
            least = std::min(least, (a + from / (from - to) * (b - a)).cwiseAbs().maxCoeff());
        }
    }
    return least;
}

/// The lines around the free cloth.
class PoleLines {
public:
    PoleLines(const FreeCloth& cloth, const Eigen::Matrix2d& toUnit, bool isRound)
        : isRound_(isRound) {
        std::size_t count = 0;
        for (const auto* lines : {&cloth.loops, &cloth.obstacles}) {
            for (const Points2& line : *lines) {
                count += static_cast<std::size_t>(line.rows());
            }
        }
        edges_.reserve(count);
        for (const Points2& loop : cloth.loops) {
            add(loop, toUnit, kClothRing);
            if (loop.rows() > 0) {
                edges_.push_back({toUnit * loop.bottomRows<1>().transpose(),
                                  toUnit * loop.topRows<1>().transpose(), kClothRing});
            }
        }
        int ring = kClothRing;
        for (const Points2& line : cloth.obstacles) {
            const bool isClosed = line.rows() > 3 && line.row(0) == line.row(line.rows() - 1);
            add(line, toUnit, isClosed ? ++ring : kOpenLine);
        }
        fillBands();
    }

    int count() const { return static_cast<int>(edges_.size()); }

    double distance(int edge, const Vector2d& point) const {
        const Vector2d a = edges_[edge].a - point, b = edges_[edge].b - point;
        return isRound_ ? geometry::distanceToSegment<Vector2d>(Vector2d::Zero(), a, b)
                        : squareDistance(a, b);
    }

    /// Distance of the corners of a square from its middle.
    double reach(double half) const { return isRound_ ? std::numbers::sqrt2 * half : half; }

    /// Number of edges tested to find out whether a point is free.
    std::size_t edgesBeside(const Vector2d& point) const { return bandOf(point).size(); }

    /// On the cloth and in no closed obstacle, by counting lines to the right, ring by ring.
    bool isFree(const Vector2d& point) const {
        bool isInside = false;
        int ring = kClothRing;
        for (const int index : bandOf(point)) {
            const PoleEdge& edge = edges_[index];
            if (edge.ring != ring) {
                if (isInside != (ring == kClothRing)) {
                    return false;
                }
                isInside = false;
                ring = edge.ring;
            }
            const Vector2d a = edge.a - point, b = edge.b - point;
            if ((a.y() > 0) != (b.y() > 0) &&
                a.x() - a.y() / (b.y() - a.y()) * (b.x() - a.x()) > 0) {
                isInside = !isInside;
            }
        }
        return isInside == (ring == kClothRing);
    }

private:
    std::span<const int> bandOf(const Vector2d& point) const {
        const double band = (point.y() - low_) * bandsPerUnit_;
        const bool isAny = band >= 0 && band < bands_.keyCount();
        return isAny ? bands_[static_cast<int>(band)] : std::span<const int>();
    }

    void add(const Points2& line, const Eigen::Matrix2d& toUnit, int ring) {
        for (Eigen::Index i = 1; i < line.rows(); ++i) {
            edges_.push_back(
                {toUnit * line.row(i - 1).transpose(), toUnit * line.row(i).transpose(), ring});
        }
    }

    /// Horizontal bands, so many that each edge is in two of them on average.
    void fillBands() {
        double low = std::numeric_limits<double>::infinity(), high = -low, rise = 0;
        for (const PoleEdge& edge : edges_) {
            if (edge.ring == kClothRing) {
                low = std::min(low, edge.a.y());
                high = std::max(high, edge.a.y());
            }
            rise += std::abs(edge.b.y() - edge.a.y());
        }
        if (!(high > low && std::isfinite(rise))) {
            return;
        }
        const int bandCount = 1 + static_cast<int>(count() * ((high - low) / (rise + high - low)));
        low_ = low;
        bandsPerUnit_ = bandCount / (high - low) * (1 - 1e-12);  // puts the highest in the last
        const auto bandAt = [&](double y) {
            return static_cast<int>(std::clamp((y - low_) * bandsPerUnit_, 0.0, bandCount - 1.0));
        };
        bands_ = geometry::Buckets<int>(bandCount, [&](auto&& put) {
            for (int i = 0; i < count(); ++i) {
                if (edges_[i].ring == kOpenLine) {
                    continue;
                }
                const auto [from, to] = std::minmax({edges_[i].a.y(), edges_[i].b.y()});
                if (to >= low && from <= high) {
                    for (int band = bandAt(from); band <= bandAt(to); ++band) {
                        put(band, i);
                    }
                }
            }
        });
    }

    bool isRound_;
    std::vector<PoleEdge> edges_;
    geometry::Buckets<int> bands_;  ///< edges of rings by band, ring by ring
    double low_ = 0, bandsPerUnit_ = 0;
};

/// A square of the plane.
struct PoleSquare {
    Vector2d middle;
    double half = 0;
    double room = 0;          ///< at the middle; off the free cloth minus the distance from a line
    double rank = 0;          ///< squares of the highest rank are searched first
    int order = 0;            ///< of equal ranks the first made
    std::vector<int> near{};  ///< lines that may be nearest to a point of it
};

/// Subdivides squares, starting with one around all of the cloth.
class PoleSquares {
public:
    PoleSquares(const PoleLines& lines, const Eigen::AlignedBox2d& box) : lines_(lines), box_(box) {
        all_.resize(lines.count());
        std::iota(all_.begin(), all_.end(), 0);
    }

    double reach(const PoleSquare& square) const { return lines_.reach(square.half); }

    /// The room around a point.
    double roomAt(const Vector2d& point) { return made(point, 0, all_).room; }

    /// @param rank  of a square, and records the room at its middle; nothing if neither it nor
    ///              squares of lower rank can contain anything better
    template <class Rank>
    void search(const Rank& rank) {
        std::vector<PoleSquare> open;
        const auto isLater = [](const PoleSquare& a, const PoleSquare& b) {
            return a.rank != b.rank ? a.rank < b.rank : a.order > b.order;
        };
        int made = 0;
        looks_ = 0;
        const std::size_t most = kMaxLooks + kMaxLooksPerEdge * all_.size();
        const auto offer = [&](PoleSquare square) {
            if (const std::optional<double> found = rank(square)) {
                square.rank = *found;
                square.order = made++;
                open.push_back(std::move(square));
                std::ranges::push_heap(open, isLater);
            }
        };
        offer(this->made(box_.center(), 0.5 * box_.sizes().maxCoeff(), all_));
        while (!open.empty() && made < kMaxSquares && looks_ < most) {
            std::ranges::pop_heap(open, isLater);
            const PoleSquare whole = std::move(open.back());
            open.pop_back();
            if (!rank(whole)) {
                return;
            }
            const double half = 0.5 * whole.half;
            for (const double x : {-half, half}) {
                for (const double y : {-half, half}) {
                    offer(this->made(whole.middle + Vector2d(x, y), half, whole.near));
                }
            }
        }
    }

private:
    PoleSquare made(const Vector2d& middle, double half, const std::vector<int>& near) {
        PoleSquare square{middle, half};
        double distance = std::numeric_limits<double>::infinity();
        distances_.resize(near.size());
        looks_ += near.size() + lines_.edgesBeside(middle);
        for (std::size_t i = 0; i < near.size(); ++i) {
            distances_[i] = lines_.distance(near[i], middle);
            distance = std::min(distance, distances_[i]);
        }
        square.room = lines_.isFree(middle) ? distance : -distance;
        const double reach = lines_.reach(half);
        if (square.room + reach > 0) {
            for (std::size_t i = 0; i < near.size(); ++i) {
                if (distances_[i] <= distance + 2 * reach) {
                    square.near.push_back(near[i]);
                }
            }
        }
        return square;
    }

    const PoleLines& lines_;
    Eigen::AlignedBox2d box_;
    std::vector<int> all_;
    std::vector<double> distances_;  ///< working memory
    std::size_t looks_ = 0;
};

/// Centroid of the area in a line; the middle of the box if the area is 0.
Vector2d centroid(const Points2& loop, const Eigen::AlignedBox2d& box) {
    Vector2d sum(0, 0);
    double area = 0;
    for (Eigen::Index i = 0; i < loop.rows(); ++i) {
        const Vector2d a = loop.row(i).transpose() - box.center();
        const Vector2d b = loop.row(i + 1 < loop.rows() ? i + 1 : 0).transpose() - box.center();
        const double part = geometry::cross(a, b);
        area += part;
        sum += part / 3 * (a + b);
    }
    const Vector2d middle = box.center() + sum / area;
    return area != 0 && box.contains(middle) ? middle : box.center();
}

/// @param needed  ignore places with less room
std::optional<Pole> findPole(const FreeCloth& cloth, const Eigen::Matrix2d& toUnit, bool isRound,
                             const PoleSearch& search, double needed = 0) {
    if (cloth.loops.empty() || cloth.loops.front().rows() < 3 || !cloth.loops.front().allFinite() ||
        !toUnit.allFinite()) {
        return std::nullopt;
    }
    const Eigen::Matrix2d toCloth = toUnit.inverse();
    const PoleLines lines(cloth, toUnit, isRound);
    PoleSquares squares(lines, geometry::boxAround(cloth.loops.front() * toUnit.transpose()));
    const Vector2d centre = centroid(cloth.loops.front(), geometry::boxAround(cloth.loops.front()));
    // The centroid first: of equal places it is the best.
    Pole best{centre, squares.roomAt(toUnit * centre)};
    const double atCentre = best.room;
    squares.search([&](const PoleSquare& square) -> std::optional<double> {
        if (square.room > best.room) {
            best = {toCloth * square.middle, square.room};
        }
        const double most = square.room + squares.reach(square);
        const bool isBetter = most > std::max(best.room, 0.0) * (1 + search.tolerance);
        const bool mayDo = isBetter && most >= needed && best.room < search.enough;
        return mayDo ? std::optional(most) : std::nullopt;
    });
    if (!(best.room > 0 && best.room >= needed)) {
        return std::nullopt;
    }
    const double least = std::max(needed, std::min(search.enough, (1 - search.slack) * best.room));
    if (atCentre >= least) {
        return Pole{centre, atCentre};
    }
    if (best.room < search.useful) {
        return best;
    }
    double off = (best.place - centre).norm();
    const double nearEnough =
        search.nearEnough * geometry::boxAround(cloth.loops.front()).diagonal().norm();
    const Vector2d unitCentre = toUnit * centre;
    if (least < best.room) {
        squares.search([&](const PoleSquare& square) -> std::optional<double> {
            const Vector2d place = toCloth * square.middle;
            if (const double away = (place - centre).norm(); square.room >= least && away < off) {
                off = away;
                best = {place, square.room};
            }
            const Vector2d way = unitCentre - square.middle;
            const Vector2d nearest =
                square.middle + way.cwiseMax(-square.half).cwiseMin(square.half);
            const double away = (toCloth * nearest - centre).norm();
            const bool mayHold = square.room + squares.reach(square) >= least;
            return mayHold && away < off - nearEnough ? std::optional(-away) : std::nullopt;
        });
    }
    return best;
}

Eigen::Matrix2d toUnitBox(const Eigen::Vector2d& size, double angle) {
    const Eigen::Vector2d perUnit = 2 * size.cwiseInverse();
    return perUnit.asDiagonal() * Eigen::Rotation2Dd(-angle).toRotationMatrix();
}

}  // namespace

PoleSearch coarserIfSmall(PoleSearch search, const FreeCloth& cloth) {
    constexpr double kSmallCloth = 200;  // mm
    constexpr double kCoarsest = 0.1, kNearInSmall = 2e-3;
    if (cloth.loops.empty() || cloth.loops.front().rows() == 0) {
        return search;
    }
    const double extent = geometry::boxAround(cloth.loops.front()).diagonal().norm();
    if (extent < kSmallCloth) {
        search.tolerance = std::min(kCoarsest, search.tolerance * kSmallCloth / extent);
        search.nearEnough = kNearInSmall;
    }
    return search;
}

std::optional<Pole> circlePole(const FreeCloth& cloth, const PoleSearch& search) {
    return findPole(cloth, Eigen::Matrix2d::Identity(), true, search);
}

std::optional<Pole> boxPole(const FreeCloth& cloth, const Eigen::Vector2d& size, double angle,
                            const PoleSearch& search) {
    return findPole(cloth, toUnitBox(size, angle), false, search);
}

std::optional<Pole> boxPlace(const FreeCloth& cloth, const Eigen::Vector2d& size, double angle,
                             const PoleSearch& search) {
    return findPole(cloth, toUnitBox(size, angle), false, search, 1);
}

}  // namespace toile
