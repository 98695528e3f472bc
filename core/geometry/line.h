// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <Eigen/Core>

namespace toile::geometry {

/// Arc lengths of the points of a polyline, from 0 on: one more than it has edges, so that on a
/// closed line the last is its first point again, a turn later. @param lengths  of its edges
template <class Lengths>
std::vector<double> arcOf(const Lengths& lengths) {
    std::vector<double> arc{0};
    arc.reserve(static_cast<std::size_t>(lengths.size()) + 1);
    for (const double length : lengths) {
        arc.push_back(arc.back() + length);
    }
    return arc;
}

/// A place on a polyline: an edge, and the share of it that lies before the place, in [0, 1].
struct EdgePlace {
    int edge = 0;
    double share = 0;
};

/// A measure along a polyline: ascending, usually arc lengths in mm. On a closed line places and
/// the numbers of points count on over any number of turns; on an open one places are clamped to
/// its ends. All functions are pure; searches are logarithmic. Immutable.
class Arc {
public:
    /// @param at  of each point; on a closed line also of its first point a turn later
    Arc(std::vector<double> at, bool isClosed);

    bool isClosed() const { return isClosed_; }
    int count() const { return edgeCount() + (isClosed_ ? 0 : 1); }
    int edgeCount() const { return static_cast<int>(at_.size()) - 1; }
    const std::vector<double>& values() const { return at_; }
    double operator[](int k) const { return at_[static_cast<std::size_t>(k)]; }
    double length() const { return at_.back() - at_.front(); }

    /// The same place on the first turn.
    double wrap(double place) const;
    /// The number of turns before a place. 0 on an open line.
    double turnsBefore(double place) const;
    /// Distance of two places along the line, by the shorter way round.
    double apart(double a, double b) const;
    EdgePlace edgePlace(double place) const;
    int edgeAt(double place) const { return edgePlace(place).edge; }
    /// The place of a point, counted on over turns.
    double placeOf(int point) const;
    /// The index of the first point after a place, counted on over turns; at the end of an open
    /// line the last point.
    int firstAfter(double place) const;
    /// The same place by another measure of the same points.
    double placeOn(const Arc& other, double place) const;

private:
    std::vector<double> at_;
    bool isClosed_;
};

/// A stretch of a line, from a place to a later one.
struct Interval {
    double low = 0, high = 0;

    double length() const { return high - low; }
};

struct CommonPart : Interval {
    double shift = 0;  ///< by how much the second interval was moved: -1, 0 or 1 turn
};
/// The parts that two stretches of a closed line have in common, measured as in the first. In order
/// of the shift.
/// @param turn  the line's length  Precondition: the stretches are at most one turn apart.
std::vector<CommonPart> commonParts(const Interval& a, const Interval& b, double turn);

/// A polyline, open or closed, with a measure along it: its own arc lengths, or those of another
/// line that it represents. Immutable.
template <int Dimensions>
class LineOf {
public:
    using Points = Eigen::Matrix<double, Eigen::Dynamic, Dimensions, Eigen::RowMajor>;
    using Point = Eigen::Matrix<double, 1, Dimensions>;

    /// Measured along itself. @param points  #n x 2 or 3, n >= 1, the first not repeated
    LineOf(Points points, bool isClosed);
    /// @param arc  as in `Arc`
    LineOf(Points points, std::vector<double> arc, bool isClosed);
    static LineOf closed(Points points) { return {std::move(points), true}; }
    static LineOf closed(Points points, std::vector<double> arc) {
        return {std::move(points), std::move(arc), true};
    }
    static LineOf open(Points points) { return {std::move(points), false}; }

    int count() const { return static_cast<int>(points_.rows()); }
    const Points& points() const { return points_; }
    const Arc& arc() const { return arc_; }
    bool isClosed() const { return arc_.isClosed(); }
    double length() const { return arc_.length(); }
    double wrap(double place) const { return arc_.wrap(place); }
    double apart(double a, double b) const { return arc_.apart(a, b); }
    int edgeAt(double place) const { return arc_.edgeAt(place); }
    double placeOf(int point) const { return arc_.placeOf(point); }
    int firstAfter(double place) const { return arc_.firstAfter(place); }
    /// The same place on another line with the same number of corresponding points.
    double placeOn(const LineOf& other, double place) const {
        return arc_.placeOn(other.arc_, place);
    }

    /// Counted on over turns.
    Point point(int k) const;
    Point pointAt(double place) const;
    /// The place closest to a point, the first of equals.  Cost: linear.
    double nearestPlace(const Point& point) const;
    /// By how much the line turns at a point, in radians; in the plane positive to the left.
    double turnAt(int k) const;
    /// The part from one place to a later one: its ends and the points between them.
    Points part(double from, double to) const;
    /// The length of that part.
    double lengthOf(double from, double to) const;

private:
    Points points_;
    Arc arc_;
};

using Line = LineOf<2>;
using SpaceLine = LineOf<3>;
extern template class LineOf<2>;
extern template class LineOf<3>;

}  // namespace toile::geometry
