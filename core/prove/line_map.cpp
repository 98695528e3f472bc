// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/prove/line_map.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <numbers>

#include "core/geometry/placement.h"
#include "core/pattern/segments.h"

namespace toile::prove {
namespace {

using geometry::bestLikeness, geometry::CentredPlaces, geometry::likeness, geometry::squaresOf;
using ComplexPlace = std::complex<double>;

constexpr int kPlaces = 128;
constexpr double kAboutAsWell = 1.05, kAboutAsNear = 0.2;     // times, and mm
constexpr double kTurnsAlike = std::numbers::pi / 6;          // radians
constexpr double kFarthestCorner = 0.06, kAloneCorner = 0.1;  // of the perimeter
/// Corners also pair only within this multiple of the lines' distance plus this share of the
/// perimeter: of two corners in one window either may have been detected.
constexpr double kFartherThanLines = 6, kFartherCorner = 0.005;
constexpr double kMaxCornerTrials = 5e7;

/// Places at even shares of a line's length, starting at a share, relative to their mean.
CentredPlaces evenPlaces(const geometry::Line& line, double from, double scale) {
    CentredPlaces places;
    ComplexPlace middle = 0;
    for (int k = 0; k < kPlaces; ++k) {
        const Eigen::RowVector2d p =
            line.pointAt(line.arc()[0] + line.length() * (from + static_cast<double>(k) / kPlaces));
        places.emplace_back(scale * p.x(), scale * p.y());
        middle += places.back() / static_cast<double>(kPlaces);
    }
    for (ComplexPlace& place : places) {
        place -= middle;
    }
    return places;
}

struct LineCorner {
    double at;
    double turn;
    Eigen::RowVector2d place;
};

std::vector<LineCorner> cornersOf(const geometry::Line& line, const Eigen::RowVector2d& middle,
                                  double scale) {
    std::vector<LineCorner> corners;
    for (const int k : findCorners(line.points())) {
        const double at = line.arc()[k];
        const Eigen::RowVector2d here = line.points().row(k);
        const Eigen::RowVector2d in = here - line.pointAt(at - kLineCorner.chord);
        const Eigen::RowVector2d out = line.pointAt(at + kLineCorner.chord) - here;
        corners.push_back({at, std::atan2(in.x() * out.y() - in.y() * out.x(), in.dot(out)),
                           scale * (here - middle)});
    }
    return corners;
}

/// Pairs corners in order, with the file's corners counted from number `start`: minimises the sum
/// of distances, plus a fixed cost for each of our corners that stays unpaired.
class CornerPairs {
public:
    CornerPairs(const std::vector<LineCorner>& ours, const std::vector<LineCorner>& theirs,
                double perimeter, double distance)
        : n_(theirs.size()), cost_(ours.size() * theirs.size()), alone_(kAloneCorner * perimeter) {
        const double farthest = std::min(kFarthestCorner * perimeter,
                                         kFartherThanLines * distance + kFartherCorner * perimeter);
        for (std::size_t i = 0; i < ours.size(); ++i) {
            for (std::size_t j = 0; j < n_; ++j) {
                const double turn =
                    std::abs(std::remainder(ours[i].turn - theirs[j].turn, 2 * std::numbers::pi));
                const double far = (ours[i].place - theirs[j].place).norm();
                cost_[i * n_ + j] = turn < kTurnsAlike && far < farthest
                                        ? far
                                        : std::numeric_limits<double>::infinity();
            }
        }
    }

    double cost(std::size_t i, std::size_t j) const { return cost_[i * n_ + j % n_]; }

    /// @param partner  per corner of ours: the file's corner, counted on from `start`, or -1
    double from(std::size_t start, std::vector<int>& partner) const {
        const std::size_t m = partner.size();
        std::vector<double> least((m + 1) * (n_ + 1), 0);
        const auto at = [&](std::size_t i, std::size_t j) -> double& {
            return least[i * (n_ + 1) + j];
        };
        for (std::size_t i = 1; i <= m; ++i) {
            at(i, 0) = at(i - 1, 0) + alone_;
            for (std::size_t j = 1; j <= n_; ++j) {
                at(i, j) = std::min({at(i - 1, j) + alone_, at(i, j - 1),
                                     at(i - 1, j - 1) + cost(i - 1, start + j - 1)});
            }
        }
        std::ranges::fill(partner, -1);
        for (std::size_t i = m, j = n_; i > 0;) {
            if (at(i, j) == at(i - 1, j) + alone_) {
                --i;
            } else if (j > 0 && at(i, j) == at(i, j - 1)) {
                --j;
            } else {
                partner[--i] = static_cast<int>(start + --j);
            }
        }
        return at(m, n_);
    }

private:
    std::size_t n_;
    std::vector<double> cost_;
    double alone_;
};

/// Refines the offset of the fit, and its angle if it is free, below the spacing of the places.
RoughFit refined(const geometry::Line& ours, const geometry::Line& theirs, RoughFit fit,
                 bool canTurn) {
    constexpr int kThirds = 50;
    const double scale = ours.length() / theirs.length();
    const auto line = evenPlaces(ours, 0, 1);
    const auto tried = [&](double offset) {
        const auto other = evenPlaces(theirs, offset, scale);
        const double angle = canTurn ? std::arg(likeness(line, other)) : fit.angle;
        const ComplexPlace turn = std::polar(1.0, angle);
        double sum = 0;
        for (std::size_t k = 0; k < line.size(); ++k) {
            sum += std::norm(line[k] - turn * other[k]);
        }
        return RoughFit{angle, offset, std::sqrt(sum / kPlaces)};
    };
    double low = fit.offset - 1.0 / kPlaces, high = fit.offset + 1.0 / kPlaces;
    for (int k = 0; k < kThirds; ++k) {
        const double a = low + (high - low) / 3, b = high - (high - low) / 3;
        const bool isBefore = tried(a).distance < tried(b).distance;
        (isBefore ? high : low) = isBefore ? b : a;
    }
    return tried((low + high) / 2);
}

}  // namespace

Eigen::RowVector2d middleOf(const geometry::Line& line) {
    Eigen::RowVector2d sum = Eigen::RowVector2d::Zero();
    for (int k = 0; k < kPlaces; ++k) {
        sum += line.pointAt(line.arc()[0] + line.length() * k / kPlaces) / kPlaces;
    }
    return sum;
}

RoughFit roughFitAt(const geometry::Line& ours, const geometry::Line& theirs, double angle) {
    const double scale = ours.length() / theirs.length();
    const auto line = evenPlaces(ours, 0, 1), other = evenPlaces(theirs, 0, scale);
    const ComplexPlace back = std::polar(1.0, -angle);
    RoughFit best{angle, 0, std::numeric_limits<double>::infinity()};
    const double squares = squaresOf(line) + squaresOf(other);
    for (std::size_t start = 0; start < line.size(); ++start) {
        const double square = squares - 2 * std::real(back * likeness(line, other, start));
        const double distance = std::sqrt(std::max(square, 0.0) / kPlaces);
        if (distance < best.distance) {
            best = {angle, static_cast<double>(start) / kPlaces, distance};
        }
    }
    return refined(ours, theirs, best, false);
}

RoughFit roughFit(const geometry::Line& ours, const geometry::Line& theirs,
                  const std::vector<double>& angles) {
    const double scale = ours.length() / theirs.length();
    const auto line = evenPlaces(ours, 0, 1), other = evenPlaces(theirs, 0, scale);
    const auto most = bestLikeness(line, other);
    const RoughFit best =
        refined(ours, theirs,
                {std::arg(most.likeness), static_cast<double>(most.start) / kPlaces, 0}, true);
    for (const double angle : angles) {
        const RoughFit fit = roughFitAt(ours, theirs, angle);
        if (fit.distance <= kAboutAsWell * best.distance + kAboutAsNear) {
            return fit;
        }
    }
    return best;
}

LineMap::LineMap(const geometry::Line& ours, const geometry::Line& theirs, const RoughFit& fit)
    : LineMap(ours.length()) {
    const double scale = ours.length() / theirs.length();
    const auto corners = cornersOf(ours, middleOf(ours), 1);
    const auto others = cornersOf(theirs, middleOf(theirs), scale);
    std::vector<int> best(corners.size(), -1), partner = best;
    if (!corners.empty() && !others.empty()) {
        const CornerPairs pairs(corners, others, ours.length(), fit.distance);
        const double trials = static_cast<double>(corners.size()) *
                              static_cast<double>(others.size()) *
                              static_cast<double>(others.size());
        double least = std::numeric_limits<double>::infinity();
        for (std::size_t start = 0; start < others.size(); ++start) {
            const double cost = pairs.from(start, partner);
            if (cost < least) {
                least = cost;
                best = partner;
            }
            if (trials > kMaxCornerTrials) {
                break;
            }
        }
    }
    std::vector<double> oursAt, theirsAt;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        if (best[i] < 0 || (!oursAt.empty() && corners[i].at <= oursAt.back())) {
            continue;
        }
        const auto j = static_cast<std::size_t>(best[i]) % others.size();
        double at = others[j].at;
        while (!theirsAt.empty() && at < theirsAt.back()) {
            at += theirs.length();
        }
        oursAt.push_back(corners[i].at);
        theirsAt.push_back(at);
    }
    if (oursAt.empty()) {
        oursAt.push_back(0);
        theirsAt.push_back(theirs.length() * fit.offset);
    }
    oursAt.push_back(oursAt.front() + ours.length());
    theirsAt.push_back(theirsAt.front() + theirs.length());
    ours_ = geometry::Arc(std::move(oursAt), true);
    theirs_ = geometry::Arc(std::move(theirsAt), true);
}

}  // namespace toile::prove
