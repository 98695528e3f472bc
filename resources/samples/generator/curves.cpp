// SPDX-License-Identifier: GPL-3.0-or-later
#include "curves.h"

#include <algorithm>

namespace toile::samples {

double smoothStep(double t) {
    const double s = std::clamp(t, 0.0, 1.0);
    return s * s * (3.0 - 2.0 * s);
}

double bezier(double a, double b, double c, double d, double t) {
    const double s = 1.0 - t;
    return s * s * s * a + 3.0 * s * s * t * b + 3.0 * s * t * t * c + t * t * t * d;
}

FlatCurve line(Vec2 a, Vec2 b) {
    return [=](double t) { return (1.0 - t) * a + t * b; };
}

FlatCurve bezier(Vec2 a, Vec2 b, Vec2 c, Vec2 d) {
    return [=](double t) {
        return Vec2{bezier(a.x, b.x, c.x, d.x, t), bezier(a.y, b.y, c.y, d.y, t)};
    };
}

Profile::Profile(std::vector<std::pair<double, double>> rows)
    : rows_(std::move(rows)), slopes_(rows_.size(), 0.0) {
    const std::size_t last = rows_.size() - 1;
    auto secant = [this](std::size_t k) {
        return (rows_[k + 1].second - rows_[k].second) / (rows_[k + 1].first - rows_[k].first);
    };
    if (last == 0) {
        return;
    }
    slopes_[0] = secant(0);
    slopes_[last] = secant(last - 1);
    for (std::size_t k = 1; k < last; ++k) {
        const double before = secant(k - 1);
        const double after = secant(k);
        const double h0 = rows_[k].first - rows_[k - 1].first;
        const double h1 = rows_[k + 1].first - rows_[k].first;
        // The weighted harmonic mean is level at every peak and keeps rising runs rising.
        if (before * after > 0.0) {
            const double w0 = 2.0 * h1 + h0;
            const double w1 = h1 + 2.0 * h0;
            slopes_[k] = (w0 + w1) / (w0 / before + w1 / after);
        }
    }
}

double Profile::operator()(double position) const {
    if (position <= rows_.front().first) {
        return rows_.front().second;
    }
    if (position >= rows_.back().first) {
        return rows_.back().second;
    }
    std::size_t k = 0;
    while (rows_[k + 1].first < position) {
        ++k;
    }
    const double span = rows_[k + 1].first - rows_[k].first;
    const double t = (position - rows_[k].first) / span;
    return bezier(rows_[k].second, rows_[k].second + slopes_[k] * span / 3.0,
                  rows_[k + 1].second - slopes_[k + 1] * span / 3.0, rows_[k + 1].second, t);
}

double Profile::slope(double position) const {
    constexpr double kStep = 1e-3;
    return ((*this)(position + kStep) - (*this)(position - kStep)) / (2.0 * kStep);
}

PointCurve::PointCurve(std::vector<Vec3> points, Ends ends)
    : points_(std::move(points)), ends_(ends) {}

Vec3 PointCurve::point(int index) const {
    const int spans = static_cast<int>(points_.size()) - 1;
    if (index >= 0 && index <= spans) {
        return points_[static_cast<std::size_t>(index)];
    }
    if (ends_ == Ends::Closed) {
        return points_[static_cast<std::size_t>((index + spans) % spans)];
    }
    // Open ends go on straight.
    const Vec3 end = index < 0 ? points_.front() : points_.back();
    const Vec3 inner = index < 0 ? points_[1] : points_[points_.size() - 2];
    return 2.0 * end - inner;
}

Vec3 PointCurve::operator()(double fraction) const {
    const int spans = static_cast<int>(points_.size()) - 1;
    const double along = std::clamp(fraction, 0.0, 1.0) * spans;
    const int k = std::min(static_cast<int>(along), spans - 1);
    const double t = along - k;
    const Vec3 a = point(k);
    const Vec3 d = point(k + 1);
    const Vec3 b = a + (1.0 / 6.0) * (d - point(k - 1));
    const Vec3 c = d - (1.0 / 6.0) * (point(k + 2) - a);
    return {bezier(a.x, b.x, c.x, d.x, t), bezier(a.y, b.y, c.y, d.y, t),
            bezier(a.z, b.z, c.z, d.z, t)};
}

double PointCurve::length() const {
    double sum = 0.0;
    for (std::size_t k = 0; k + 1 < points_.size(); ++k) {
        sum += samples::length(points_[k + 1] - points_[k]);
    }
    return sum;
}

}  // namespace toile::samples
