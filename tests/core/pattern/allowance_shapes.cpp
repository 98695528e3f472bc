// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/core/pattern/allowance_shapes.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "core/geometry/segment.h"
#include "core/quality/outline_crossings.h"
#include "tests/core/support/generator.h"

namespace toile::test {
namespace {

using Eigen::RowVector2d;

constexpr double kTolerance = 1e-4;   // mm
constexpr double kCurveReach = 1.57;  // of allowances within a stretch, times the width
constexpr double kReach = 3.2;        // of corners, times the greater width: of the limit and one

std::vector<int> countedTo(Eigen::Index n) {
    std::vector<int> all(n);
    std::iota(all.begin(), all.end(), 0);
    return all;
}

bool isMirror(CornerRule rule) {
    return rule == CornerRule::MirrorFirst || rule == CornerRule::MirrorSecond;
}

CornerRule otherWay(CornerRule rule) {
    switch (rule) {
        case CornerRule::RightAngleFirst:
            return CornerRule::RightAngleSecond;
        case CornerRule::RightAngleSecond:
            return CornerRule::RightAngleFirst;
        case CornerRule::MirrorFirst:
            return CornerRule::MirrorSecond;
        case CornerRule::MirrorSecond:
            return CornerRule::MirrorFirst;
        default:
            return rule;
    }
}

/// About the origin, a radius for each of n directions.
Points2 star(int n, Generator& random) {
    const double size = std::exp(random.between(2, 6.5));  // 7 to 660 mm
    const int kind = random.whole(0, 3);                   // smooth, wavy, jagged, spikes
    const int waves = random.whole(2, 9);
    const double depth = random.between(0, 0.7);
    Points2 points(n, 2);
    for (int k = 0; k < n; ++k) {
        const double at = 2 * std::numbers::pi * (k + 0.4 * random.unit()) / n;
        double radius = size;
        if (kind == 1) {
            radius *= 1 + depth * std::sin(waves * at);
        } else if (kind == 2) {
            radius *= random.between(1 - depth, 1);
        } else if (kind == 3 && random.chance(0.1)) {
            radius *= random.between(0.05, 3);
        }
        points.row(k) = radius * RowVector2d((1 + 0.5 * depth) * std::cos(at), std::sin(at));
    }
    return points;
}

/// A band around a wavy line, with cusps: narrow places, slots and steep ends.
Points2 band(int n, Generator& random) {
    const int half = std::max(n / 2, 2);
    const double length = random.between(20, 800), width = random.between(1, 80);
    const double waves = random.between(0.2, 6), height = random.between(0, 90);
    Points2 points(2 * half, 2);
    for (int k = 0; k < half; ++k) {
        const double share = static_cast<double>(k) / (half - 1), x = length * share;
        const double wave = height * std::abs(std::sin(std::numbers::pi * waves * share));
        points.row(k) = RowVector2d(x, wave);
        points.row(2 * half - 1 - k) = RowVector2d(x, wave + width * random.between(0.1, 1));
    }
    return points;
}

}  // namespace

AllowanceCase randomAllowances(unsigned seed) {
    Generator random(seed);
    const int n = static_cast<int>(std::exp(random.between(std::log(3.0), std::log(301.0))));
    AllowanceCase shape;
    shape.seamLine = random.chance(0.6) ? star(n, random) : band(n, random);
    const int count = static_cast<int>(shape.seamLine.rows());
    const int stretches = random.whole(1, std::min(count, random.chance(0.7) ? 6 : 40));
    std::vector<int> starts = countedTo(count);
    for (int k = 0; k < stretches; ++k) {
        std::swap(starts[k], starts[random.whole(k, count - 1)]);
    }
    std::sort(starts.begin(), starts.begin() + stretches);
    for (int k = 0; k < stretches; ++k) {
        const double width = random.chance(0.15) ? 0 : random.between(0, 40);
        const bool typed = random.chance(0.4);
        shape.stretches.push_back(
            {starts[k], typed ? 10 : width, static_cast<CornerRule>(random.whole(0, 6))});
    }
    return moved(shape, random.between(0, 6), {random.between(-900, 900), 300});
}

AllowanceCase moved(AllowanceCase shape, double angle, const RowVector2d& by) {
    const Eigen::Rotation2Dd turn(angle);
    shape.seamLine = (shape.seamLine * turn.toRotationMatrix().transpose()).rowwise() + by;
    return shape;
}

AllowanceCase mirrored(const AllowanceCase& shape) {
    const int n = static_cast<int>(shape.seamLine.rows());
    const int count = static_cast<int>(shape.stretches.size());
    AllowanceCase image;
    image.seamLine = shape.seamLine.colwise().reverse();
    image.seamLine.col(0) *= -1;
    for (int k = 0; k < count; ++k) {
        // What ends in a corner begins there.
        const AllowanceStretch& corner = shape.stretches[(k + 1) % count];
        image.stretches.push_back(
            {n - 1 - corner.first, shape.stretches[k].width, otherWay(corner.corner)});
    }
    std::sort(image.stretches.begin(), image.stretches.end(),
              [](const auto& a, const auto& b) { return a.first < b.first; });
    return image;
}

NearestPlace nearestPlace(const RowVector2d& point, const Points2& line, int first, int last) {
    const int n = static_cast<int>(line.rows());
    NearestPlace nearest{std::numeric_limits<double>::infinity()};
    for (int k = first; k < last; ++k) {
        const RowVector2d a = line.row(k % n), b = line.row((k + 1) % n);
        const double share = geometry::nearestShare(point, a, b);
        const RowVector2d off = point - a - share * (b - a);
        if (off.norm() < nearest.distance) {
            nearest.distance = off.norm();
            const double before = share * (b - a).norm(), after = (1 - share) * (b - a).norm();
            nearest.atEnd =
                (k == first && before <= kTolerance) || (k + 1 == last && after <= kTolerance);
            const RowVector2d before_a = line.row((k + n - 1) % n), after_b = line.row((k + 2) % n);
            nearest.fromOutside = share == 0   ? geometry::cross(a - before_a, b - a) > 0
                                  : share == 1 ? geometry::cross(b - a, after_b - b) > 0
                                               : geometry::cross(b - a, off) < 0;
        }
    }
    return nearest;
}

double distanceTo(const RowVector2d& point, const Points2& closedLine) {
    return nearestPlace(point, closedLine, 0, static_cast<int>(closedLine.rows())).distance;
}

double outside(const RowVector2d& point, const Points2& closedLine) {
    bool inside = false;
    for (Eigen::Index k = 0; k < closedLine.rows(); ++k) {
        const RowVector2d a = closedLine.row(k), b = closedLine.row((k + 1) % closedLine.rows());
        if ((a.y() <= point.y()) != (b.y() <= point.y())) {
            const double side = geometry::cross(b - a, point - a);
            inside = inside != ((side > 0) == (b.y() > a.y()));
        }
    }
    return inside ? -distanceTo(point, closedLine) : distanceTo(point, closedLine);
}

double apart(const Points2& a, const Points2& b) {
    double largest = 0;
    for (const auto& point : a.rowwise()) {
        largest = std::max(largest, distanceTo(point, b));
    }
    for (const auto& point : b.rowwise()) {
        largest = std::max(largest, distanceTo(point, a));
    }
    return largest;
}

double areaOf(const Points2& closedLine) {
    double twice = 0;
    for (Eigen::Index k = 0; k < closedLine.rows(); ++k) {
        const RowVector2d a = closedLine.row(k) - closedLine.row(0);
        const RowVector2d b = closedLine.row((k + 1) % closedLine.rows()) - closedLine.row(0);
        twice += geometry::cross(a, b);
    }
    return twice / 2;
}

std::string troubleWith(const AllowanceCase& shape, const Points2& cut) {
    if (cut.rows() < 3 || !cut.allFinite() || !(areaOf(cut) > 0)) {
        return "no line, or the wrong way round";
    }
    if (!outlineIsSimple(cut, countedTo(cut.rows()))) {
        return "it crosses itself";
    }
    const Points2& seamLine = shape.seamLine;
    const int n = static_cast<int>(seamLine.rows());
    const int count = static_cast<int>(shape.stretches.size());
    for (Eigen::Index k = 0; k < n; ++k) {
        const RowVector2d middle = (seamLine.row(k) + seamLine.row((k + 1) % n)) / 2;
        if (outside(seamLine.row(k), cut) > kTolerance || outside(middle, cut) > kTolerance) {
            return "the seam line leaves it at " + std::to_string(k);
        }
    }
    for (Eigen::Index k = 0; k < 2 * cut.rows(); ++k) {
        const RowVector2d point =
            (cut.row(k / 2) + cut.row((k + 1) / 2 % cut.rows())) / 2;  // corners and middles
        if (outside(point, seamLine) < -kTolerance) {
            return "it runs inside the seam line at " + std::to_string(k);
        }
        bool reached = false;
        for (int s = 0; s < count; ++s) {
            const AllowanceStretch &stretch = shape.stretches[s],
                                   &next = shape.stretches[(s + 1) % count];
            const int last = next.first + (s + 1 < count ? 0 : n);
            const NearestPlace nearest = nearestPlace(point, seamLine, stretch.first, last);
            const bool cutBack = isMirror(stretch.corner) || isMirror(next.corner);
            if (!cutBack && !nearest.atEnd && nearest.fromOutside &&
                nearest.distance < stretch.width - kTolerance) {
                return "it runs inside the allowance of " + std::to_string(s) + " at " +
                       std::to_string(point.x()) + " " + std::to_string(point.y()) + " by " +
                       std::to_string(stretch.width - nearest.distance);
            }
            const double corner =
                std::max(stretch.width, shape.stretches[(s + count - 1) % count].width);
            reached = reached || nearest.distance <= kCurveReach * stretch.width + kTolerance ||
                      (point - seamLine.row(stretch.first)).norm() <= kReach * corner + kTolerance;
        }
        if (!reached) {
            return "it is too far out at " + std::to_string(k);
        }
    }
    return "";
}

}  // namespace toile::test
