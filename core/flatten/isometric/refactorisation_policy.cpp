// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/flatten/isometric/refactorisation_policy.h"

namespace toile::isometric {
namespace {

/// Single triangles stopped a step that is shorter than this part.
constexpr double kShortStep = 0.3;
/// A step with an old factorisation is tried if the first with the new one went this far.
constexpr double kGoodStep = 0.4;
/// The prediction was good if the actual fall is between this share of it and the inverse.
constexpr double kKeptShare = 0.5;
/// No progress: multiples of the tolerance, for one step and all of one factorisation.
constexpr double kOfOne = 2;
constexpr double kOfAll = 10;

constexpr std::size_t kKeptSteps = 4;
/// Minimum cosine between a step and its change of gradient for the step to be usable.
constexpr double kMinCosine = 1e-12;

}  // namespace

void RefactorisationPolicy::count(double part, double predicted, double fall, double renewingCost) {
    part_ = part;
    fall_ = fall;
    if (fresh_) {
        fallen_ = fall;
        spent_ = renewingCost;
        went_ = part >= kShortStep;
        fresh_ = part < kGoodStep;
    } else {
        fallen_ += fall;
        spent_ += 1;
        went_ = went_ || part >= kShortStep;
        const bool kept = fall > kKeptShare * predicted && fall < predicted / kKeptShare;
        fresh_ = part < kShortStep || (fall < fallen_ / spent_ && !kept);
    }
}

bool RefactorisationPolicy::hasArrived(double tolerance) const {
    return (!wasStopped() && fall_ <= kOfOne * tolerance) ||
           (fresh_ && went_ && fallen_ <= kOfAll * tolerance);
}

bool RefactorisationPolicy::wasStopped() const {
    return part_ < kShortStep;
}

void LbfgsHistory::add(Points2 moved, Points2 turned) {
    const double product = dot(moved, turned);
    if (!(product > kMinCosine * moved.norm() * turned.norm())) {
        return;
    }
    if (steps_.size() == kKeptSteps) {
        steps_.erase(steps_.begin());
    }
    steps_.push_back({std::move(moved), std::move(turned), product});
}

std::vector<double> LbfgsHistory::reduce(Points2& gradient) const {
    std::vector<double> taken(steps_.size());
    for (std::size_t k = steps_.size(); k-- > 0;) {
        taken[k] = dot(steps_[k].moved, gradient) / steps_[k].product;
        gradient -= taken[k] * steps_[k].turned;
    }
    return taken;
}

void LbfgsHistory::complete(const std::vector<double>& taken, Points2& step) const {
    for (std::size_t k = 0; k < steps_.size(); ++k) {
        const double has = dot(steps_[k].turned, step) / steps_[k].product;
        step -= (taken[k] + has) * steps_[k].moved;
    }
}

}  // namespace toile::isometric
