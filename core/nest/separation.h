// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "core/base/progress.h"
#include "core/nest/better_place.h"

// For the sources of this folder only.
namespace toile::nest {

/// How long an attempt goes on.
struct Patience {
    int passes = 200;  ///< without a smaller loss, before a strike
    int strikes = 3;   ///< in a row that gained less than 2 %, before it fails
};

/// Takes the overlaps out of a lay by guided local search ([GVW25]), pass by pass.
class Separation {
public:
    enum class Outcome { Going, Separated, Failed };

    Separation(const Problem& problem, const std::vector<Pose>& poses, double length)
        : lay_(problem, poses, length) {}

    void begin(const std::vector<Pose>& poses, double length, const Patience& patience);
    /// Every copy that collides looks once for a better place.
    Outcome pass(Random& random, std::int64_t& evaluations, const Progress& progress);

    const Lay& lay() const { return lay_; }
    int passes() const { return passes_; }
    /// The state with the least loss so far.
    const std::vector<Pose>& best() const { return best_; }
    double leastLoss() const { return leastLoss_; }

private:
    Lay lay_;
    Patience patience_;
    PlaceSearch search_;
    std::vector<Pose> best_;
    double leastLoss_ = 0, strikeLoss_ = 0;
    int passes_ = 0, inVain_ = 0, strikes_ = 0;
};

}  // namespace toile::nest
