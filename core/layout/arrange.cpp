// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/layout/arrange.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/base/angle.h"

namespace toile {
namespace {

double moveOf(const Eigen::AlignedBox2d& box, const Eigen::AlignedBox2d& all, Alignment alignment) {
    switch (alignment) {
        case Alignment::Left:
            return all.min().x() - box.min().x();
        case Alignment::Right:
            return all.max().x() - box.max().x();
        case Alignment::Centre:
            return all.center().x() - box.center().x();
        case Alignment::Top:
            return all.max().y() - box.max().y();
        case Alignment::Bottom:
            return all.min().y() - box.min().y();
        case Alignment::Middle:
            return all.center().y() - box.center().y();
    }
    return 0;  // unreachable: the switch has every alignment
}

bool isAcross(Alignment alignment) {
    return alignment == Alignment::Left || alignment == Alignment::Right ||
           alignment == Alignment::Centre;
}

}  // namespace

double wrappedAngle(double angle) {
    if (!std::isfinite(angle)) {
        return 0;
    }
    const double wrapped = std::remainder(angle, 2 * kPi);
    return wrapped <= -kPi ? wrapped + 2 * kPi : wrapped;
}

double directionTo(const Eigen::Vector2d& from, const Eigen::Vector2d& to) {
    return std::atan2(to.y() - from.y(), to.x() - from.x());
}

Placement movedBy(Placement placement, const Eigen::Vector2d& way) {
    placement.offset += way;
    return placement;
}

Placement turnedAbout(Placement placement, const Eigen::Vector2d& centre, double angle) {
    placement.offset = centre + Eigen::Rotation2Dd(angle) * (placement.offset - centre);
    placement.turn = wrappedAngle(placement.turn + angle);
    return placement;
}

Placement mirroredAt(Placement placement, const Eigen::Vector2d& centre, Mirroring mirroring) {
    const bool across = mirroring == Mirroring::LeftRight;
    const int axis = across ? 0 : 1;
    placement.offset[axis] = 2 * centre[axis] - placement.offset[axis];
    // A reflection after a turn is the opposite turn after a reflection.
    placement.turn = wrappedAngle(across ? -placement.turn : kPi - placement.turn);
    placement.mirrored = !placement.mirrored;
    return placement;
}

double directionOnSheet(const Placement& placement, double direction) {
    return wrappedAngle(placement.turn + (placement.mirrored ? kPi - direction : direction));
}

double directionOnPiece(const Placement& placement, double direction) {
    const double turned = direction - placement.turn;
    return wrappedAngle(placement.mirrored ? kPi - turned : turned);
}

Points2 placedOutline(const Points2& Q, const std::vector<int>& boundary,
                      const Placement& placement) {
    Points2 points(boundary.size(), 2);
    for (std::size_t i = 0; i < boundary.size(); ++i) {
        points.row(static_cast<Eigen::Index>(i)) =
            placement.applied(Q.row(boundary[i]).transpose()).transpose();
    }
    return points;
}

Eigen::AlignedBox2d outlineBox(const Points2& outline, const Placement& placement) {
    Eigen::AlignedBox2d box;
    const Eigen::Matrix2d linear = placement.linear();
    for (Eigen::Index i = 0; i < outline.rows(); ++i) {
        box.extend(Eigen::Vector2d(placement.offset + linear * outline.row(i).transpose()));
    }
    return box;
}

std::vector<Eigen::Vector2d> alignmentMoves(std::span<const Eigen::AlignedBox2d> boxes,
                                            Alignment alignment) {
    Eigen::AlignedBox2d all;
    for (const Eigen::AlignedBox2d& box : boxes) {
        all.extend(box);
    }
    std::vector<Eigen::Vector2d> moves;
    for (const Eigen::AlignedBox2d& box : boxes) {
        const double move = moveOf(box, all, alignment);
        moves.emplace_back(isAcross(alignment) ? move : 0, isAcross(alignment) ? 0 : move);
    }
    return moves;
}

std::vector<Eigen::Vector2d> distributionMoves(std::span<const Eigen::AlignedBox2d> boxes,
                                               Direction direction) {
    std::vector<Eigen::Vector2d> moves(boxes.size(), Eigen::Vector2d::Zero());
    if (boxes.size() < 3) {
        return moves;
    }
    const int axis = direction == Direction::Across ? 0 : 1;
    std::vector<std::size_t> order(boxes.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::stable_sort(order, {}, [&](std::size_t i) { return boxes[i].center()[axis]; });
    double filled = 0;
    for (const Eigen::AlignedBox2d& box : boxes) {
        filled += box.sizes()[axis];
    }
    const double room = boxes[order.back()].max()[axis] - boxes[order.front()].min()[axis];
    const double gap = (room - filled) / static_cast<double>(boxes.size() - 1);
    double place = boxes[order.front()].min()[axis];
    for (const std::size_t i : order) {
        moves[i][axis] = place - boxes[i].min()[axis];
        place += boxes[i].sizes()[axis] + gap;
    }
    moves[order.front()].setZero();
    moves[order.back()].setZero();  // but for rounding they are that already
    return moves;
}

}  // namespace toile
