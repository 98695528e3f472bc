// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "core/nest/separation.h"

// For the sources of this folder only.
namespace toile::nest {

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
