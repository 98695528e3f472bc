// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/nest/problem.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>

#include "core/base/units.h"
#include "core/nest/exact_overlap.h"
#include "core/nest/item_rings.h"

namespace toile {
namespace {

constexpr const char* kNoStrip = translatable("width, gap and border leave no strip");
constexpr const char* kTooWide =
    translatable("it does not fit across a strip of %1 mm at any angle that it may have");
constexpr const char* kTooManyCopies =
    translatable("more than %1 copies are not laid at once: lay several markers, or fewer copies");
constexpr const char* kKeptOutside =
    translatable("it is kept where it lies, which is outside the strip");
constexpr const char* kKeptOnOther = translatable("it is kept where it lies, which is on %1");

}  // namespace
}  // namespace toile

namespace toile::nest {
namespace {

using geometry::Polygon;

constexpr int kMostCopies = 4000;

Rings mirrored(const Rings& rings) {
    Rings turned = rings;
    for (Polygon& ring : turned) {
        ring.col(0) *= -1;
        ring = Polygon(ring.colwise().reverse());
    }
    return turned;
}

constexpr double kBetweenSteps = 0.01;  // of the diameter: by how much sides at most differ

/// How small box sides can be at a variant's further turns, looked at in steps.
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

/// The variants that fit across the strip; none where none does.
Item makeItem(const NestItem& asked, const Rings& rings, double width) {
    Item item;
    item.grown = rings;
    item.tolerance = asked.fixed ? 0 : std::min(asked.tolerance, kPi);
    item.isFixed = asked.fixed.has_value();
    item.leastExtent = HUGE_VAL;
    for (const bool isMirrored : {false, true}) {
        if (asked.fixed ? asked.fixed->mirrored != isMirrored : isMirrored && !asked.mayMirror) {
            continue;
        }
        Shape& shape = item.unturned[isMirrored ? 1 : 0];
        shape = makeShape(isMirrored ? mirrored(rings) : rings);
        for (const double angle : asked.fixed ? std::vector{asked.fixed->angle} : asked.angles) {
            Variant variant{angle, isMirrored, {}};
            turn(shape, angle, variant.shape);
            const LeastSides sides = leastSides(variant.shape, item.tolerance);
            if (sides.across <= width) {
                const double between =
                    item.tolerance > 0 ? kBetweenSteps * variant.shape.diameter : 0;
                item.leastExtent = std::min(item.leastExtent, sides.along - between);
                item.variants.push_back(std::move(variant));
            }
        }
    }
    return item;
}

Rings ringsAt(const Problem& problem, std::size_t copy, const Pose& pose) {
    NestItem item;
    item.rings = problem.itemOf(copy).grown;
    return wound(placedRings(item, placementOf(problem, copy, pose)));
}

/// Of the copy added last: it lies outside, or on another fixed one.
std::optional<Error> wrongInFixed(const Problem& problem, const NestInstance& instance) {
    const auto askedOf = [&](std::size_t copy) -> const NestItem& {
        return instance.items[static_cast<std::size_t>(problem.copies[copy].item)];
    };
    const std::size_t last = problem.copies.size() - 1;
    const Rings own = ringsAt(problem, last, problem.copies[last].start);
    if (own[0].minCoeff() < problem.low || own[0].col(1).maxCoeff() > problem.high) {
        return wrongItem(askedOf(last), kKeptOutside);
    }
    for (std::size_t copy = 0; copy < last; ++copy) {
        if (problem.itemOf(copy).isFixed &&
            doOverlap(own, ringsAt(problem, copy, problem.copies[copy].start))) {
            return wrongItem(askedOf(last), worded(kKeptOnOther, {askedOf(copy).name}));
        }
    }
    return std::nullopt;
}

}  // namespace

bool moveBetween(double least, double most, double from, double to, double& at) {
    if (!(most - least <= to - from)) {
        return false;
    }
    at = std::clamp(at, from - least, std::max(from - least, to - most));
    while (at + least < from) {
        at = std::nextafter(at, HUGE_VAL);
    }
    while (at + most > to) {
        at = std::nextafter(at, -HUGE_VAL);
    }
    return true;
}

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

bool isValid(const Problem& problem, const std::vector<Pose>& poses, double length) {
    std::vector<Rings> placed;
    for (std::size_t c = 0; c < poses.size(); ++c) {
        placed.push_back(ringsAt(problem, c, poses[c]));
        const Polygon& outline = placed.back()[0];
        if (outline.minCoeff() < problem.low || outline.col(0).maxCoeff() > length ||
            outline.col(1).maxCoeff() > problem.high) {
            return false;
        }
        for (std::size_t d = 0; d < c; ++d) {
            if (doOverlap(placed[d], placed[c])) {
                return false;
            }
        }
    }
    return true;
}

Result<Problem> makeProblem(const NestInstance& instance, const NestOptions& options,
                            const Progress& progress) {
    Problem problem;
    problem.low = options.border - options.gap / 2;
    problem.high = instance.width - problem.low;
    if (!(instance.width > 0 && instance.width <= kMostSize && options.gap >= 0 &&
          options.border >= 0 && options.gap <= kMostSize && problem.width() > 0)) {
        return Error{ErrorCode::PageTooSmall, Subject::file(instance.name), kNoStrip};
    }
    std::int64_t copies = 0;
    for (const NestItem& asked : instance.items) {
        copies += std::max(asked.demand, 0);
    }
    if (copies > kMostCopies) {
        return Error{ErrorCode::MalformedFile, Subject::file(instance.name),
                     worded(kTooManyCopies, {figure(kMostCopies, 0)})};
    }
    double grownArea = 0;
    for (std::size_t i = 0; i < instance.items.size(); ++i) {
        const NestItem& asked = instance.items[i];
        if (progress.isCancelled()) {
            return Error{ErrorCode::Cancelled};
        }
        if (asked.demand == 0) {
            problem.items.emplace_back();
            continue;
        }
        const auto rings = usableRings(asked);
        if (!rings) {
            return rings.error();
        }
        const auto larger = grownRings(asked, *rings, options.gap / 2);
        if (!larger) {
            return larger.error();
        }
        Item item = makeItem(asked, *larger, problem.width());
        if (item.variants.empty()) {
            return Error{ErrorCode::PageTooSmall, Subject::piece(asked.name),
                         worded(kTooWide, {figure(instance.width, 1)})};
        }
        const Shape& shape = item.variants[0].shape;
        double area = 0;
        for (const Polygon& ring : *rings) {
            area += geometry::signedAreaOf(ring);
        }
        problem.area += area * asked.demand;
        grownArea += shape.area * asked.demand;
        Copy copy{static_cast<int>(i)};
        if (asked.fixed) {
            copy.start = {0, 0, asked.fixed->x, asked.fixed->y};
            item.leastExtent = copy.start.x + shape.box.right - problem.low;
        }
        problem.leastLength = std::max(problem.leastLength, item.leastExtent);
        problem.items.push_back(std::move(item));
        problem.copies.insert(problem.copies.end(), static_cast<std::size_t>(asked.demand), copy);
        if (auto fault = asked.fixed ? wrongInFixed(problem, instance) : std::nullopt) {
            return *std::move(fault);
        }
    }
    problem.leastLength = problem.low + std::max(problem.leastLength, grownArea / problem.width());
    return problem;
}

}  // namespace toile::nest
