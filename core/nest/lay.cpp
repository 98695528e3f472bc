// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/nest/lay.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "core/nest/collision.h"

namespace toile::nest {
namespace {

constexpr double kLeastGrowth = 1.2, kMostGrowth = 2.0, kFading = 0.95;
constexpr double kMostWeight = 1e100;

}  // namespace

Lay::Lay(const Problem& problem, const std::vector<Pose>& poses, double length)
    : problem_(&problem),
      length_(length),
      poses_(poses),
      owned_(poses.size()),
      shapes_(poses.size()),
      left_(poses.size()),
      bottom_(poses.size()),
      right_(poses.size()),
      top_(poses.size()),
      excess_(poses.size()),
      losses_(poses.size() * poses.size()),
      weights_(poses.size() * poses.size(), 1) {
    placeAll(poses, length);
}

double Lay::loss() const {
    double sum = 0;
    for (std::size_t a = 0; a < count(); ++a) {
        sum += excess_[a];
        for (std::size_t b = 0; b < a; ++b) {
            sum += losses_[a * count() + b];
        }
    }
    return sum;
}

double Lay::weightedLossOf(std::size_t copy) const {
    double sum = excess_[copy];
    for (std::size_t k = copy * count(); k < (copy + 1) * count(); ++k) {
        sum += losses_[k] * weights_[k];
    }
    return sum;
}

double Lay::usedLength() const {
    return right_.empty() ? 0 : *std::ranges::max_element(right_);
}

double Lay::lossAt(std::size_t copy, const Shape& shape, double x, double y, double enough) const {
    const double left = x + shape.box.left, right = x + shape.box.right;
    const double bottom = y + shape.box.bottom, top = y + shape.box.top;
    thread_local std::vector<std::uint32_t> near;
    near.resize(count() + 1);
    std::size_t found = 0;
    for (std::size_t other = 0; other < count(); ++other) {  // without a branch
        near[found] = static_cast<std::uint32_t>(other);
        const unsigned meetsAlong = unsigned{left_[other] < right} & unsigned{right_[other] > left};
        const unsigned meetsAcross =
            unsigned{bottom_[other] < top} & unsigned{top_[other] > bottom};
        found += meetsAlong & meetsAcross & unsigned{other != copy};
    }
    double sum = 0;
    const double* const weights = &weights_[copy * count()];
    for (std::size_t k = 0; k < found; ++k) {
        const std::size_t other = near[k];
        const double dx = poses_[other].x - x, dy = poses_[other].y - y;
        if (doCollide(shape, *shapes_[other], dx, dy)) {
            sum += weights[other] * collisionLoss(shape, *shapes_[other], dx, dy);
            if (sum >= enough) {
                break;
            }
        }
    }
    return sum;
}

bool Lay::moveInside(const Shape& shape, Pose& pose) const {
    return moveBetween(shape.box.left, shape.box.right, problem_->low, length_, pose.x) &&
           moveBetween(shape.box.bottom, shape.box.top, problem_->low, problem_->high, pose.y);
}

void Lay::setPose(std::size_t copy, const Pose& pose) {
    poses_[copy] = pose;
    const Shape& shape = shapeOf(copy, pose, owned_[copy]);
    shapes_[copy] = &shape;
    // A loss like that of a pair one upon the other, so that it looks for another turn.
    const bool fits = problem_->itemOf(copy).isFixed || moveInside(shape, poses_[copy]);
    excess_[copy] = fits ? 0 : shape.diameter * shape.diameter;
    const Pose& at = poses_[copy];
    left_[copy] = at.x + shape.box.left;
    right_[copy] = at.x + shape.box.right;
    bottom_[copy] = at.y + shape.box.bottom;
    top_[copy] = at.y + shape.box.top;
}

void Lay::updateLosses(std::size_t copy) {
    for (std::size_t other = 0; other < count(); ++other) {
        double loss = 0;
        const bool areFixed = problem_->itemOf(copy).isFixed && problem_->itemOf(other).isFixed;
        if (other != copy && !areFixed && left_[other] < right_[copy] &&
            right_[other] > left_[copy] && bottom_[other] < top_[copy] &&
            top_[other] > bottom_[copy]) {
            const double dx = poses_[other].x - poses_[copy].x,
                         dy = poses_[other].y - poses_[copy].y;
            if (doCollide(*shapes_[copy], *shapes_[other], dx, dy)) {
                loss = collisionLoss(*shapes_[copy], *shapes_[other], dx, dy);
            }
        }
        lossOf(copy, other) = lossOf(other, copy) = loss;
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
    std::ranges::fill(weights_, 1.0);
}

void Lay::raiseWeights() {
    const double most = losses_.empty() ? 0 : *std::ranges::max_element(losses_);
    for (std::size_t k = 0; k < losses_.size(); ++k) {
        weights_[k] =
            losses_[k] > 0
                ? std::min(kMostWeight, weights_[k] * (kLeastGrowth + (kMostGrowth - kLeastGrowth) *
                                                                          losses_[k] / most))
                : std::max(1.0, weights_[k] * kFading);
    }
}

}  // namespace toile::nest
