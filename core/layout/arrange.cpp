// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/layout/arrange.h"

#include <algorithm>
#include <map>
#include <numeric>

#include <Eigen/Geometry>

#include "core/base/text.h"

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

std::vector<ClothNeed> clothNeeds(const LaidOutPattern& laid, const Fabric& own) {
    const Pattern& pattern = laid.pattern;
    std::map<std::string, Eigen::AlignedBox2d> boxes;
    for (const PlacedCopy& copy : laid.marker.copies) {
        const PatternPiece& piece = pattern.pieces[static_cast<std::size_t>(copy.piece)];
        const Points2 line = turnedLine(edgeOf(piece), copy.placement);
        Eigen::AlignedBox2d& box =
            boxes[findMaterial(piece.material, pattern.materials) ? piece.material : std::string()];
        for (Eigen::Index k = 0; k < line.rows(); ++k) {
            box.extend(Eigen::Vector2d(line.row(k).transpose()) + copy.placement.offset);
        }
    }
    std::vector<ClothNeed> needs;
    needs.reserve(boxes.size());
    for (const auto& [material, box] : boxes) {
        needs.push_back({material, box.sizes().y(), box.sizes().x(),
                         fabricOf(material, pattern.materials, own).width});
    }
    return needs;
}

std::string sentence(const ClothNeed& need) {
    const std::string of = need.material.empty() ? "" : " (" + need.material + ')';
    return need.fits() ? fixed(need.length, 0) + " mm of cloth" + of + ' ' + fixed(need.width, 0) +
                             " mm wide for this layout"
                       : "the pieces" + of + " lie " + fixed(need.across, 0) +
                             " mm wide, but the cloth is " + fixed(need.width, 0) + " mm";
}

}  // namespace toile
