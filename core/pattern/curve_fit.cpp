// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/pattern/curve_fit.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <optional>

#include <Eigen/LU>

#include "core/geometry/segment.h"
#include "core/pattern/fine_polyline.h"

namespace toile {
namespace {

using Eigen::Vector2d;

constexpr double kStraight = 1e-3;      // mm from the chord
constexpr double kStraightTurn = 1e-9;  // radians, at a joint
constexpr int kFitIterations = 12;
constexpr double kFitDone = 1e-9;         // of the length: change of a handle
constexpr double kLengthWeight = 100;     // of the length relative to the distances
constexpr double kDamping = 1e-9;         // towards handles of a third, if all fit alike
constexpr double kShortestHandle = 0.02;  // of the length
constexpr int kMaxHalvings = 30;
constexpr double kAllowed = 0.9;      // of the tolerances, because only samples are tested
constexpr double kSagAllowed = 1.25;  // where the line bends more tightly than its steps show
constexpr double kBetween[] = {0.25, 0.5, 0.75};

/// Fits one curve between two points of the line, with a parameter for each point between.
class SpanFit {
public:
    SpanFit(const FinePolyline& line, int from, int to)
        : line_(line), from_(from), to_(to), length_(line.length(from, to)) {
        for (int k = from; k <= to; ++k) {
            places_.push_back(line.length(from, k) / length_);
        }
    }

    std::optional<CubicCurve> fitted() {
        if (isStraight()) {
            return straightCurve(line_.point(from_), line_.point(to_));
        }
        return to_ - from_ == 1 ? shortest() : leastSquares();
    }

private:
    CubicCurve curve(const Vector2d& handles) const {
        const Vector2d start = line_.point(from_), end = line_.point(to_);
        return {start, start + handles[0] * line_.tangent(from_),
                end - handles[1] * line_.tangent(to_), end};
    }

    /// Straight from end to end, with the line's direction at both ends.
    bool isStraight() const {
        const Vector2d start = line_.point(from_), chord = line_.point(to_) - start;
        const Vector2d normal = geometry::leftOf(chord.normalized());
        for (int k = from_ + 1; k < to_; ++k) {
            if (std::abs(normal.dot(line_.point(k) - start)) > kStraight) {
                return false;
            }
        }
        const double turn = std::abs(geometry::turnBetween(line_.tangent(from_), chord)) +
                            std::abs(geometry::turnBetween(chord, line_.tangent(to_)));
        const bool isWhole = from_ == 0 && to_ + 1 == line_.count();
        return turn < (isWhole ? 8 * kStraight / length_ : kStraightTurn);
    }

    /// Fallback for two neighbouring points: short handles stay near the chord for any tangents.
    std::optional<CubicCurve> shortest() const {
        Vector2d handles = Vector2d::Constant(length_ / 3);
        for (int k = 0; k < kMaxHalvings && !isGood(curve(handles)); ++k) {
            handles *= 0.5;
        }
        return curve(handles);
    }

    std::optional<CubicCurve> leastSquares() {
        Vector2d handles = Vector2d::Constant(length_ / 3);
        for (int k = 0; k < kFitIterations; ++k) {
            const Vector2d change = improvement(handles);
            handles += change;
            if (!(handles.minCoeff() > kShortestHandle * length_) ||
                !(handles.maxCoeff() < length_)) {
                return std::nullopt;
            }
            project(curve(handles));
            if (change.lpNorm<Eigen::Infinity>() < kFitDone * length_) {
                break;
            }
        }
        const CubicCurve found = curve(handles);
        return isGood(found) ? std::optional(found) : std::nullopt;
    }

    /// The Gauss-Newton step for distances and length.
    Vector2d improvement(const Vector2d& handles) const {
        const CubicCurve now = curve(handles);
        Eigen::Matrix2d normal = kDamping * Eigen::Matrix2d::Identity();
        Vector2d right = kDamping * (Vector2d::Constant(length_ / 3) - handles);
        const auto add = [&](const Vector2d& row, double residual, double weight) {
            normal += weight * row * row.transpose();
            right -= weight * residual * row;
        };
        for (int k = from_ + 1; k < to_; ++k) {
            const double t = places_[k - from_], s = 1 - t;
            const Vector2d across = geometry::leftOf(now.derivative(t).normalized());
            add({3 * s * s * t * across.dot(line_.tangent(from_)),
                 -3 * s * t * t * across.dot(line_.tangent(to_))},
                across.dot(now.at(t) - line_.point(k)), 1.0 / (to_ - from_));
        }
        const double step = 1e-5 * length_, length = curveLength(now);
        const Vector2d growth((curveLength(curve(handles + Vector2d(step, 0))) - length) / step,
                              (curveLength(curve(handles + Vector2d(0, step))) - length) / step);
        add(growth, length - length_, kLengthWeight);
        return normal.inverse() * right;
    }

    /// Moves each point's parameter to the nearest place of the curve.
    void project(const CubicCurve& now) {
        for (int k = from_ + 1; k < to_; ++k) {
            double& t = places_[k - from_];
            const Vector2d speed = now.derivative(t);
            t += speed.dot(line_.point(k) - now.at(t)) / std::max(speed.squaredNorm(), 1e-12);
            t = std::clamp(t, 0.0, 1.0);
        }
    }

    bool isGood(const CubicCurve& now) const {
        const double limit = kAllowed * kCurveTolerance;
        for (int k = from_; k < to_; ++k) {
            const double t = places_[k - from_], after = places_[k + 1 - from_];
            if (!(t < after) || (now.at(t) - line_.point(k)).norm() > limit) {
                return false;
            }
            const double between = std::max(limit, kSagAllowed * line_.sag(k));
            for (const double share : kBetween) {
                const Vector2d point = now.at(t + share * (after - t));
                const Vector2d a = line_.point(k), b = line_.point(k + 1);
                const double place = geometry::nearestShare(point, a, b);
                if ((a + place * (b - a) - point).norm() > between) {
                    return false;
                }
            }
        }
        const double share = length_ / line_.length(0, line_.count() - 1);
        return std::abs(curveLength(now) - length_) <= kAllowed * share * kCurveLengthTolerance;
    }

    const FinePolyline& line_;
    int from_, to_;
    double length_;
    std::vector<double> places_;
};

/// Number of steps that one curve can span from here, to a sixteenth. Searches from above, because
/// some short curves cannot shorten a tight bend enough, while longer ones can.
int reachOf(const FinePolyline& line, int from, CubicCurve& curve) {
    const auto fits = [&](int steps) {
        const auto fitted = SpanFit(line, from, from + steps).fitted();
        curve = fitted.value_or(curve);
        return fitted.has_value();
    };
    int reach = line.count() - 1 - from;
    int tooFar = reach + 1;
    while (!fits(reach)) {
        tooFar = reach;
        reach = std::max(1, reach * 3 / 4);
    }
    while (tooFar - reach > std::max(1, reach / 16)) {
        const int middle = (reach + tooFar) / 2;
        (fits(middle) ? reach : tooFar) = middle;
    }
    return reach;
}

/// Curves that share the steps evenly; empty if one of them does not fit.
std::vector<CubicCurve> evenly(const FinePolyline& line, int curves) {
    std::vector<CubicCurve> chain;
    const int steps = line.count() - 1;
    for (int k = 0; k < curves; ++k) {
        const auto fitted = SpanFit(line, k * steps / curves, (k + 1) * steps / curves).fitted();
        if (!fitted) {
            return {};
        }
        chain.push_back(*fitted);
    }
    return chain;
}

}  // namespace

std::vector<CubicCurve> fitCurves(const Points2& points, double length) {
    assert(points.rows() >= 2);
    const FinePolyline line(points, length);
    std::vector<CubicCurve> chain;
    for (int at = 0; at + 1 < line.count();) {
        at += reachOf(line, at, chain.emplace_back());
    }
    std::vector<CubicCurve> even = evenly(line, static_cast<int>(chain.size()));
    return even.empty() ? chain : even;
}

}  // namespace toile
