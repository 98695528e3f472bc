// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/pattern/grain_line.h"

#include <algorithm>
#include <cmath>

namespace toile {
namespace {

constexpr double kLongest = 300;      // mm
constexpr double kShortestGrain = 5;  // mm: a shorter line is useless
constexpr double kShare = 0.8;        // part of the free box that is drawn
constexpr double kSlender = 10;       // ratio of length to width: room for the arrow head
constexpr double kHead = 6;           // mm
constexpr double kHeadShare = 0.15;   // of the line, at most
constexpr double kHeadAngle = 0.35;   // radians to either side

}  // namespace

std::optional<Chord> grainLine(const FreeCloth& cloth, double angle) {
    if (!std::isfinite(angle)) {
        return std::nullopt;
    }
    const PoleSearch search{.tolerance = 0.02,
                            .slack = 0.05,
                            .enough = kLongest / kShare,
                            .useful = kShortestGrain / kShare};
    const auto pole = boxPole(cloth, {1, 1 / kSlender}, angle, coarserIfSmall(search, cloth));
    const double length = pole ? std::min(kLongest, kShare * pole->room) : 0;
    if (length < kShortestGrain) {
        return std::nullopt;
    }
    const Eigen::Vector2d half = 0.5 * length * Eigen::Vector2d(std::cos(angle), std::sin(angle));
    return Chord{pole->place - half, pole->place + half};
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
