// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/flatten/isometric/step_memory.h"

#include <utility>

namespace toile {
namespace {

constexpr std::size_t kKeptSteps = 4;
/// Cosine between a step and its change of gradient from which on it tells something.
constexpr double kLeastCosine = 1e-12;

}  // namespace

void StepMemory::add(Points2 moved, Points2 turned) {
    const double product = dot(moved, turned);
    if (!(product > kLeastCosine * moved.norm() * turned.norm())) {
        return;
    }
    if (steps_.size() == kKeptSteps) {
        steps_.erase(steps_.begin());
    }
    steps_.push_back({std::move(moved), std::move(turned), product});
}

std::vector<double> StepMemory::reduce(Points2& gradient) const {
    std::vector<double> taken(steps_.size());
    for (std::size_t k = steps_.size(); k-- > 0;) {
        taken[k] = dot(steps_[k].moved, gradient) / steps_[k].product;
        gradient -= taken[k] * steps_[k].turned;
    }
    return taken;
}

void StepMemory::complete(const std::vector<double>& taken, Points2& step) const {
    for (std::size_t k = 0; k < steps_.size(); ++k) {
        const double has = dot(steps_[k].turned, step) / steps_[k].product;
        step -= (taken[k] + has) * steps_[k].moved;
    }
}

}  // namespace toile
