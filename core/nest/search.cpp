// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/nest/search.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <numeric>
#include <utility>

#include "core/base/units.h"

namespace toile::nest {
namespace {

constexpr std::size_t kRefined = 3;                // number of best places
constexpr double kGrowth = 1.1, kShrinking = 0.5;  // of the steps of a descent
/// First and last step of a descent, as shares of the box's smaller side; rotations in radians.
struct Steps {
    double first, last, firstTurn, lastTurn;
};
constexpr Steps kCoarse{0.25, 0.02, 5 * kDegree, 1 * kDegree};
constexpr Steps kFine{0.01, 0.001, 0.5 * kDegree, 0.05 * kDegree};

struct Tried {
    Pose pose;
    double loss = HUGE_VAL;
};

/// The best few places, none adjacent to another; unused entries have infinite loss.
class BestPlaces {
public:
    explicit BestPlaces(double apart) : apart_(apart) {}

    double enough() const { return places_.back().loss; }
    const Tried& best() const { return places_.front(); }
    void add(const Tried& tried) {
        if (!(tried.loss < enough())) {
            return;
        }
        const auto alike = std::ranges::find_if(places_, [&](const Tried& other) {
            return other.pose.variant == tried.pose.variant &&
                   std::abs(other.pose.x - tried.pose.x) < apart_ &&
                   std::abs(other.pose.y - tried.pose.y) < apart_ &&
                   std::abs(other.pose.turn - tried.pose.turn) < kDegree;
        });
        Tried& replaced = alike != places_.end() ? *alike : places_.back();
        if (tried.loss < replaced.loss) {
            replaced = tried;
            std::ranges::stable_sort(places_, {}, &Tried::loss);
        }
    }
    std::array<Tried, kRefined>& places() { return places_; }

private:
    double apart_;
    std::array<Tried, kRefined> places_;
};

class PlaceFinder {
public:
    PlaceFinder(const Lay& lay, std::size_t copy, Random& random, std::int64_t& evaluations)
        : lay_(lay),
          copy_(copy),
          item_(lay.problem().itemOf(copy)),
          random_(random),
          evaluations_(evaluations) {
        const Box& box = lay.shape(copy).box;
        side_ = std::min(box.right - box.left, box.top - box.bottom);
    }

    double side() const { return side_; }

    Pose randomPose() {
        Pose pose;
        pose.variant = static_cast<int>(random_.below(item_.variants.size()));
        pose.turn = item_.tolerance > 0 ? random_.between(-item_.tolerance, item_.tolerance) : 0;
        return pose;
    }

    Tried tryAnywhere(double enough) {
        Pose pose = randomPose();
        const Shape& shape = lay_.shapeOf(copy_, pose, own_);
        pose.x =
            random_.between(lay_.problem().low - shape.box.left, lay_.length() - shape.box.right);
        pose.y = random_.between(lay_.problem().low - shape.box.bottom,
                                 lay_.problem().high - shape.box.top);
        return evaluate(shape, pose, enough);
    }

    Tried tryAround(const Pose& present, double enough) {
        Pose pose = randomPose();
        if (item_.tolerance > 0 && random_.below(2) == 0) {
            pose.variant = present.variant;
            pose.turn = limited(present.turn + random_.between(-10, 10) * kDegree);
        }
        const Shape& shape = lay_.shapeOf(copy_, pose, own_);
        const Box& box = lay_.shape(copy_).box;
        const Box& turned = shape.box;
        const double halfWidth = (box.right - box.left) / 2,
                     halfHeight = (box.top - box.bottom) / 2;
        pose.x = present.x + (box.left + box.right - turned.left - turned.right) / 2 +
                 random_.between(-halfWidth, halfWidth);
        pose.y = present.y + (box.bottom + box.top - turned.bottom - turned.top) / 2 +
                 random_.between(-halfHeight, halfHeight);
        return evaluate(shape, pose, enough);
    }

    /// Tries two opposite steps in a random direction, repeatedly.
    void descend(Tried& best, const Steps& steps) {
        const bool turns = item_.tolerance > 0;
        double stepX = steps.first * side_, stepY = stepX, stepTurn = steps.firstTurn;
        const double last = steps.last * side_;
        while (best.loss > 0 &&
               (stepX >= last || stepY >= last || (turns && stepTurn >= steps.lastTurn))) {
            const std::size_t way = random_.below(turns ? 5 : 4);
            const double x = way == 1 || way == 4 ? 0 : stepX;
            const double y = way == 0 || way == 4 ? 0 : way == 3 ? -stepY : stepY;
            const double turned = way == 4 ? stepTurn : 0;
            bool isBetter = false;
            for (const int sign : {1, -1}) {
                const Pose& from = best.pose;
                const Pose pose{from.variant, limited(from.turn + sign * turned), from.x + sign * x,
                                from.y + sign * y};
                const Tried tried = evaluate(lay_.shapeOf(copy_, pose, own_), pose, best.loss);
                if (tried.loss < best.loss) {
                    best = tried;
                    isBetter = true;
                    break;
                }
            }
            const double factor = isBetter ? kGrowth : kShrinking;
            // A diagonal step changes both by a little less.
            const double both = isBetter ? 1.0488088481701516 : 0.7071067811865476;
            stepX *= x == 0 ? 1 : y == 0 ? factor : both;
            stepY *= y == 0 ? 1 : x == 0 ? factor : both;
            stepTurn *= turned == 0 ? 1 : factor;
        }
    }

private:
    double limited(double turned) const {
        return item_.tolerance < kPi ? std::clamp(turned, -item_.tolerance, item_.tolerance)
                                     : std::remainder(turned, 2 * kPi);
    }

    Tried evaluate(const Shape& shape, Pose pose, double enough) {
        ++evaluations_;
        if (!lay_.moveInside(copy_, shape, pose)) {
            return {pose, HUGE_VAL};
        }
        return {pose, lay_.lossAt(copy_, shape, pose.x, pose.y, enough)};
    }

    const Lay& lay_;
    std::size_t copy_;
    const Item& item_;
    Random& random_;
    std::int64_t& evaluations_;
    double side_ = 0;
    Shape own_;
};

constexpr double kGainOfAStrike = 0.98;

void shuffle(std::vector<std::size_t>& list, Random& random) {
    for (std::size_t k = list.size(); k > 1; --k) {
        std::swap(list[k - 1], list[random.below(k)]);
    }
}

constexpr double kFirstStep = 0.05, kMinStep = 0.001;
constexpr double kFirstSqueeze = 0.0005, kMinSqueeze = 0.00001, kSqueezeFading = 0.9;
constexpr double kShareOfLarge = 0.75;  // of the hulls' area
constexpr std::size_t kMaxFailed = 50;
constexpr Patience kHasty{15, 1}, kExploring{100, 3}, kCompressing{60, 2};
constexpr int kEasyPasses = 6;  // after so few passes try a longer step

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

/// Moves a copy to the best place found if that is better than the present one.
/// @param evaluations  counts the places tried
void findBetterPlace(Lay& lay, std::size_t copy, const PlaceSearch& search, Random& random,
                     std::int64_t& evaluations) {
    PlaceFinder finder(lay, copy, random, evaluations);
    BestPlaces best(finder.side() * 0.01);
    const Pose present = lay.pose(copy);
    const double before = lay.weightedLossOf(copy);
    best.add({present, before});
    for (int k = 0; k < search.around && best.best().loss > 0; ++k) {
        best.add(finder.tryAround(present, best.enough()));
    }
    for (int k = 0; k < search.anywhere && best.best().loss > 0; ++k) {
        best.add(finder.tryAnywhere(best.enough()));
    }
    Tried* found = &best.places().front();
    if (found->loss > 0) {
        for (Tried& tried : best.places()) {
            if (tried.loss < HUGE_VAL) {
                finder.descend(tried, kCoarse);
            }
        }
        found = &*std::ranges::min_element(best.places(), {}, &Tried::loss);
        finder.descend(*found, kFine);
    }
    if (found->loss < before) {
        lay.place(copy, found->pose);
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
    exploring_.begin(best_.poses, length, step_ > kMinStep ? kHasty : kExploring);
}

void Search::afterFailure() {
    isStuck_ = true;
    if (step_ > kMinStep) {
        step_ = std::max(kMinStep, step_ / 2);
        shrink();
        return;
    }
    FailedState state{exploring_.best(), exploring_.leastLoss()};
    failed_.insert(std::ranges::upper_bound(failed_, state.loss, {}, &FailedState::loss), state);
    failed_.resize(std::min(failed_.size(), kMaxFailed));
    const double share = random_.share();
    auto poses =
        failed_[static_cast<std::size_t>(share * share * static_cast<double>(failed_.size()))]
            .poses;
    disturb(poses);
    exploring_.begin(poses, exploring_.lay().length(), kExploring);
}

/// Swaps two large copies of different items.
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

/// Shortens the best nest a little at a random place.
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
        squeeze_ = isKept ? squeeze_ : std::max(kMinSqueeze, squeeze_ * kSqueezeFading);
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
    // Is the nest found by compressing shorter than the target of exploring?
    if (!(exploring_.lay().length() < best_.length)) {
        shrink();
    }
}

}  // namespace toile::nest
