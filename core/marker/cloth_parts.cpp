// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/marker/cloth_parts.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace toile::cloth {
namespace {

using geometry::Polygon;

constexpr double kBetweenParts = 50;  // mm
constexpr double kBeyondHide = 10;    // mm: margin of a hide's surroundings beyond its box
constexpr double kMaxAlong = 9e6;     // mm: largest coordinate of a nest with all its parts

Polygon movedAlong(Polygon line, double x) {
    line.col(0).array() += x;
    return line;
}

Polygon rectangleOf(double left, double bottom, double right, double top) {
    Polygon rectangle(4, 2);
    rectangle << left, bottom, right, bottom, right, top, left, top;
    return rectangle;
}

bool isRectangle(const ClothPart& part) {
    const Eigen::RowVector2d low = part.outline.colwise().minCoeff();
    const Eigen::RowVector2d high = part.outline.colwise().maxCoeff();
    return part.outline.rows() == 4 &&
           std::abs(geometry::signedAreaOf(part.outline)) == (high - low).prod();
}

}  // namespace

std::vector<ClothPart> clothParts(const MarkerSettings& settings, std::size_t copies) {
    std::vector<ClothPart> parts;
    double x = 0;
    for (const auto& hide : settings.hides) {
        const Eigen::RowVector2d low = hide->outline.colwise().minCoeff();
        const auto moved = [&](const Polygon& line) -> Polygon {
            return movedAlong(line.rowwise() - low, x);
        };
        ClothPart part{moved(hide->outline)};
        for (const HideZone& zone : hide->zones) {
            part.zones.push_back({moved(zone.outline), zone.grade});
        }
        x = part.outline.col(0).maxCoeff() + kBetweenParts;
        parts.push_back(std::move(part));
    }
    for (std::size_t k = 0; settings.hides.empty() && settings.sheet && k < copies; ++k) {
        const double along = settings.sheet->x();
        if (k > 0 && x + along > kMaxAlong) {
            break;
        }
        parts.push_back({rectangleOf(x, 0, x + along, settings.sheet->y())});
        x += along + kBetweenParts;
    }
    return parts;
}

double widthOnCloth(const MarkerSettings& settings, const Fabric& fabric) {
    if (!settings.hides.empty()) {
        double width = 0;
        for (const auto& hide : settings.hides) {
            width =
                std::max(width, hide->outline.col(1).maxCoeff() - hide->outline.col(1).minCoeff());
        }
        return width;
    }
    return settings.sheet ? settings.sheet->y()
                          : (settings.width > 0 ? settings.width : fabric.width) *
                                (settings.isFolded ? 0.5 : 1);
}

void addParts(const std::vector<ClothPart>& parts, const std::vector<int>& grades,
              NestInstance& instance) {
    for (std::size_t k = 0; k < parts.size(); ++k) {
        const Polygon& outline = parts[k].outline;
        const double left = outline.col(0).minCoeff(), right = outline.col(0).maxCoeff();
        instance.bands.push_back({right, k + 1 < parts.size()
                                             ? parts[k + 1].outline.col(0).minCoeff()
                                             : std::numeric_limits<double>::infinity()});
        // A sheet narrower than the widest leaves a strip that is not cloth.
        if (!isRectangle(parts[k]) || outline.col(1).maxCoeff() < instance.width) {
            const double top = std::max(instance.width, outline.col(1).maxCoeff());
            instance.obstacles.push_back({"the edge of the hide",
                                          {rectangleOf(left - kBeyondHide, -kBeyondHide,
                                                       right + kBeyondHide, top + kBeyondHide),
                                           outline},
                                          {}});
        }
        for (const HideZone& zone : parts[k].zones) {
            NestObstacle obstacle{"a zone of the hide", {zone.outline}, {}};
            for (std::size_t i = 0; zone.grade > 0 && i < grades.size(); ++i) {
                if (grades[i] > 0 && grades[i] < zone.grade) {
                    obstacle.items.push_back(static_cast<int>(i));
                }
            }
            if (zone.grade == 0 || !obstacle.items.empty()) {
                instance.obstacles.push_back(std::move(obstacle));
            }
        }
    }
}

int partAt(const std::vector<ClothPart>& parts, double x) {
    int found = 0;
    for (std::size_t k = 1; k < parts.size(); ++k) {
        found = parts[k].outline.col(0).minCoeff() <= x ? static_cast<int>(k) : found;
    }
    return found;
}

double areaOf(const ClothPart& part) {
    double area = std::abs(geometry::signedAreaOf(part.outline));
    for (const HideZone& zone : part.zones) {
        area -= zone.grade == 0 ? std::abs(geometry::signedAreaOf(zone.outline)) : 0;
    }
    return area;
}

void measureOn(const std::vector<ClothPart>& parts, const Pattern& pattern, ClothMarker& marker) {
    double area = 0;
    int last = -1;
    for (LaidCopy& copy : marker.copies) {
        const Polygon line = laidOutline(pattern, copy);
        copy.sheet = partAt(parts, line.col(0).minCoeff());
        last = std::max(last, copy.sheet);
        area += std::abs(geometry::signedAreaOf(line));
        marker.length = std::max(marker.length, line.col(0).maxCoeff());
    }
    marker.parts.assign(parts.begin(), parts.begin() + (parts.empty() ? 0 : last + 1));
    marker.sheets = last + 1;
    if (parts.empty()) {
        marker.parts = {{rectangleOf(0, 0, marker.length, marker.width)}};
    }
    marker.clothArea = 0;
    for (const ClothPart& part : marker.parts) {
        marker.clothArea += areaOf(part);
    }
    marker.use = marker.clothArea > 0 ? area / marker.clothArea : 0;
}

}  // namespace toile::cloth
