// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/core/nest/nest_shapes.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "core/base/units.h"
#include "core/geometry/segment.h"
#include "core/nest/collision.h"

namespace toile::test {
namespace {

double distanceOfRings(const nest::Rings& a, const nest::Rings& b) {
    double least = HUGE_VAL;
    const auto toSides = [&least](const nest::Rings& points, const nest::Rings& sides) {
        for (const auto& ring : points) {
            for (Eigen::Index p = 0; p < ring.rows(); ++p) {
                for (const auto& other : sides) {
                    for (Eigen::Index k = 0; k < other.rows(); ++k) {
                        const Eigen::Vector2d at = ring.row(p), from = other.row(k),
                                              to = other.row((k + 1) % other.rows());
                        least = std::min(least, geometry::distanceToSegment(at, from, to));
                    }
                }
            }
        }
    };
    toSides(a, b);
    toSides(b, a);
    return least;
}

bool isAllowedAngle(const NestItem& item, double angle) {
    return std::ranges::any_of(item.angles, [&](double allowed) {
        return std::abs(angle - allowed) <= item.tolerance + 1e-12;
    });
}

double areaOfRings(const nest::Rings& rings) {
    double area = 0;
    for (std::size_t k = 0; k < rings.size(); ++k) {
        area += (k == 0 ? 1 : -1) * std::abs(geometry::signedAreaOf(rings[k]));
    }
    return area;
}

}  // namespace

geometry::Polygon nestPolygon(std::initializer_list<std::pair<double, double>> points) {
    geometry::Polygon polygon(static_cast<Eigen::Index>(points.size()), 2);
    Eigen::Index row = 0;
    for (const auto& [x, y] : points) {
        polygon.row(row++) << x, y;
    }
    return polygon;
}

geometry::Polygon nestRectangle(double width, double height) {
    return nestPolygon({{0, 0}, {width, 0}, {width, height}, {0, height}});
}

NestItem nestItem(const std::string& name, const geometry::Polygon& outline, int demand) {
    NestItem item;
    item.name = name;
    item.rings = {outline};
    item.demand = demand;
    return item;
}

geometry::Polygon nestStar(nest::Random& random, int count, double least, double most) {
    geometry::Polygon star(count, 2);
    for (int k = 0; k < count; ++k) {
        const double angle = 2 * kPi * k / count, radius = random.between(least, most);
        star.row(k) << radius * std::cos(angle), radius * std::sin(angle);
    }
    return star;
}

namespace {

/// Where its point lies, by the lattice's steps.
void expectOnLattice(const NestItem& item, const NestPlacement& placement) {
    NestItem point;
    point.rings = {item.lattice->anchor.transpose()};
    const Eigen::Vector2d at = placedRings(point, placement)[0].row(0);
    for (const int axis : {0, 1}) {
        if (axis == 1 && item.touchesEdge) {
            continue;
        }
        const double off = at[axis] - item.lattice->phase[axis], step = item.lattice->step[axis];
        const double nearest = step == 0          ? off
                               : std::isinf(step) ? 0
                                                  : std::round(off / step) * step;
        EXPECT_NEAR(off, nearest, 2e-6) << item.name << ", axis " << axis;
    }
}

void expectKeepsOff(const NestInstance& instance, const NestOptions& options,
                    const NestPlacement& placement, const nest::Rings& placed) {
    for (const NestObstacle& obstacle : instance.obstacles) {
        if (obstacle.items.empty() || std::ranges::count(obstacle.items, placement.item) > 0) {
            EXPECT_FALSE(nest::doOverlap(nest::wound(obstacle.rings), placed)) << obstacle.name;
            EXPECT_GE(distanceOfRings(obstacle.rings, placed), options.border) << obstacle.name;
        }
    }
    for (const NestBand& band : instance.bands) {
        EXPECT_TRUE(placed[0].col(0).maxCoeff() <= band.from - options.border + 1e-9 ||
                    placed[0].col(0).minCoeff() >= band.to + options.border - 1e-9)
            << band.from;
    }
}

}  // namespace

void expectKeepsRules(const NestInstance& instance, const NestOptions& options,
                      const NestResult& result) {
    EXPECT_TRUE(result.valid);
    std::vector<int> copies(instance.items.size());
    std::vector<nest::Rings> placed;
    double area = 0, end = 0;
    for (const NestPlacement& placement : result.placements) {
        const NestItem& item = instance.items[static_cast<std::size_t>(placement.item)];
        ++copies[static_cast<std::size_t>(placement.item)];
        if (item.fixed) {
            EXPECT_EQ(placement, *item.fixed);
        } else {
            EXPECT_TRUE(isAllowedAngle(item, placement.angle)) << placement.angle;
            EXPECT_TRUE(item.mayMirror || !placement.mirrored);
            if (item.lattice) {
                expectOnLattice(item, placement);
            }
        }
        placed.push_back(nest::wound(placedRings(item, placement)));
        const auto& outline = placed.back()[0];
        EXPECT_GE(outline.col(0).minCoeff(), options.border);
        if (!item.touchesEdge) {
            EXPECT_GE(outline.col(1).minCoeff(), options.border);
        } else if (!item.fixed) {
            EXPECT_EQ(outline.col(1).minCoeff(), 0);
        }
        expectKeepsOff(instance, options, placement, placed.back());
        EXPECT_LE(outline.col(1).maxCoeff(), instance.width - options.border);
        EXPECT_LE(outline.col(0).maxCoeff(), result.length - options.border);
        end = std::max(end, outline.col(0).maxCoeff());
        area += areaOfRings(item.rings);
        for (std::size_t k = 0; k + 1 < placed.size(); ++k) {
            EXPECT_FALSE(nest::doOverlap(placed[k], placed.back()));
            if (options.gap > 0) {
                EXPECT_GE(distanceOfRings(placed[k], placed.back()), options.gap);
            }
        }
    }
    for (std::size_t i = 0; i < copies.size(); ++i) {
        EXPECT_EQ(copies[i], instance.items[i].demand) << instance.items[i].name;
    }
    for (const NestBand& band : instance.bands) {
        EXPECT_TRUE(result.length <= band.from + 1e-9 || result.length >= band.to);
    }
    EXPECT_NEAR(result.length, end + options.border, 0.01);
    EXPECT_NEAR(result.use, area / (instance.width * result.length), 1e-9);
}

}  // namespace toile::test
