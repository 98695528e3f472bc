// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/marker/cloth_drag.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace toile::app {

namespace {

constexpr double kHalfTurn = std::numbers::pi;

/// Angle between a copy's warp and the cloth, in the nearer direction if both are allowed.
double deviationOf(const Pattern& pattern, const Placement& placement, int piece,
                   const MarkerSettings& settings) {
    const double grain = grainOf(pattern.pieces[static_cast<std::size_t>(piece)]);
    const double on = directionOnSheet(placement, grain);
    return settings.turns == TurnRule::OneWay ? wrappedAngle(on) : std::remainder(on, kHalfTurn);
}

Placement turnedAboutMiddle(const Pattern& pattern, const LaidCopy& copy, double angle) {
    return turnedAbout(copy.placement, geometry::boxAround(laidOutline(pattern, copy)).center(),
                       angle);
}

Points2 joined(const std::vector<Points2>& lines) {
    Eigen::Index count = 0;
    for (const Points2& line : lines) {
        count += line.rows();
    }
    Points2 all(count, 2);
    Eigen::Index next = 0;
    for (const Points2& line : lines) {
        all.middleRows(next, line.rows()) = line;
        next += line.rows();
    }
    return all;
}

}  // namespace

std::optional<Placement> nextTurn(const Pattern& pattern, const LaidCopy& copy,
                                  const MarkerSettings& settings, bool clockwise) {
    if (settings.turns == TurnRule::OneWay) {
        return std::nullopt;
    }
    const double step = settings.turns == TurnRule::Free ? kHalfTurn / 2 : kHalfTurn;
    return turnedAboutMiddle(pattern, copy, clockwise ? -step : step);
}

bool turnsByDegrees(const MarkerSettings& settings) {
    return settings.turns == TurnRule::Free || settings.tolerance > 0;
}

Placement turnedBy(const Pattern& pattern, const LaidCopy& copy, const MarkerSettings& settings,
                   double angle, double step) {
    double turn = step > 0 ? std::round(angle / step) * step : angle;
    if (settings.turns != TurnRule::Free) {
        const Placement wanted = turnedAboutMiddle(pattern, copy, turn);
        const double off = deviationOf(pattern, wanted, copy.piece, settings);
        turn += std::clamp(off, -settings.tolerance, settings.tolerance) - off;
    }
    return turnedAboutMiddle(pattern, copy, turn);
}

ClothDrag::ClothDrag(const Pattern& pattern, const ClothMarker& marker,
                     const MarkerSettings& settings, int copy, const Eigen::Vector2d& pressed)
    : before_(marker.copies[static_cast<std::size_t>(copy)].placement), pressed_(pressed) {
    std::vector<Points2> corners;
    for (std::size_t c = 0; c < marker.copies.size(); ++c) {
        const Points2 line = laidOutline(pattern, marker.copies[c]);
        Eigen::AlignedBox2d box = geometry::boxAround(line);
        if (static_cast<int>(c) == copy) {
            box_ = box;
            corners_ = snapPoints(line);
            continue;
        }
        const Eigen::Vector2d gap = Eigen::Vector2d::Constant(settings.gap);
        targets_.boxes.emplace_back(box.min() - gap, box.max() + gap);
        corners.push_back(snapPoints(line));
    }
    const auto addCloth = [&](Eigen::AlignedBox2d box) {
        const Eigen::Vector2d border = Eigen::Vector2d::Constant(settings.border);
        targets_.boxes.emplace_back(box.min() + border, box.max() - border);
    };
    for (const ClothPart& part : marker.parts) {
        addCloth(geometry::boxAround(part.outline));
    }
    if (marker.parts.empty()) {
        addCloth({Eigen::Vector2d::Zero(), Eigen::Vector2d(marker.length, marker.width)});
    }
    if (!(settings.gap > 0)) {  // snapping corners would ignore the gap
        targets_.vertices = joined(corners);
    }
}

Placement ClothDrag::movedTo(const Eigen::Vector2d& at, double radius) {
    const Eigen::Vector2d way = at - pressed_;
    move_ = radius > 0 ? snappedMove(box_, corners_, way, targets_, radius) : SnappedMove{way};
    return movedBy(before_, move_.way);
}

}  // namespace toile::app
