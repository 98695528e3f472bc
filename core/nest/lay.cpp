// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/nest/lay.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "core/nest/collision.h"
#include "core/nest/rules.h"

namespace toile::nest {
namespace {

constexpr double kMinGrowth = 1.2, kMaxLayGrowth = 2.0, kFading = 0.95;
constexpr double kMaxWeight = 1e100;

}  // namespace

Lay::Lay(const Problem& problem, const std::vector<Pose>& poses, double length)
    : problem_(&problem),
      length_(length),
      poses_(poses.size() + problem.obstacles.size()),
      owned_(poses.size()),
      shapes_(all()),
      left_(all()),
      bottom_(all()),
      right_(all()),
      top_(all()),
      excess_(all()),
      pairs_(all()) {
    for (std::size_t k = count(); k < all(); ++k) {
        shapes_[k] = &problem.obstacles[k - count()].shape;
        setBox(k);
    }
    placeAll(poses, length);
}

double Lay::loss() const {
    double sum = 0;
    for (std::size_t a = 0; a < all(); ++a) {
        sum += excess_[a];
        for (const Pair& pair : pairs_[a]) {
            sum += pair.other < a ? pair.loss : 0;
        }
    }
    return sum;
}

double Lay::weightedLossOf(std::size_t copy) const {
    double sum = excess_[copy];
    for (const Pair& pair : pairs_[copy]) {
        sum += pair.loss * pair.weight;
    }
    return sum;
}

double Lay::usedLength() const {
    const auto end = right_.begin() + static_cast<std::ptrdiff_t>(count());
    return count() == 0 ? 0 : *std::max_element(right_.begin(), end);
}

double Lay::lossAt(std::size_t copy, const Shape& shape, double x, double y, double enough) const {
    const double left = x + shape.box.left, right = x + shape.box.right;
    const double bottom = y + shape.box.bottom, top = y + shape.box.top;
    thread_local std::vector<std::uint32_t> near;
    near.resize(all() + 1);
    std::size_t found = 0;
    for (std::size_t other = 0; other < all(); ++other) {  // branchless
        near[found] = static_cast<std::uint32_t>(other);
        const unsigned meetsAlong = unsigned{left_[other] < right} & unsigned{right_[other] > left};
        const unsigned meetsAcross =
            unsigned{bottom_[other] < top} & unsigned{top_[other] > bottom};
        found += meetsAlong & meetsAcross & unsigned{other != copy};
    }
    double sum = 0;
    auto pair = pairs_[copy].begin();
    for (std::size_t k = 0; k < found; ++k) {
        const std::size_t other = near[k];
        if (const double loss = lossWith(copy, shape, x, y, other); loss > 0) {
            while (pair != pairs_[copy].end() && pair->other < other) {
                ++pair;
            }
            const bool isKnown = pair != pairs_[copy].end() && pair->other == other;
            sum += isKnown ? pair->weight * loss : loss;
            if (sum >= enough) {
                break;
            }
        }
    }
    return sum;
}

double Lay::lossWith(std::size_t copy, const Shape& shape, double x, double y,
                     std::size_t other) const {
    const double dx = poses_[other].x - x, dy = poses_[other].y - y;
    if (other < count()) {
        return doCollide(shape, *shapes_[other], dx, dy)
                   ? collisionLoss(shape, *shapes_[other], dx, dy)
                   : 0;
    }
    const Obstacle& obstacle = problem_->obstacles[other - count()];
    const Shape& bare = bareOf(shape);
    return obstacle.isFor[static_cast<std::size_t>(problem_->copies[copy].item)] &&
                   doCollide(bare, obstacle.shape, dx, dy)
               ? collisionLoss(bare, obstacle.shape, dx, dy)
               : 0;
}

bool Lay::moveInside(std::size_t copy, const Shape& shape, Pose& pose) const {
    return nest::moveInside(*problem_, problem_->itemOf(copy), shape, length_, pose);
}

void Lay::setPose(std::size_t copy, const Pose& pose) {
    poses_[copy] = pose;
    const Shape& shape = shapeOf(copy, pose, owned_[copy]);
    shapes_[copy] = &shape;
    // A loss like that of full overlap, so that the copy looks for another rotation.
    const bool fits = problem_->itemOf(copy).isFixed || moveInside(copy, shape, poses_[copy]);
    excess_[copy] = fits ? 0 : shape.diameter * shape.diameter;
    setBox(copy);
}

void Lay::setBox(std::size_t k) {
    const Pose& at = poses_[k];
    const Box& box = shapes_[k]->box;
    left_[k] = at.x + box.left;
    right_[k] = at.x + box.right;
    bottom_[k] = at.y + box.bottom;
    top_[k] = at.y + box.top;
}

void Lay::updateLosses(std::size_t copy) {
    const bool isFixed = problem_->itemOf(copy).isFixed;
    for (std::size_t other = 0; other < all(); ++other) {
        const bool areFixed = isFixed && (other >= count() || problem_->itemOf(other).isFixed);
        const bool meet = other != copy && !areFixed && left_[other] < right_[copy] &&
                          right_[other] > left_[copy] && bottom_[other] < top_[copy] &&
                          top_[other] > bottom_[copy];
        const double loss =
            meet ? lossWith(copy, *shapes_[copy], poses_[copy].x, poses_[copy].y, other) : 0;
        setLoss(copy, other, loss);
        setLoss(other, copy, loss);
    }
}

void Lay::setLoss(std::size_t a, std::size_t b, double loss) {
    std::vector<Pair>& pairs = pairs_[a];
    const auto at = std::ranges::lower_bound(pairs, b, {}, &Pair::other);
    const bool isKnown = at != pairs.end() && at->other == b;
    if (isKnown && loss == 0 && at->weight == 1) {
        pairs.erase(at);
    } else if (isKnown) {
        at->loss = loss;
    } else if (loss != 0) {
        pairs.insert(at, {b, loss, 1});
    }
}

void Lay::place(std::size_t copy, const Pose& pose) {
    setPose(copy, pose);
    updateLosses(copy);
}

void Lay::placeAll(const std::vector<Pose>& poses, double length) {
    length_ = length;
    for (std::size_t copy = 0; copy < count(); ++copy) {
        setPose(copy, poses[copy]);
    }
    for (std::size_t copy = 0; copy < count(); ++copy) {
        updateLosses(copy);
    }
}

void Lay::resetWeights() {
    for (std::vector<Pair>& pairs : pairs_) {
        std::erase_if(pairs, [](const Pair& pair) { return pair.loss == 0; });
        for (Pair& pair : pairs) {
            pair.weight = 1;
        }
    }
}

void Lay::raiseWeights() {
    double most = 0;
    for (const std::vector<Pair>& pairs : pairs_) {
        for (const Pair& pair : pairs) {
            most = std::max(most, pair.loss);
        }
    }
    for (std::vector<Pair>& pairs : pairs_) {
        for (Pair& pair : pairs) {
            pair.weight = pair.loss > 0
                              ? std::min(kMaxWeight,
                                         pair.weight * (kMinGrowth + (kMaxLayGrowth - kMinGrowth) *
                                                                         pair.loss / most))
                              : std::max(1.0, pair.weight * kFading);
        }
        std::erase_if(pairs, [](const Pair& pair) { return pair.loss == 0 && pair.weight == 1; });
    }
}

}  // namespace toile::nest
