// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "core/base/progress.h"
#include "core/nest/lay.h"
#include "core/nest/random.h"

// For the sources of this folder only.
namespace toile::nest {

/// How wide a copy looks, before the best places are refined by descent along one way after the
/// other, for a better place ([GVW25]).
struct PlaceSearch {
    int anywhere = 50;  ///< places tried in the whole strip
    int around = 25;    ///< and within the present box
};

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

/// A nest without overlaps.
struct Found {
    std::vector<Pose> poses;
    double length = 0;  ///< where the last copy ends
};

/// One of the searches that go on side by side: explores ever shorter strips, and compresses its
/// best nest where that has not helped for a while ([GVW25]).
class Search {
public:
    Search(const Problem& problem, const Found& start, Random random);

    const Found& best() const { return best_; }
    /// Goes on from this nest, unless it is after a shorter one already.
    void adopt(const Found& found);
    /// So much search; the rest of a pass at most longer.
    /// @param mayCompress  in this round
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
    std::vector<FailedState> failed_;  ///< at the present length, least loss first
    double step_;                      ///< by which a strip is shortened next, as a share
    double squeeze_;                   ///< the same when compressing
    bool isStuck_ = false;             ///< the last attempt to explore failed
    bool compresses_ = false;          ///< has begun to, from the best as it is
    std::int64_t evaluations_ = 0;
};

}  // namespace toile::nest
