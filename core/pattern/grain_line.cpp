// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/pattern/grain_line.h"

#include <algorithm>
#include <cmath>

#include "core/geometry/segment.h"

namespace toile {
namespace {

constexpr int kTrials = 24;          // parallel lines
constexpr double kShare = 0.7;       // of the stretch inside that is drawn
constexpr double kLongest = 300;     // mm
constexpr double kShortest = 5;      // mm: what is shorter says nothing
constexpr double kHead = 6;          // mm
constexpr double kHeadShare = 0.15;  // of the line, at most
constexpr double kHeadAngle = 0.35;  // radians to either side
constexpr double kClear = 1.5;       // mm between the line and what it keeps off

/// Where the line enters and leaves the cloth, as distances from the point, in pairs.
std::vector<double> crossings(const std::vector<Points2>& loops, const Eigen::Vector2d& point,
                              const Eigen::Vector2d& direction) {
    std::vector<double> places;
    const Eigen::Vector2d normal = geometry::leftOf(direction);
    for (const Points2& loop : loops) {
        const Eigen::Index count = loop.rows();
        for (Eigen::Index i = 0; i < count; ++i) {
            const Eigen::Vector2d a = loop.row(i).transpose() - point;
            const Eigen::Vector2d b = loop.row((i + 1) % count).transpose() - point;
            const double da = a.dot(normal), db = b.dot(normal);
            if ((da < 0) != (db < 0)) {  // a vertex on the line counts for one of its edges
                places.push_back((a + da / (da - db) * (b - a)).dot(direction));
            }
        }
    }
    std::ranges::sort(places);
    return places;
}

bool meets(const Chord& chord, const Eigen::AlignedBox2d& box) {
    if (box.isEmpty()) {
        return false;
    }
    const Eigen::Vector2d way = chord.to - chord.from;
    const geometry::ShareInBox share =
        geometry::shareInBox<Eigen::Vector2d>(chord.from, way, box.min(), box.max());
    return share.first <= share.last;
}

Chord shortened(const Eigen::Vector2d& point, const Eigen::Vector2d& direction, double from,
                double to) {
    const double half = 0.5 * std::min(kLongest, kShare * (to - from));
    const Eigen::Vector2d middle = point + 0.5 * (from + to) * direction;
    return {middle - half * direction, middle + half * direction};
}

}  // namespace

std::optional<Chord> grainLine(const std::vector<Points2>& loops, double angle,
                               const Eigen::AlignedBox2d& off) {
    if (loops.empty() || loops.front().rows() < 3 || !std::isfinite(angle)) {
        return std::nullopt;
    }
    const Eigen::Vector2d direction(std::cos(angle), std::sin(angle));
    const Eigen::Vector2d normal = geometry::leftOf(direction);
    const Eigen::VectorXd across = loops.front() * normal;
    const double low = across.minCoeff(), high = across.maxCoeff();
    Eigen::AlignedBox2d around = off;
    if (!around.isEmpty()) {
        around = {off.min().array() - kClear, off.max().array() + kClear};
    }
    std::optional<Chord> best;
    double longest = kShortest;
    for (int k = 0; k < kTrials; ++k) {
        // From the middle outwards, so that of equals the one nearest to the middle is taken.
        const double side = k % 2 == 0 ? 1 : -1;
        const int step = (k + 1) / 2;
        const double place = 0.5 * (low + high) + side * step * (high - low) / (kTrials + 2);
        const Eigen::Vector2d point = place * normal;
        const std::vector<double> places = crossings(loops, point, direction);
        for (std::size_t i = 0; i + 1 < places.size(); i += 2) {
            const Chord chord = shortened(point, direction, places[i], places[i + 1]);
            const double length = (chord.to - chord.from).norm();
            if (length > longest * (1 + 1e-9) && !meets(chord, around)) {
                longest = length;
                best = chord;
            }
        }
    }
    return best;
}

Points2 arrowPath(const Chord& line) {
    const Eigen::Vector2d way = line.to - line.from;
    const double head = std::min(kHead, kHeadShare * way.norm());
    const Eigen::Vector2d back = -head * way.normalized();
    Points2 path(5, 2);
    path << line.from.transpose(), line.to.transpose(),
        (line.to + Eigen::Rotation2Dd(kHeadAngle) * back).transpose(), line.to.transpose(),
        (line.to + Eigen::Rotation2Dd(-kHeadAngle) * back).transpose();
    return path;
}

}  // namespace toile
