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

/// The pose of a copy: the variant of its item, an additional rotation, then a translation.
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
    double rest = 0;  ///< position across the strip so that it touches the edge
};

struct Item {
    std::vector<Variant> variants;  ///< those that fit the strip; at least one
    double tolerance = 0;           ///< of further turns
    bool isFixed = false, touchesEdge = false;
    std::optional<NestLattice> lattice;
    double leastExtent = 0;         ///< along the strip
    std::array<Shape, 2> unturned;  ///< as given and, if requested, mirrored
    Rings grown;                    ///< offset by half the gap, for the search
    Rings bare;                     ///< without the gap, for obstacles
};

struct Copy {
    int item = 0;
    Pose start{};  ///< of a fixed copy
};

/// An area that copies must avoid.
struct Obstacle {
    std::string name;
    Rings rings;  ///< offset by the border
    Shape shape;
    std::vector<bool> isFor;  ///< per item
};

/// A range of the strip between two bands: limits of offset copies along it.
struct Stretch {
    double from = 0, to = 0;
};

/// The search problem: shapes offset by half the gap, in the strip less its border plus that half,
/// so that copies that do not overlap keep gap and border.
struct Problem {
    std::vector<Item> items;
    std::vector<Copy> copies;
    std::vector<Obstacle> obstacles;
    std::vector<Stretch> stretches;  ///< one after the other; at least one
    double cloth = 0;                ///< its width
    double low = 0, high = 0;        ///< limits across the strip, and start along it
    double leastLength = 0;          ///< lower bound of the length of any nest
    double area = 0;                 ///< of the shapes as given

    double width() const { return high - low; }
    const Item& itemOf(std::size_t copy) const {
        return items[static_cast<std::size_t>(copies[copy].item)];
    }
};

/// The item's shape in this rotation: stored in `own` if the pose has a rotation of its own.
/// Rotated once, like `placedRings`, so that both have the same points.
const Shape& shapeOf(const Item& item, const Pose& pose, Shape& own);

/// Errors: as of Nester::make.
Result<Problem> makeProblem(const NestInstance& instance, const NestOptions& options,
                            const Progress& progress);

NestPlacement placementOf(const Problem& problem, std::size_t copy, const Pose& pose);

/// The copy's rings as placed, offset by half the gap or bare.
Rings ringsAt(const Problem& problem, std::size_t copy, const Pose& pose, bool isBare = false);

/// The obstacle that the copy overlaps there, by exact arithmetic; null: none.
const Obstacle* obstacleUnder(const Problem& problem, std::size_t copy, const Pose& pose);

/// Whether nothing overlaps and all is inside a strip of this length, by exact arithmetic.
bool isValid(const Problem& problem, const std::vector<Pose>& poses, double length);

}  // namespace toile::nest
