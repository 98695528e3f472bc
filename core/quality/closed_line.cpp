// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/quality/closed_line.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "core/geometry/segment.h"

namespace toile {
namespace {

/// An end nearer to a point than this part of the line is that point.
constexpr double kAtPoint = 1e-12;

std::vector<double> arcOf(const Points2& points) {
    std::vector<double> arc(static_cast<std::size_t>(points.rows()) + 1, 0);
    for (Eigen::Index k = 0; k < points.rows(); ++k) {
        arc[k + 1] = arc[k] + (points.row((k + 1) % points.rows()) - points.row(k)).norm();
    }
    return arc;
}

}  // namespace

ClosedLine::ClosedLine(Points2 points) : points_(std::move(points)), arc_(arcOf(points_)) {}

ClosedLine::ClosedLine(Points2 points, std::vector<double> arc)
    : points_(std::move(points)), arc_(std::move(arc)) {}

double ClosedLine::wrap(double at) const {
    const double within = at - std::floor((at - arc_.front()) / length()) * length();
    return within < arc_.back() ? within : arc_.front();
}

double ClosedLine::apart(double a, double b) const {
    const double way = std::abs(wrap(a) - wrap(b));
    return std::min(way, length() - way);
}

int ClosedLine::edgeAt(double at) const {
    const auto next = std::upper_bound(arc_.begin(), arc_.end(), wrap(at));
    return std::clamp(static_cast<int>(next - arc_.begin()) - 1, 0, count() - 1);
}

Eigen::RowVector2d ClosedLine::pointAt(double at) const {
    const int k = edgeAt(at);
    const double edge = arc_[k + 1] - arc_[k];
    const double t = edge > 0 ? (wrap(at) - arc_[k]) / edge : 0;
    return (1 - t) * points_.row(k) + t * points_.row((k + 1) % count());
}

double ClosedLine::nearestPlace(const Eigen::RowVector2d& point) const {
    double nearest = arc_.front(), least = std::numeric_limits<double>::infinity();
    for (int k = 0; k < count(); ++k) {
        const Eigen::RowVector2d a = points_.row(k), b = points_.row((k + 1) % count());
        const double t = geometry::nearestShare(point, a, b);
        const double distance = (a + t * (b - a) - point).squaredNorm();
        if (distance < least) {
            least = distance;
            nearest = (1 - t) * arc_[k] + t * arc_[k + 1];
        }
    }
    return nearest;
}

double ClosedLine::placeOn(const ClosedLine& other, double at) const {
    const double turns = std::floor((at - arc_.front()) / length());
    const double within = at - turns * length();
    const int k = edgeAt(within);
    const double edge = arc_[k + 1] - arc_[k];
    const double t = edge > 0 ? (within - arc_[k]) / edge : 0;
    return turns * other.length() + (1 - t) * other.arc()[k] + t * other.arc()[k + 1];
}

double ClosedLine::turnAt(int k) const {
    const int n = count();
    const Eigen::RowVector2d here = points_.row(k);
    return geometry::turnBetween(here - points_.row((k + n - 1) % n),
                                 points_.row((k + 1) % n) - here);
}

int ClosedLine::after(double at) const {
    const auto turns = static_cast<int>(std::floor((at - arc_.front()) / length()));
    return turns * count() + edgeAt(at) + 1;
}

Points2 ClosedLine::part(double from, double to) const {
    const double same = kAtPoint * length();
    std::vector<int> between;
    for (int k = after(from + same); k < after(to - same); ++k) {
        between.push_back(((k % count()) + count()) % count());
    }
    Points2 part(static_cast<Eigen::Index>(between.size()) + 2, 2);
    part.row(0) = pointAt(from);
    for (std::size_t i = 0; i < between.size(); ++i) {
        part.row(static_cast<Eigen::Index>(i) + 1) = points_.row(between[i]);
    }
    part.bottomRows<1>() = pointAt(to);
    return part;
}

double ClosedLine::lengthOf(double from, double to) const {
    const Points2 line = part(from, to);
    return (line.bottomRows(line.rows() - 1) - line.topRows(line.rows() - 1))
        .rowwise()
        .norm()
        .sum();
}

}  // namespace toile
