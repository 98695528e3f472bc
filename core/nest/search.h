// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "core/base/progress.h"
#include "core/nest/lay.h"
#include "core/nest/random.h"

// For the sources of this folder only.
namespace toile::nest {

/// How many places a copy tries before the best are refined by coordinate descent ([GVW25]).
struct PlaceSearch {
    int anywhere = 50;  ///< places tried in the whole strip
    int around = 25;    ///< and within the current box
};

/// Limits of an attempt.
struct Patience {
    int passes = 200;  ///< without a smaller loss, before a strike
    int strikes = 3;   ///< consecutive ones that gained less than 2 %, before it fails
};

/// Removes the overlaps of a layout by guided local search ([GVW25]), pass by pass.
class Separation {
public:
    enum class Outcome { Going, Separated, Failed };

    Separation(const Problem& problem, const std::vector<Pose>& poses, double length)
        : lay_(problem, poses, length) {}

    void begin(const std::vector<Pose>& poses, double length, const Patience& patience);
    /// Each colliding copy searches once for a better place.
    Outcome pass(Random& random, std::int64_t& evaluations, const Progress& progress);

    const Lay& lay() const { return lay_; }
    int passes() const { return passes_; }
    /// The state with the smallest loss so far.
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

/// A nest without overlaps.
struct Found {
    std::vector<Pose> poses;
    double length = 0;  ///< where the last copy ends
};

/// One of the parallel searches: explores ever shorter strips, and compresses its best nest if that
/// has not helped for a while ([GVW25]).
class Search {
public:
    Search(const Problem& problem, const Found& start, Random random);

    const Found& best() const { return best_; }
    /// Continues from this nest, unless it already targets a shorter one.
    void adopt(const Found& found);
    /// Searches for this many evaluations, plus at most the rest of a pass.
    /// @param mayCompress  allowed in this round
    void run(std::int64_t evaluations, bool mayCompress, const Progress& progress);

private:
    struct FailedState {
        std::vector<Pose> poses;
        double loss;
    };

    bool keep(const Lay& lay);
    void shrink();
    void afterFailure();
    void disturb(std::vector<Pose>& poses);
    void swapTwo(std::vector<Pose>& poses, std::size_t a, std::size_t b);
    void beginCompression();
    void explorePass(const Progress& progress);
    void compressPass(const Progress& progress);

    const Problem* problem_;
    Found best_;
    Random random_;
    std::vector<std::size_t> large_;  ///< copies that make up most of the hulls' area
    Separation exploring_, compressing_;
    std::vector<FailedState> failed_;  ///< at the current length, smallest loss first
    double step_;                      ///< share by which the strip is shortened next
    double squeeze_;                   ///< the same when compressing
    bool isStuck_ = false;             ///< the last attempt to explore failed
    bool compresses_ = false;          ///< has started compressing, from the current best
    std::int64_t evaluations_ = 0;
};

}  // namespace toile::nest
