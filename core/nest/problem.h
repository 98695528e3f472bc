// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "core/nest/nest.h"
#include "core/nest/shape.h"

// For the sources of this folder only.
namespace toile::nest {

/// Where a copy lies: which variant of its item, turned by so much more, then moved.
struct Pose {
    int variant = 0;
    double turn = 0;
    double x = 0, y = 0;
};

/// An item at one of its angles, mirrored or not.
struct Variant {
    double angle = 0;
    bool mirrored = false;
    Shape shape;
    double rest = 0;  ///< where it lies across the strip so that it touches the edge
};

struct Item {
    std::vector<Variant> variants;  ///< that fit the strip; at least one
    double tolerance = 0;           ///< of further turns
    bool isFixed = false, touchesEdge = false;
    std::optional<NestLattice> lattice;
    double leastExtent = 0;         ///< along the strip
    std::array<Shape, 2> unturned;  ///< as given and, where it is asked for, mirrored
    Rings grown;                    ///< by half the gap, as the search sees them
    Rings bare;                     ///< without the gap, as obstacles see them
};

struct Copy {
    int item = 0;
    Pose start{};  ///< of a fixed one
};

/// What copies may not lie on.
struct Obstacle {
    std::string name;
    Rings rings;  ///< grown by the border
    Shape shape;
    std::vector<bool> isFor;  ///< of items
};

/// Of the strip, from one band to the next: between which grown copies lie along it.
struct Stretch {
    double from = 0, to = 0;
};

/// What is searched: shapes grown by half the gap, in the strip without its border but for that
/// half, so that whatever does not overlap keeps gap and border.
struct Problem {
    std::vector<Item> items;
    std::vector<Copy> copies;
    std::vector<Obstacle> obstacles;
    std::vector<Stretch> stretches;  ///< one after the other; at least one
    double cloth = 0;                ///< its width
    double low = 0, high = 0;  ///< between which they lie across the strip, and from which along it
    double leastLength = 0;    ///< no nest ends before
    double area = 0;           ///< of the shapes as given

    double width() const { return high - low; }
    const Item& itemOf(std::size_t copy) const {
        return items[static_cast<std::size_t>(copies[copy].item)];
    }
};

/// The item's shape as it is turned there: kept in `own` where the pose has a turn of its own.
/// Turned once, as `placedRings` does, so that both have the same points.
const Shape& shapeOf(const Item& item, const Pose& pose, Shape& own);

/// Errors: as of Nester::make.
Result<Problem> makeProblem(const NestInstance& instance, const NestOptions& options,
                            const Progress& progress);

NestPlacement placementOf(const Problem& problem, std::size_t copy, const Pose& pose);

/// The copy's rings as they lie, grown by half the gap or bare.
Rings ringsAt(const Problem& problem, std::size_t copy, const Pose& pose, bool isBare = false);

/// The obstacle that a copy lies on there, by exact arithmetic; null: none.
const Obstacle* obstacleUnder(const Problem& problem, std::size_t copy, const Pose& pose);

/// Nothing overlaps and all is inside a strip that ends there, by exact arithmetic.
bool isValid(const Problem& problem, const std::vector<Pose>& poses, double length);

}  // namespace toile::nest
