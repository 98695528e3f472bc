// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/nest/make_item.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/base/units.h"
#include "core/nest/rules.h"

namespace toile {
namespace {

constexpr const char* kTooWide =
    translatable("it does not fit across a strip of %1 mm at any angle that it may have");
constexpr const char* kTooLong =
    translatable("it is longer than the cloth anywhere, at any angle that it may have");

}  // namespace
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

/// Whether a variant that turns no further has a place in an empty strip.
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

}  // namespace

Result<Item> makeItem(const Problem& problem, const NestItem& asked, Rings bare, Rings grown,
                      bool isBareToo) {
    Item item;
    item.bare = std::move(bare);
    item.grown = std::move(grown);
    item.isFixed = asked.fixed.has_value();
    item.touchesEdge = asked.touchesEdge;
    item.tolerance = asked.fixed || asked.touchesEdge ? 0 : std::min(asked.tolerance, kPi);
    item.lattice = asked.fixed ? std::nullopt : asked.lattice;
    item.leastExtent = HUGE_VAL;
    bool fitsAcross = false;
    for (const bool isMirrored : {false, true}) {
        if (asked.fixed ? asked.fixed->mirrored != isMirrored : isMirrored && !asked.mayMirror) {
            continue;
        }
        Shape& shape = item.unturned[isMirrored ? 1 : 0];
        shape = shapeOfItem(item, isMirrored, isBareToo);
        for (const double angle : asked.fixed ? std::vector{asked.fixed->angle} : asked.angles) {
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
            ErrorCode::PageTooSmall, Subject::piece(asked.name),
            fitsAcross ? Wording(worded(kTooLong)) : worded(kTooWide, {figure(problem.cloth, 1)})};
    }
    return item;
}

}  // namespace toile::nest
