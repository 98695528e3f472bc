// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/nest/better_place.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/units.h"

namespace toile::nest {
namespace {

constexpr std::size_t kRefined = 3;                // of the best places
constexpr double kGrowth = 1.1, kShrinking = 0.5;  // of the steps of a descent
/// First and last step of a descent, as shares of the box's smaller side; of turns, in radians.
struct Steps {
    double first, last, firstTurn, lastTurn;
};
constexpr Steps kCoarse{0.25, 0.02, 5 * kDegree, 1 * kDegree};
constexpr Steps kFine{0.01, 0.001, 0.5 * kDegree, 0.05 * kDegree};

struct Tried {
    Pose pose;
    double loss = HUGE_VAL;
};

/// The best few places, none of them next to another; those not yet found have no finite loss.
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

    /// Two steps opposite each other along a way chosen at random, again and again.
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
            // A slanting way changes both a little less.
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

}  // namespace

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

}  // namespace toile::nest
