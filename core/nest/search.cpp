// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/nest/search.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numeric>
#include <utility>

namespace toile::nest {
namespace {

constexpr double kFirstStep = 0.05, kLeastStep = 0.001;
constexpr double kFirstSqueeze = 0.0005, kLeastSqueeze = 0.00001, kSqueezeFading = 0.9;
constexpr double kShareOfLarge = 0.75;  // of the hulls' area
constexpr std::size_t kMostFailed = 50;
constexpr Patience kHasty{15, 1}, kExploring{100, 3}, kCompressing{60, 2};
constexpr int kEasyPasses = 6;  // after so few a longer step is tried

std::vector<std::size_t> largeCopies(const Problem& problem) {
    std::vector<std::size_t> copies;
    double all = 0;
    const auto hullOf = [&problem](std::size_t copy) {
        const double root = problem.itemOf(copy).variants[0].shape.hullRoot;
        return root * root;
    };
    for (std::size_t copy = 0; copy < problem.copies.size(); ++copy) {
        if (!problem.itemOf(copy).isFixed) {
            copies.push_back(copy);
            all += hullOf(copy);
        }
    }
    std::ranges::stable_sort(copies, std::ranges::greater{}, hullOf);
    double sum = 0;
    std::size_t count = 0;
    while (count < copies.size() && sum < kShareOfLarge * all) {
        sum += hullOf(copies[count++]);
    }
    copies.resize(count);
    return copies;
}

}  // namespace

Search::Search(const Problem& problem, const Found& start, Random random)
    : problem_(&problem),
      best_(start),
      random_(random),
      large_(largeCopies(problem)),
      exploring_(problem, start.poses, start.length),
      compressing_(problem, start.poses, start.length),
      step_(kFirstStep),
      squeeze_(kFirstSqueeze) {
    shrink();
}

void Search::adopt(const Found& found) {
    if (found.length < best_.length) {
        best_ = found;
        compresses_ = false;
        if (!(exploring_.lay().length() < found.length)) {
            shrink();
        }
    }
}

bool Search::keep(const Lay& lay) {
    const double length = lay.usedLength();
    if (!(length < best_.length) || !isValid(*problem_, lay.poses(), length)) {
        return false;
    }
    best_ = {lay.poses(), length};
    return true;
}

void Search::shrink() {
    failed_.clear();
    const double length = std::max(best_.length * (1 - step_), problem_->leastLength);
    exploring_.begin(best_.poses, length, step_ > kLeastStep ? kHasty : kExploring);
}

void Search::afterFailure() {
    isStuck_ = true;
    if (step_ > kLeastStep) {
        step_ = std::max(kLeastStep, step_ / 2);
        shrink();
        return;
    }
    FailedState state{exploring_.best(), exploring_.leastLoss()};
    failed_.insert(std::ranges::upper_bound(failed_, state.loss, {}, &FailedState::loss), state);
    failed_.resize(std::min(failed_.size(), kMostFailed));
    const double share = random_.share();
    auto poses =
        failed_[static_cast<std::size_t>(share * share * static_cast<double>(failed_.size()))]
            .poses;
    disturb(poses);
    exploring_.begin(poses, exploring_.lay().length(), kExploring);
}

/// Two large copies of different items change places.
void Search::disturb(std::vector<Pose>& poses) {
    if (large_.empty()) {
        return;
    }
    const std::size_t a = large_[random_.below(large_.size())];
    std::vector<std::size_t> others;
    std::ranges::copy_if(large_, std::back_inserter(others), [&](std::size_t b) {
        return problem_->copies[b].item != problem_->copies[a].item;
    });
    if (!others.empty()) {
        swapTwo(poses, a, others[random_.below(others.size())]);
    } else {
        poses[a].x = random_.between(0, exploring_.lay().length());
        poses[a].y = random_.between(0, problem_->high);
    }
}

void Search::swapTwo(std::vector<Pose>& poses, std::size_t a, std::size_t b) {
    const auto middleOf = [&](std::size_t copy) {
        Shape own;
        const Box& box = exploring_.lay().shapeOf(copy, poses[copy], own).box;
        return std::pair(poses[copy].x + (box.left + box.right) / 2,
                         poses[copy].y + (box.bottom + box.top) / 2);
    };
    const auto [ax, ay] = middleOf(a);
    const auto [bx, by] = middleOf(b);
    poses[a].x += bx - ax;
    poses[a].y += by - ay;
    poses[b].x += ax - bx;
    poses[b].y += ay - by;
}

/// Cuts a little out of the best nest at a place chosen at random.
void Search::beginCompression() {
    const double length = std::max(best_.length * (1 - squeeze_), problem_->leastLength);
    const double at = random_.between(0, best_.length);
    auto poses = best_.poses;
    for (std::size_t copy = 0; copy < poses.size(); ++copy) {
        Shape own;
        const Box& box = compressing_.lay().shapeOf(copy, poses[copy], own).box;
        if (!problem_->itemOf(copy).isFixed && poses[copy].x + (box.left + box.right) / 2 > at) {
            poses[copy].x -= best_.length - length;
        }
    }
    compressing_.begin(poses, length, kCompressing);
    compresses_ = true;
}

void Search::explorePass(const Progress& progress) {
    const auto outcome = exploring_.pass(random_, evaluations_, progress);
    if (outcome == Separation::Outcome::Separated) {
        if (keep(exploring_.lay())) {
            compresses_ = false;
        }
        squeeze_ = kFirstSqueeze;
        isStuck_ = false;
        step_ = exploring_.passes() <= kEasyPasses ? std::min(kFirstStep, step_ * 1.5) : step_;
        shrink();
    } else if (outcome == Separation::Outcome::Failed) {
        afterFailure();
    }
}

void Search::compressPass(const Progress& progress) {
    if (!compresses_) {
        beginCompression();
    }
    const auto outcome = compressing_.pass(random_, evaluations_, progress);
    if (outcome != Separation::Outcome::Going) {
        const bool isKept = outcome == Separation::Outcome::Separated && keep(compressing_.lay());
        squeeze_ = isKept ? squeeze_ : std::max(kLeastSqueeze, squeeze_ * kSqueezeFading);
        beginCompression();
    }
}

void Search::run(std::int64_t evaluations, bool mayCompress, const Progress& progress) {
    const bool compresses = mayCompress && isStuck_;
    for (const std::int64_t end = evaluations_ + evaluations;
         evaluations_ < end && !progress.isCancelled();) {
        if (!(best_.length > problem_->leastLength)) {
            return;
        }
        const std::int64_t before = evaluations_;
        compresses ? compressPass(progress) : explorePass(progress);
        evaluations_ += evaluations_ == before ? 1 : 0;
    }
    if (!compresses) {
        return;
    }
    // What was found by compressing is shorter than what exploring was after?
    if (!(exploring_.lay().length() < best_.length)) {
        shrink();
    }
}

}  // namespace toile::nest
