// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/pattern/corner_allowance.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace toile {
namespace {

using Eigen::Vector2d;
using Places = std::vector<Vector2d>;

/// Two sides of a corner with the common terms of their formulas.
struct Sides {
    const AllowanceSide &first, &second;
    double sine = first.onward.dot(second.outward);     ///< of the turn
    double cosine = first.outward.dot(second.outward);  ///< of the turn

    double widest() const { return std::max(first.width, second.width); }
    /// 1 - cosine, without cancellation for small turns.
    double versine() const { return cosine > 0 ? sine * sine / (1 + cosine) : 1 - cosine; }
};

Vector2d offset(const AllowanceSide& side) {
    return side.width * side.outward;
}

/// The point of a side's cutting line that is `reach` from the corner in direction `tip`.
Vector2d cutOff(const AllowanceSide& side, const Vector2d& tip, double reach) {
    const double along = side.onward.dot(tip), across = side.outward.dot(tip);
    const double beyond = reach > side.width ? (reach - side.width) / along : 0;
    return offset(side) + (beyond + side.width * along / (1 + across)) * side.onward;
}

/// The intersection of the two cutting lines; nothing if it lies beside one of the edges, or, at a
/// concave corner, if an allowance ends at the other's side or they meet far from the corner.
std::optional<Places> mitre(const Sides& s, double limit) {
    const double a = s.first.width, b = s.second.width;
    const double x = b - a + a * s.versine(), y = a - b + b * s.versine();  // times the sine
    if (x < 0 || y < 0) {
        return std::nullopt;
    }
    if (s.sine < 0) {
        const AllowanceSide &first = s.first, &second = s.second;
        if (s.cosine <= 0 || x > -s.sine * first.length / 2 || y > -s.sine * second.length / 2 ||
            -s.sine * b > first.length || -s.sine * a > second.length) {
            return std::nullopt;
        }
    } else {
        const Vector2d tip = s.sine * offset(s.first) + x * s.first.onward;
        const double reach = limit * s.widest();
        if (tip.norm() > reach * s.sine) {
            const Vector2d direction = tip.normalized();
            return Places{cutOff(s.first, direction, reach), cutOff(s.second, direction, reach)};
        }
    }
    const double onward = s.sine == 0 ? 0 : x / s.sine;
    return Places{offset(s.first) + onward * s.first.onward};
}

CornerJoin stepped(const Sides& s) {
    AllowanceSide first = s.first, second = s.second;
    first.width = second.width = std::min(first.width, second.width);
    if (-s.sine * first.width > kAllowanceOverlap) {
        return {{offset(s.first), Vector2d::Zero(), offset(s.second)}, true, true};
    }
    const auto inner = mitre({first, second}, kMitreLimit);
    CornerJoin join{inner ? *inner : Places{offset(first), offset(second)}};
    if (s.first.width > first.width) {
        join.path.insert(join.path.begin(), {offset(s.first), offset(first)});
        join.stepsFirst = true;
    }
    if (s.second.width > second.width) {
        join.path.insert(join.path.end(), {offset(second), offset(s.second)});
        join.stepsSecond = true;
    }
    return join;
}

/// Ends the first allowance in a line through R; nothing if R is too far, or does not exist.
std::optional<CornerJoin> endFirst(const Sides& s, bool mirrored) {
    const double reach = kMitreLimit * s.widest();
    const double most = std::sqrt(reach * reach - s.first.width * s.first.width) * s.sine;
    const double end = s.second.width + (mirrored ? s.first.width * s.cosine : 0);
    if (s.first.width == 0 || s.sine <= 0 || s.second.width > reach * s.sine ||
        std::abs(end) > most) {
        return std::nullopt;
    }
    const Vector2d root = s.second.width / s.sine * s.first.onward;
    const Vector2d tip = offset(s.first) + end / s.sine * s.first.onward;
    CornerJoin join{{tip, root}};
    if (s.cosine > 0) {  // the second allowance starts before the root
        join.path.insert(join.path.end(), {Vector2d::Zero(), offset(s.second)});
    }
    if (end < 0) {
        // More than the excess of a straight allowance, to cover curved ones.
        join.reach = -2 * end / s.sine;
        const Vector2d side = 1.5 * (tip - root), beyond = join.reach * s.first.onward;
        join.cut = {root, root + side, root + side + beyond, root + beyond};
        join.cutsFirst = true;
    }
    return join;
}

std::optional<CornerJoin> endSecond(const Sides& s, bool mirrored) {
    auto join = endFirst({s.second, s.first}, mirrored);
    if (join) {
        std::reverse(join->path.begin(), join->path.end());
        std::reverse(join->cut.begin(), join->cut.end());
        join->cutsFirst = false;
    }
    return join;
}

std::optional<CornerJoin> ended(const Sides& s, CornerRule rule) {
    switch (rule) {
        case CornerRule::RightAngleFirst:
            return endFirst(s, false);
        case CornerRule::MirrorFirst:
            return endFirst(s, true);
        case CornerRule::RightAngleSecond:
            return endSecond(s, false);
        case CornerRule::MirrorSecond:
            return endSecond(s, true);
        default:
            return std::nullopt;
    }
}

}  // namespace

CornerJoin joinAllowances(const AllowanceSide& first, const AllowanceSide& second, CornerRule rule,
                          double limit) {
    const Sides sides{first, second};
    if (auto join = ended(sides, rule)) {
        return std::move(*join);
    }
    if (rule != CornerRule::Stepped || sides.sine < 0) {
        if (auto path = mitre(sides, rule == CornerRule::Square ? 1 : limit)) {
            return {std::move(*path)};
        }
    }
    return stepped(sides);
}

}  // namespace toile
