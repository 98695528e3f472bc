// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/geometry/line.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "core/geometry/segment.h"

namespace toile::geometry {
namespace {

/// An end closer to a point than this fraction of the line coincides with it.
constexpr double kAtPoint = 1e-12;

template <class Points>
std::vector<double> arcAlong(const Points& points, bool isClosed) {
    const Eigen::Index n = points.rows();
    std::vector<double> arc(static_cast<std::size_t>(n) + (isClosed ? 1 : 0), 0);
    for (std::size_t k = 0; k + 1 < arc.size(); ++k) {
        const auto row = static_cast<Eigen::Index>(k);
        arc[k + 1] = arc[k] + (points.row((row + 1) % n) - points.row(row)).norm();
    }
    return arc;
}

}  // namespace

Arc::Arc(std::vector<double> at, bool isClosed) : at_(std::move(at)), isClosed_(isClosed) {}

double Arc::turnsBefore(double place) const {
    return isClosed_ && length() > 0 ? std::floor((place - at_.front()) / length()) : 0;
}

double Arc::wrap(double place) const {
    if (!isClosed_) {
        return std::clamp(place, at_.front(), at_.back());
    }
    const double within = place - turnsBefore(place) * length();
    return within < at_.back() ? within : at_.front();
}

double Arc::apart(double a, double b) const {
    const double way = std::abs(wrap(a) - wrap(b));
    return isClosed_ ? std::min(way, length() - way) : way;
}

EdgePlace Arc::edgePlace(double place) const {
    if (edgeCount() < 1) {
        return {};
    }
    const double within = wrap(place);
    const auto next = std::upper_bound(at_.begin() + 1, at_.end() - 1, within);
    const double edge = *next - *(next - 1);
    return {static_cast<int>(next - at_.begin()) - 1,
            edge > 0 ? std::clamp((within - *(next - 1)) / edge, 0.0, 1.0) : 0};
}

double Arc::placeOf(int point) const {
    const int n = count(), turns = isClosed_ ? (point - ((point % n) + n) % n) / n : 0;
    return at_[static_cast<std::size_t>(point - turns * n)] + turns * length();
}

int Arc::firstAfter(double place) const {
    return static_cast<int>(turnsBefore(place)) * count() + edgeAt(place) + 1;
}

double Arc::placeOn(const Arc& other, double place) const {
    const auto [edge, share] = edgePlace(place);
    return turnsBefore(place) * other.length() + (1 - share) * other[edge] +
           share * other[edge + 1];
}

std::vector<CommonPart> commonParts(const Interval& a, const Interval& b, double turn) {
    std::vector<CommonPart> parts;
    for (const double shift : {-turn, 0.0, turn}) {
        const double low = std::max(a.low, b.low + shift);
        const double high = std::min(a.high, b.high + shift);
        if (low < high) {
            parts.push_back({{low, high}, shift});
        }
    }
    return parts;
}

template <int Dimensions>
LineOf<Dimensions>::LineOf(Points points, bool isClosed)
    : points_(std::move(points)), arc_(arcAlong(points_, isClosed), isClosed) {}

template <int Dimensions>
LineOf<Dimensions>::LineOf(Points points, std::vector<double> arc, bool isClosed)
    : points_(std::move(points)), arc_(std::move(arc), isClosed) {}

template <int Dimensions>
auto LineOf<Dimensions>::point(int k) const -> Point {
    return points_.row(isClosed() ? ((k % count()) + count()) % count() : k);
}

template <int Dimensions>
auto LineOf<Dimensions>::pointAt(double place) const -> Point {
    const auto [edge, share] = arc_.edgePlace(place);
    const int next = edge + 1 < count() ? edge + 1 : 0;
    return (1 - share) * points_.row(edge) + share * points_.row(next);
}

template <int Dimensions>
double LineOf<Dimensions>::nearestPlace(const Point& point) const {
    double nearest = arc_[0], least = std::numeric_limits<double>::infinity();
    for (int k = 0; k < arc_.edgeCount(); ++k) {
        const Point a = points_.row(k), b = points_.row((k + 1) % count());
        const double t = nearestShare(point, a, b);
        const double distance = (a + t * (b - a) - point).squaredNorm();
        if (distance < least) {
            least = distance;
            nearest = (1 - t) * arc_[k] + t * arc_[k + 1];
        }
    }
    return nearest;
}

template <int Dimensions>
double LineOf<Dimensions>::turnAt(int k) const {
    const Point here = point(k), in = here - point(k - 1), out = point(k + 1) - here;
    if constexpr (Dimensions == 2) {
        return turnBetween(in, out);
    } else {
        return angleBetween(in, out);
    }
}

template <int Dimensions>
auto LineOf<Dimensions>::part(double from, double to) const -> Points {
    const double same = kAtPoint * length();
    const int first = firstAfter(from + same);
    const int between = std::max(0, firstAfter(to - same) - first);
    Points part(between + 2, Dimensions);
    part.row(0) = pointAt(from);
    for (int i = 0; i < between; ++i) {
        part.row(i + 1) = point(first + i);
    }
    part.row(between + 1) = pointAt(to);
    return part;
}

template <int Dimensions>
double LineOf<Dimensions>::lengthOf(double from, double to) const {
    const Points line = part(from, to);
    return (line.bottomRows(line.rows() - 1) - line.topRows(line.rows() - 1))
        .rowwise()
        .norm()
        .sum();
}

template class LineOf<2>;
template class LineOf<3>;

}  // namespace toile::geometry
