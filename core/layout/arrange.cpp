// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/layout/arrange.h"

#include <algorithm>
#include <numeric>

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
    moves[order.back()].setZero();  // already zero, except for rounding
    return moves;
}

}  // namespace toile
