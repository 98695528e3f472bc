// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/flatten/boundary/circle_outline.h"

#include <cmath>
#include <numbers>

#include "core/base/text.h"

namespace toile {
namespace {

constexpr double kHalfTurn = std::numbers::pi;
constexpr int kMaxBisections = 1100;  // more than there are halvings of a double's range

/// Half the central angle of every edge where the longest edge's half is `half`, in (0, pi / 2]:
/// asin(r sin(half)) for the edge of relative length r, written so that no digits are lost where
/// both r and the sine are nearly one.
Eigen::VectorXd halfAngles(const Eigen::VectorXd& relative, double half) {
    const double sine = std::sin(half);
    const double cosine = std::cos(half);
    return relative.unaryExpr([&](double r) {
        const double rest = cosine * cosine + (1 - r) * (1 + r) * sine * sine;
        return std::atan2(r * sine, std::sqrt(rest));
    });
}

}  // namespace

Result<Points2> circleOutline(const Eigen::VectorXd& lengths) {
    const auto n = static_cast<int>(lengths.size());
    int longest = 0;
    const double most = lengths.maxCoeff(&longest);
    double others = 0;
    for (int i = 0; i < n; ++i) {
        others += i == longest ? 0 : lengths[i];
    }
    if (!(most > 0 && most < others)) {
        return Error{
            ErrorCode::NoClosedOutline,
            {},
            "the edge has " + shortest(most) + ", the others together " + shortest(others)};
    }
    const Eigen::VectorXd relative = lengths / most;
    // How far the other edges reach past closing. With the centre inside, all halves sum to half a
    // turn. Where they cannot, even in the smallest circle that holds the longest edge, the centre
    // lies beyond that edge, and its half is the sum of the others.
    const bool outside = halfAngles(relative, kHalfTurn / 2).sum() < kHalfTurn;
    const auto isBelow = [&](double half) {
        const Eigen::VectorXd halves = halfAngles(relative, half);
        return outside ? halves.sum() - halves[longest] > half : halves.sum() < kHalfTurn;
    };
    // Inside, the sum grows with the longest edge's half. Outside, the others exceed it in a flat
    // circle, where arcs are as chords, and fall below it at a quarter turn.
    double low = 0;
    double high = kHalfTurn / 2;
    for (int k = 0; k < kMaxBisections; ++k) {
        const double middle = 0.5 * (low + high);
        if (middle == low || middle == high) {
            break;
        }
        (isBelow(middle) ? low : high) = middle;
    }
    Eigen::VectorXd halves = halfAngles(relative, 0.5 * (low + high));
    if (outside) {
        halves[longest] = kHalfTurn - halves[longest];  // its arc is the rest of the turn
    }
    // Walked edge by edge: each has its length to rounding, whatever the radius. An edge's
    // direction turns by its own half and its neighbour's. What is left of closing, rounding too,
    // is shared by all edges.
    Points2 steps(n, 2);
    double direction = 0;
    for (int k = 0; k < n; ++k) {
        const int i = (longest + k) % n;
        steps.row(i) << lengths[i] * std::cos(direction), lengths[i] * std::sin(direction);
        direction += halves[i] + halves[(i + 1) % n];
    }
    const Eigen::RowVector2d gap = steps.colwise().sum();
    Points2 outline(n, 2);
    Eigen::RowVector2d at = Eigen::RowVector2d::Zero();
    for (int i = 0; i < n; ++i) {
        outline.row(i) = at;
        at += steps.row(i) - gap * (lengths[i] / (most + others));
    }
    return outline;
}

}  // namespace toile
