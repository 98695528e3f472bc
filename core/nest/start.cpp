// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/nest/start.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "core/base/units.h"
#include "core/nest/collision.h"

namespace toile::nest {
namespace {

constexpr int kTurnsTried = 8;            // of shapes that turn freely, to each side
constexpr double kApart = 1e-6;           // mm: more than rounding moves
constexpr std::size_t kMostRows = 60;     // that a copy is tried at
constexpr double kLeastStepShare = 1e-3;  // of the strip's width

struct Laid {
    const Shape* shape;
    double x, y;
    double right() const { return x + shape->box.right; }
};

/// Lays one after the other.
class FirstNest {
public:
    /// @param byBoxes  no box reaches into another: for shapes that meet in a way that only exact
    /// arithmetic sees
    FirstNest(const Problem& problem, bool byBoxes, const Progress& progress)
        : problem_(problem),
          progress_(progress),
          byBoxes_(byBoxes),
          poses_(problem.copies.size()),
          owned_(poses_.size()) {}

    Found lay() {
        std::vector<std::size_t> order(poses_.size());
        for (std::size_t copy = 0; copy < order.size(); ++copy) {
            order[copy] = copy;
        }
        std::ranges::stable_sort(
            order, [this](std::size_t a, std::size_t b) { return rankOf(a) > rankOf(b); });
        for (const std::size_t copy : order) {
            if (progress_.isCancelled()) {
                break;
            }
            poses_[copy] =
                problem_.itemOf(copy).isFixed ? problem_.copies[copy].start : bestPose(copy);
            add(copy);
        }
        double length = 0;
        for (const Laid& laid : laid_) {
            length = std::max(length, laid.right());
        }
        return {poses_, length};
    }

private:
    double rankOf(std::size_t copy) const {
        const Item& item = problem_.itemOf(copy);
        return item.isFixed ? HUGE_VAL : item.variants[0].shape.hullRoot;
    }

    void add(std::size_t copy) {
        const Shape& shape = shapeOf(problem_.itemOf(copy), poses_[copy], owned_[copy]);
        laid_.push_back({&shape, poses_[copy].x, poses_[copy].y});
    }

    /// Of all angles and rows the place that ends first, then lowest.
    Pose bestPose(std::size_t copy) {
        const Item& item = problem_.itemOf(copy);
        Pose best;
        double end = HUGE_VAL;
        const int turns = item.tolerance > 0 ? kTurnsTried : 0;
        for (std::size_t v = 0; v < item.variants.size(); ++v) {
            for (int k = -turns; k <= turns; ++k) {
                Pose pose{static_cast<int>(v), turns > 0 ? item.tolerance * k / turns : 0};
                Shape own;
                const Shape& shape = shapeOf(item, pose, own);
                if (!(shape.box.top - shape.box.bottom <= problem_.width())) {
                    continue;
                }
                for (const double bottom : rowsFor(shape)) {
                    if (progress_.isCancelled()) {
                        return best;
                    }
                    pose.y = bottom - shape.box.bottom;
                    moveBetween(shape.box.bottom, shape.box.top, problem_.low, problem_.high,
                                pose.y);
                    pose.x = leftmost(shape, pose.y, end);
                    if (pose.x + shape.box.right < end) {
                        end = pose.x + shape.box.right;
                        best = pose;
                    }
                }
            }
        }
        return end < HUGE_VAL ? best : upright(copy);
    }

    /// One whose only fitting turns are between those tried: at the finest steps, past all others.
    Pose upright(std::size_t copy) const {
        const Item& item = problem_.itemOf(copy);
        double right = problem_.low;
        for (const Laid& laid : laid_) {
            right = std::max(right, laid.right());
        }
        Pose best;
        double least = HUGE_VAL;
        for (std::size_t v = 0; v < item.variants.size(); ++v) {
            for (int k = -180; k <= 180; ++k) {
                Shape own;
                Pose pose{static_cast<int>(v), item.tolerance * k / 180};
                const Shape& shape = shapeOf(item, pose, own);
                if (const double height = shape.box.top - shape.box.bottom; height < least) {
                    least = height;
                    pose.x = right - shape.box.left + kApart;
                    pose.y = problem_.low - shape.box.bottom;
                    moveBetween(shape.box.bottom, shape.box.top, problem_.low, problem_.high,
                                pose.y);
                    best = pose;
                }
            }
        }
        return best;
    }

    /// Where it would lie on the edges or on, or under, the boxes of others.
    std::vector<double> rowsFor(const Shape& shape) const {
        const double height = shape.box.top - shape.box.bottom, most = problem_.high - height;
        std::set<double> rows{problem_.low, most};
        for (const Laid& laid : laid_) {
            rows.insert(laid.y + laid.shape->box.top);
            rows.insert(laid.y + laid.shape->box.bottom - height);
            rows.insert(laid.y + laid.shape->box.bottom);
        }
        std::vector<double> list;
        std::ranges::copy_if(rows, std::back_inserter(list),
                             [&](double y) { return y >= problem_.low && y <= most; });
        if (list.size() > kMostRows) {  // evenly chosen, with the edges
            for (std::size_t k = 0; k < kMostRows; ++k) {
                list[k] = list[k * (list.size() - 1) / (kMostRows - 1)];
            }
            list.resize(kMostRows);
        }
        return list;
    }

    /// As far left as it goes along a row, by way of the ends of the boxes that it hits.
    double leftmost(const Shape& shape, double y, double enough) const {
        double x = problem_.low - shape.box.left;
        moveBetween(shape.box.left, shape.box.right, problem_.low, HUGE_VAL, x);
        while (x + shape.box.right < enough) {
            double next = HUGE_VAL;
            for (const Laid& laid : laid_) {
                if (laid.right() > x + shape.box.left &&
                    laid.x + laid.shape->box.left < x + shape.box.right &&
                    doMeet(shape, *laid.shape, laid.x - x, laid.y - y)) {
                    next = std::min(next, laid.right() - shape.box.left + (byBoxes_ ? kApart : 0));
                }
            }
            if (next == HUGE_VAL) {
                return x;
            }
            const double tenth = x + std::max((shape.box.right - shape.box.left) / 10,
                                              kLeastStepShare * problem_.width());
            x = std::min(next, tenth) > x ? std::min(next, tenth) : std::nextafter(x, HUGE_VAL);
        }
        return HUGE_VAL;
    }

    bool doMeet(const Shape& a, const Shape& b, double dx, double dy) const {
        return byBoxes_ ? b.box.bottom + dy < a.box.top + kApart &&
                              b.box.top + dy > a.box.bottom - kApart
                        : doCollide(a, b, dx, dy);
    }

    const Problem& problem_;
    const Progress& progress_;
    bool byBoxes_;
    std::vector<Pose> poses_;
    std::vector<Shape> owned_;
    std::vector<Laid> laid_;
};

}  // namespace

Found firstNest(const Problem& problem, const Progress& progress) {
    const Found found = FirstNest(problem, false, progress).lay();
    return progress.isCancelled() || isValid(problem, found.poses, found.length)
               ? found
               : FirstNest(problem, true, progress).lay();
}

}  // namespace toile::nest
