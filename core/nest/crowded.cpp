// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/nest/crowded.h"

#include <cmath>

namespace toile::nest {
namespace {

constexpr Patience kCrowded{60, 2};
constexpr std::int64_t kMostEvaluations = 200'000;

}  // namespace

std::optional<Found> crowdedNest(const Problem& problem, const std::vector<Pose>& poses,
                                 const Progress& progress) {
    const double end = problem.stretches.back().to;
    if (!std::isfinite(end) || !(problem.leastLength < end)) {
        return std::nullopt;
    }
    Random random(1);
    Separation separation(problem, poses, end);
    separation.begin(poses, end, kCrowded);
    auto outcome = Separation::Outcome::Going;
    for (std::int64_t evaluations = 0; outcome == Separation::Outcome::Going &&
                                       evaluations < kMostEvaluations && !progress.isCancelled();
         ++evaluations) {
        outcome = separation.pass(random, evaluations, progress);
    }
    const Found found{separation.lay().poses(), separation.lay().usedLength()};
    return outcome == Separation::Outcome::Separated && isValid(problem, found.poses, found.length)
               ? std::optional(found)
               : std::nullopt;
}

}  // namespace toile::nest
