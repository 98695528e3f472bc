// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/nest/problem.h"

#include <algorithm>
#include <utility>

#include "core/nest/rules.h"

namespace toile::nest {

NestPlacement placementOf(const Problem& problem, std::size_t copy, const Pose& pose) {
    const Variant& variant = problem.itemOf(copy).variants[static_cast<std::size_t>(pose.variant)];
    return {problem.copies[copy].item, variant.angle + pose.turn, variant.mirrored, pose.x, pose.y};
}

const Shape& shapeOf(const Item& item, const Pose& pose, Shape& own) {
    const Variant& variant = item.variants[static_cast<std::size_t>(pose.variant)];
    if (pose.turn == 0) {
        return variant.shape;
    }
    turn(item.unturned[variant.mirrored ? 1 : 0], variant.angle + pose.turn, own);
    return own;
}

Rings ringsAt(const Problem& problem, std::size_t copy, const Pose& pose, bool isBare) {
    NestItem item;
    item.rings = isBare ? problem.itemOf(copy).bare : problem.itemOf(copy).grown;
    return wound(placedRings(item, placementOf(problem, copy, pose)));
}

const Obstacle* obstacleUnder(const Problem& problem, std::size_t copy, const Pose& pose) {
    if (problem.obstacles.empty()) {
        return nullptr;
    }
    const Rings own = ringsAt(problem, copy, pose, true);
    const auto item = static_cast<std::size_t>(problem.copies[copy].item);
    const auto under = std::ranges::find_if(problem.obstacles, [&](const Obstacle& obstacle) {
        return obstacle.isFor[item] && doOverlap(own, obstacle.rings);
    });
    return under == problem.obstacles.end() ? nullptr : &*under;
}

bool isValid(const Problem& problem, const std::vector<Pose>& poses, double length) {
    struct Placed {
        Rings rings;
        double left, bottom, right, top;
    };
    std::vector<Placed> placed;
    for (std::size_t c = 0; c < poses.size(); ++c) {
        Rings rings = ringsAt(problem, c, poses[c]);
        if (!keepsRules(problem, problem.itemOf(c), poses[c], rings[0], length) ||
            obstacleUnder(problem, c, poses[c])) {
            return false;
        }
        const Eigen::RowVector2d low = rings[0].colwise().minCoeff();
        const Eigen::RowVector2d high = rings[0].colwise().maxCoeff();
        placed.push_back({std::move(rings), low.x(), low.y(), high.x(), high.y()});
    }
    for (auto a = placed.begin(); a != placed.end(); ++a) {
        for (auto b = placed.begin(); b != a; ++b) {
            if (b->left < a->right && b->right > a->left && b->bottom < a->top &&
                b->top > a->bottom && doOverlap(b->rings, a->rings)) {
                return false;
            }
        }
    }
    return true;
}

}  // namespace toile::nest
