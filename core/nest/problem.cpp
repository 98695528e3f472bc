// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/nest/problem.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <utility>

#include "core/base/units.h"
#include "core/nest/item_rings.h"
#include "core/nest/rules.h"

namespace toile::nest {

NestPlacement placementOf(const Problem& problem, std::size_t copy, const Pose& pose) {
    const Variant& variant = problem.itemOf(copy).variants[static_cast<std::size_t>(pose.variant)];
    return {problem.copies[copy].item, variant.angle + pose.turn, variant.mirrored, pose.x, pose.y};
}

const Shape& shapeOf(const Item& item, const Pose& pose, Shape& own) {
    const Variant& variant = item.variants[static_cast<std::size_t>(pose.variant)];
    if (pose.turn == 0) {
        return variant.shape;
    }
    turn(item.unturned[variant.mirrored ? 1 : 0], variant.angle + pose.turn, own);
    return own;
}

Rings ringsAt(const Problem& problem, std::size_t copy, const Pose& pose, bool isBare) {
    NestItem item;
    item.rings = isBare ? problem.itemOf(copy).bare : problem.itemOf(copy).grown;
    return wound(placedRings(item, placementOf(problem, copy, pose)));
}

const Obstacle* obstacleUnder(const Problem& problem, std::size_t copy, const Pose& pose) {
    if (problem.obstacles.empty()) {
        return nullptr;
    }
    const Rings own = ringsAt(problem, copy, pose, true);
    const auto item = static_cast<std::size_t>(problem.copies[copy].item);
    const auto under = std::ranges::find_if(problem.obstacles, [&](const Obstacle& obstacle) {
        return obstacle.isFor[item] && doOverlap(own, obstacle.rings);
    });
    return under == problem.obstacles.end() ? nullptr : &*under;
}

bool isValid(const Problem& problem, const std::vector<Pose>& poses, double length) {
    struct Placed {
        Rings rings;
        double left, bottom, right, top;
    };
    std::vector<Placed> placed;
    for (std::size_t c = 0; c < poses.size(); ++c) {
        Rings rings = ringsAt(problem, c, poses[c]);
        if (!keepsRules(problem, problem.itemOf(c), poses[c], rings[0], length) ||
            obstacleUnder(problem, c, poses[c])) {
            return false;
        }
        const Eigen::RowVector2d low = rings[0].colwise().minCoeff();
        const Eigen::RowVector2d high = rings[0].colwise().maxCoeff();
        placed.push_back({std::move(rings), low.x(), low.y(), high.x(), high.y()});
    }
    for (auto a = placed.begin(); a != placed.end(); ++a) {
        for (auto b = placed.begin(); b != a; ++b) {
            if (b->left < a->right && b->right > a->left && b->bottom < a->top &&
                b->top > a->bottom && doOverlap(b->rings, a->rings)) {
                return false;
            }
        }
    }
    return true;
}

}  // namespace toile::nest

namespace toile {
namespace {

constexpr const char* kTooWide =
    translatable("it does not fit across a strip of %1 mm at any allowed angle");
constexpr const char* kTooLong = translatable("it is longer than the cloth at every allowed angle");

constexpr const char* kNoStrip = translatable("the gap and border leave no room on this width");
constexpr const char* kTooManyCopies =
    translatable("a marker holds at most %1 copies; make several markers, or use fewer copies");
constexpr const char* kKeptOutside = translatable("its fixed place is outside the cloth");
constexpr const char* kKeptOnOther = translatable("its fixed place overlaps %1");
constexpr int kMaxCopiesOfProblem = 4000;
constexpr const char* kNoBand = translatable("an excluded band ends before it begins");

}  // namespace

std::optional<Error> wrongCopies(const std::string& name, std::int64_t copies) {
    return copies > kMaxCopiesOfProblem
               ? std::optional(Error{ErrorCode::MalformedFile, Subject::file(name),
                                     worded(kTooManyCopies, {figure(kMaxCopiesOfProblem, 0)})})
               : std::nullopt;
}

}  // namespace toile

namespace toile::nest {
namespace {

using geometry::Polygon;

Rings mirrored(const Rings& rings) {
    Rings turned = rings;
    for (Polygon& ring : turned) {
        ring.col(0) *= -1;
        ring = Polygon(ring.colwise().reverse());
    }
    return turned;
}

constexpr double kBetweenSteps = 0.01;  // of the diameter: largest difference of sides

/// The smallest box sides over a variant's further rotations, sampled in steps.
struct LeastSides {
    double along = HUGE_VAL, across = HUGE_VAL;
};
LeastSides leastSides(const Shape& shape, double tolerance) {
    constexpr int kSteps = 180;
    LeastSides least;
    Shape turned;
    const double most = std::min(tolerance, kPi);
    for (int k = -kSteps; k <= kSteps; k += tolerance > 0 ? 1 : 2 * kSteps) {
        const double angle = tolerance > 0 ? most * k / kSteps : 0;
        turn(shape, angle, turned);
        least.along = std::min(least.along, turned.box.right - turned.box.left);
        least.across = std::min(least.across, turned.box.top - turned.box.bottom);
    }
    return least;
}

/// Whether a variant without further rotation fits in an empty strip.
bool hasPlace(const Problem& problem, const Item& item, const Variant& variant) {
    Item alone;
    alone.lattice = item.lattice;
    alone.touchesEdge = item.touchesEdge;
    alone.variants = {variant};
    Pose pose;
    return moveInside(problem, alone, variant.shape, HUGE_VAL, pose);
}

Shape shapeOfItem(const Item& item, bool isMirrored, bool isBareToo) {
    Shape shape = makeShape(isMirrored ? mirrored(item.grown) : item.grown);
    if (isBareToo) {
        shape.bare.push_back(makeShape(isMirrored ? mirrored(item.bare) : item.bare));
    }
    return shape;
}

/// The variants of an item that fit the strip; slow because of their circles.
/// @param bare, grown  its rings, and its rings offset by half the gap
/// @param isBareToo  also prepare the shapes without the gap
/// Errors: PageTooSmall naming an item that fits at none of its angles.
Result<Item> makeItem(const Problem& problem, const NestItem& requested, Rings bare, Rings grown,
                      bool isBareToo) {
    Item item;
    item.bare = std::move(bare);
    item.grown = std::move(grown);
    item.isFixed = requested.fixed.has_value();
    item.touchesEdge = requested.touchesEdge;
    item.tolerance =
        requested.fixed || requested.touchesEdge ? 0 : std::min(requested.tolerance, kPi);
    item.lattice = requested.fixed ? std::nullopt : requested.lattice;
    item.leastExtent = HUGE_VAL;
    bool fitsAcross = false;
    for (const bool isMirrored : {false, true}) {
        if (requested.fixed ? requested.fixed->mirrored != isMirrored
                            : isMirrored && !requested.mayMirror) {
            continue;
        }
        Shape& shape = item.unturned[isMirrored ? 1 : 0];
        shape = shapeOfItem(item, isMirrored, isBareToo);
        for (const double angle :
             requested.fixed ? std::vector{requested.fixed->angle} : requested.angles) {
            Variant variant{angle, isMirrored, {}};
            turn(shape, angle, variant.shape);
            const NestItem lain{{}, item.bare};
            variant.rest = -placedRings(lain, {0, angle, isMirrored, 0, 0})[0].col(1).minCoeff();
            const LeastSides sides = leastSides(variant.shape, item.tolerance);
            const double width = item.touchesEdge
                                     ? problem.high - (variant.rest + variant.shape.box.bottom)
                                     : problem.width();
            if (!item.isFixed && !(sides.across <= width)) {
                continue;
            }
            fitsAcross = true;
            if (item.isFixed || item.tolerance > 0 || hasPlace(problem, item, variant)) {
                const double between =
                    item.tolerance > 0 ? kBetweenSteps * variant.shape.diameter : 0;
                item.leastExtent = std::min(item.leastExtent, sides.along - between);
                item.variants.push_back(std::move(variant));
            }
        }
    }
    if (item.variants.empty()) {
        return Error{
            ErrorCode::PageTooSmall, Subject::piece(requested.name),
            fitsAcross ? Wording(worded(kTooLong)) : worded(kTooWide, {figure(problem.cloth, 1)})};
    }
    return item;
}

/// For the copy added last: it lies outside, or on another fixed one.
std::optional<Error> wrongInFixed(const Problem& problem, const NestInstance& instance) {
    const auto requestOf = [&](std::size_t copy) -> const NestItem& {
        return instance.items[static_cast<std::size_t>(problem.copies[copy].item)];
    };
    const std::size_t last = problem.copies.size() - 1;
    const Pose& pose = problem.copies[last].start;
    const Rings own = ringsAt(problem, last, pose);
    if (!keepsRules(problem, problem.itemOf(last), pose, own[0], HUGE_VAL)) {
        return wrongItem(requestOf(last), kKeptOutside);
    }
    if (const Obstacle* under = obstacleUnder(problem, last, pose)) {
        return wrongItem(requestOf(last), worded(kKeptOnOther, {under->name}));
    }
    for (std::size_t copy = 0; copy < last; ++copy) {
        if (problem.itemOf(copy).isFixed &&
            doOverlap(own, ringsAt(problem, copy, problem.copies[copy].start))) {
            return wrongItem(requestOf(last), worded(kKeptOnOther, {requestOf(copy).name}));
        }
    }
    return std::nullopt;
}

double areaOf(const Rings& rings) {
    double area = 0;
    for (const Polygon& ring : rings) {
        area += geometry::signedAreaOf(ring);
    }
    return area;
}

/// The end of shapes that fill the stretches from the first on, with this total length.
double endOfArea(const Problem& problem, double length) {
    for (const Stretch& stretch : problem.stretches) {
        if (length <= stretch.to - stretch.from) {
            return stretch.from + length;
        }
        length -= stretch.to - stretch.from;
    }
    return problem.stretches.back().to;
}

/// The stretches that the bands leave free.
std::optional<Error> addStretches(Problem& problem, const NestInstance& instance) {
    auto bands = instance.bands;
    if (!std::ranges::all_of(bands, [](const NestBand& band) {
            return std::abs(band.from) <= kMaxSize && band.to >= band.from;
        })) {
        return Error{ErrorCode::MalformedFile, Subject::file(instance.name), kNoBand};
    }
    std::ranges::sort(bands, {}, &NestBand::from);
    double from = 0;
    const auto add = [&](double end) {
        if (const Stretch stretch{from + problem.low, end - problem.low};
            stretch.from < stretch.to) {
            problem.stretches.push_back(stretch);
        }
    };
    for (const NestBand& band : bands) {
        if (band.from > from) {
            add(band.from);
        }
        from = std::max(from, band.to);
    }
    add(HUGE_VAL);
    if (problem.stretches.empty()) {
        return Error{ErrorCode::PageTooSmall, Subject::file(instance.name), kNoStrip};
    }
    return std::nullopt;
}

std::optional<Error> addObstacles(Problem& problem, const NestInstance& instance, double border) {
    constexpr std::size_t kCirclesOfAll = 1000;
    const std::size_t circles = std::clamp<std::size_t>(
        kCirclesOfAll / std::max<std::size_t>(instance.obstacles.size(), 1), 1, kMaxCircles);
    for (const NestObstacle& requested : instance.obstacles) {
        const Subject subject = Subject::piece(requested.name);
        const auto rings = usableRings(subject, requested.rings);
        if (!rings) {
            return rings.error();
        }
        auto grown = grownRings(subject, *rings, requested.apart.value_or(border));
        if (!grown) {
            return grown.error();
        }
        Obstacle obstacle{requested.name, std::move(*grown), {}, {}};
        obstacle.shape = makeShape(obstacle.rings, circles);
        obstacle.isFor.assign(instance.items.size(), requested.items.empty());
        for (const int item : requested.items) {
            if (item >= 0 && item < static_cast<int>(obstacle.isFor.size())) {
                obstacle.isFor[static_cast<std::size_t>(item)] = true;
            }
        }
        problem.obstacles.push_back(std::move(obstacle));
    }
    return std::nullopt;
}

}  // namespace

Result<Problem> makeProblem(const NestInstance& instance, const NestOptions& options,
                            const Progress& progress) {
    Problem problem;
    problem.cloth = instance.width;
    problem.low = options.border - options.gap / 2;
    problem.high = instance.width - problem.low;
    if (!(instance.width > 0 && instance.width <= kMaxSize && options.gap >= 0 &&
          options.border >= 0 && options.gap <= kMaxSize && problem.width() > 0)) {
        return Error{ErrorCode::PageTooSmall, Subject::file(instance.name), kNoStrip};
    }
    std::int64_t copies = 0;
    for (const NestItem& requested : instance.items) {
        copies += std::max(requested.demand, 0);
    }
    if (auto fault = wrongCopies(instance.name, copies)) {
        return *std::move(fault);
    }
    if (auto fault = addStretches(problem, instance)) {
        return *std::move(fault);
    }
    if (auto fault = addObstacles(problem, instance, options.border)) {
        return *std::move(fault);
    }
    const bool isBareToo = options.gap > 0 && !problem.obstacles.empty();
    double grownArea = 0, lowest = problem.low;
    for (std::size_t i = 0; i < instance.items.size(); ++i) {
        const NestItem& requested = instance.items[i];
        if (progress.isCancelled()) {
            return Error{ErrorCode::Cancelled};
        }
        if (requested.demand == 0) {
            problem.items.emplace_back();
            continue;
        }
        const auto rings = usableRings(requested);
        if (!rings) {
            return rings.error();
        }
        auto grown = grownRings(Subject::piece(requested.name), *rings, options.gap / 2);
        if (!grown) {
            return grown.error();
        }
        auto item = makeItem(problem, requested, *rings, std::move(*grown), isBareToo);
        if (!item) {
            return item.error();
        }
        problem.area += areaOf(item->bare) * requested.demand;
        grownArea += areaOf(item->grown) * requested.demand;
        Copy copy{static_cast<int>(i)};
        for (const Variant& variant : item->variants) {
            const double least = variant.rest + variant.shape.box.bottom;
            lowest = item->touchesEdge ? std::min(lowest, least) : lowest;
        }
        if (requested.fixed) {
            copy.start = {0, 0, requested.fixed->x, requested.fixed->y};
            item->leastExtent = copy.start.x + item->variants[0].shape.box.right - problem.low;
        }
        problem.leastLength = std::max(problem.leastLength, item->leastExtent);
        problem.items.push_back(std::move(*item));
        problem.copies.insert(problem.copies.end(), static_cast<std::size_t>(requested.demand),
                              copy);
        if (auto fault = requested.fixed ? wrongInFixed(problem, instance) : std::nullopt) {
            return *std::move(fault);
        }
    }
    problem.leastLength = std::max(problem.low + problem.leastLength,
                                   endOfArea(problem, grownArea / (problem.high - lowest)));
    return problem;
}

}  // namespace toile::nest
