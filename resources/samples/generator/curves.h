// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <utility>
#include <vector>

#include "vec.h"

namespace toile::samples {

inline constexpr double kPi = 3.14159265358979323846;

/// A curve in a flat layout, or in space, over the parameter range [0, 1].
using FlatCurve = std::function<Vec2(double)>;
using SpaceCurve = std::function<Vec3(double)>;

/// Degrees to radians.
inline double radians(double degrees) {
    return degrees * (kPi / 180.0);
}

/// Rises from 0 to 1 over [0, 1] with level ends; constant outside.
double smoothStep(double t);

/// Cubic Bezier polynomial of one coordinate.
double bezier(double a, double b, double c, double d, double t);

/// Straight flat curve from `a` to `b`.
FlatCurve line(Vec2 a, Vec2 b);

/// Flat cubic Bezier curve from `a` to `d` with handles `b` and `c`.
FlatCurve bezier(Vec2 a, Vec2 b, Vec2 c, Vec2 d);

/// A measure along the body, such as half a width over the height: a smooth curve through
/// (position, value) rows sorted by position that never overshoots them (Fritsch-Carlson slopes).
class Profile {
public:
    explicit Profile(std::vector<std::pair<double, double>> rows);

    /// Value at `position`; the first and last row hold outside the range.
    double operator()(double position) const;

    /// Slope at `position` by a central difference.
    double slope(double position) const;

private:
    std::vector<std::pair<double, double>> rows_;
    std::vector<double> slopes_;
};

/// Smooth curve through points that lie evenly along it (uniform Catmull-Rom). At fraction
/// k / (number of spans) it returns point k exactly.
class PointCurve {
public:
    enum class Ends { Open, Closed };

    /// A closed curve repeats its first point at the end of `points`.
    PointCurve(std::vector<Vec3> points, Ends ends);

    Vec3 operator()(double fraction) const;

    /// Length of the chain of chords, mm.
    double length() const;

private:
    Vec3 point(int index) const;

    std::vector<Vec3> points_;
    Ends ends_;
};

}  // namespace toile::samples
