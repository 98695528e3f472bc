// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/nest/separation.h"

#include <utility>

namespace toile::nest {
namespace {

constexpr double kGainOfAStrike = 0.98;

void shuffle(std::vector<std::size_t>& list, Random& random) {
    for (std::size_t k = list.size(); k > 1; --k) {
        std::swap(list[k - 1], list[random.below(k)]);
    }
}

}  // namespace

void Separation::begin(const std::vector<Pose>& poses, double length, const Patience& patience) {
    lay_.placeAll(poses, length);
    lay_.resetWeights();
    patience_ = patience;
    best_ = lay_.poses();
    leastLoss_ = strikeLoss_ = lay_.loss();
    passes_ = inVain_ = strikes_ = 0;
}

Separation::Outcome Separation::pass(Random& random, std::int64_t& evaluations,
                                     const Progress& progress) {
    std::vector<std::size_t> colliding;
    for (std::size_t copy = 0; copy < lay_.count(); ++copy) {
        if (!lay_.problem().itemOf(copy).isFixed && lay_.weightedLossOf(copy) > 0) {
            colliding.push_back(copy);
        }
    }
    shuffle(colliding, random);
    for (const std::size_t copy : colliding) {
        if (progress.isCancelled()) {
            return Outcome::Going;
        }
        if (lay_.weightedLossOf(copy) > 0) {
            findBetterPlace(lay_, copy, search_, random, evaluations);
        }
    }
    ++passes_;
    const double loss = lay_.loss();
    if (loss < leastLoss_ || loss == 0) {
        leastLoss_ = loss;
        best_ = lay_.poses();
        inVain_ = 0;
        if (loss == 0) {
            return Outcome::Separated;
        }
    } else if (++inVain_ >= patience_.passes) {
        strikes_ = leastLoss_ > kGainOfAStrike * strikeLoss_ ? strikes_ + 1 : 0;
        if (strikes_ >= patience_.strikes) {
            return Outcome::Failed;
        }
        strikeLoss_ = leastLoss_;
        inVain_ = 0;
        lay_.placeAll(best_, lay_.length());
    }
    lay_.raiseWeights();
    return Outcome::Going;
}

}  // namespace toile::nest
