// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/pattern/curve_fit.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <optional>

#include <Eigen/LU>

#include "core/geometry/segment.h"
#include "core/pattern/segments.h"

namespace toile {
namespace {

using Eigen::Vector2d;

constexpr int kLengthParts = 8;
// Gauss' rule with five nodes, on [-1, 1].
constexpr double kPlaces[] = {0, 0.5384693101056831, 0.9061798459386640};
constexpr double kWeights[] = {0.5688888888888889, 0.4786286704993665, 0.2369268850561891};

}  // namespace

Vector2d CubicCurve::at(double t) const {
    const double s = 1 - t;
    return s * s * s * start + 3 * s * s * t * startHandle + 3 * s * t * t * endHandle +
           t * t * t * end;
}

Vector2d CubicCurve::derivative(double t) const {
    const double s = 1 - t;
    return 3 * (s * s * (startHandle - start) + 2 * s * t * (endHandle - startHandle) +
                t * t * (end - endHandle));
}

CubicCurve straightCurve(const Vector2d& start, const Vector2d& end) {
    return {start, start + (end - start) / 3, end + (start - end) / 3, end, true};
}

double curveLength(const CubicCurve& curve) {
    if (curve.isLine) {
        return (curve.end - curve.start).norm();
    }
    const double half = 0.5 / kLengthParts;
    double length = 0;
    for (int part = 0; part < kLengthParts; ++part) {
        const double middle = (2 * part + 1) * half;
        length += half * kWeights[0] * curve.derivative(middle).norm();
        for (const int k : {1, 2}) {
            length += half * kWeights[k] *
                      (curve.derivative(middle - half * kPlaces[k]).norm() +
                       curve.derivative(middle + half * kPlaces[k]).norm());
        }
    }
    return length;
}

double curveLength(const std::vector<CubicCurve>& chain) {
    double length = 0;
    for (const CubicCurve& curve : chain) {
        length += curveLength(curve);
    }
    return length;
}

Points2 sampled(const std::vector<CubicCurve>& chain, int perCurve) {
    assert(perCurve > 0);
    if (chain.empty()) {
        return Points2(0, 2);
    }
    Points2 points(static_cast<Eigen::Index>(chain.size()) * perCurve + 1, 2);
    Eigen::Index row = 0;
    for (const CubicCurve& curve : chain) {
        for (int k = 0; k < perCurve; ++k) {
            points.row(row++) = curve.at(static_cast<double>(k) / perCurve);
        }
    }
    points.row(row) = chain.back().end;
    return points;
}

FinePolyline::FinePolyline(const Points2& points, double length)
    : points_(points), turns_(static_cast<std::size_t>(points.rows()), 0), reached_{0} {
    assert(count() >= 2);
    for (int k = 0; k + 1 < count(); ++k) {
        const Eigen::Vector2d step = point(k + 1) - point(k);
        if (k > 0) {
            const Eigen::Vector2d before = point(k) - point(k - 1);
            turns_[k] = geometry::turnBetween(before, step);
            directions_.push_back(directions_.back() + turns_[k]);
        } else {
            directions_.push_back(std::atan2(step.y(), step.x()));
        }
        steps_.push_back(step.norm());
        reached_.push_back(reached_.back() + steps_.back());
    }
    const double scale = length / reached_.back();
    for (double& reached : reached_) {
        reached *= scale;
    }
    for (int k = 0; k < count(); ++k) {
        const double angle = isInside(k) ? directionAt(k) : directionAtEnd(k);
        tangents_.emplace_back(std::cos(angle), std::sin(angle));
    }
}

double FinePolyline::directionAt(int k) const {
    return (directions_[k - 1] * steps_[k] + directions_[k] * steps_[k - 1]) /
           (steps_[k] + steps_[k - 1]);
}

double FinePolyline::directionAtEnd(int k) const {
    const int side = k == 0 ? 1 : -1;
    const int step = k == 0 ? 0 : k - 1;
    const double near = isInside(k + side) ? curvature(k + side) : 0;
    const double change = isInside(k + 2 * side) ? curvature(k + 2 * side) - near : 0;
    // Half a step from the end, with the curvature at the middle of that half.
    return directions_[step] - side * 0.5 * steps_[step] * (near - 0.75 * change);
}

double FinePolyline::sag(int step) const {
    const double before = turns_[step > 0 ? step : std::min(1, count() - 1)];
    const double after = turns_[step + 2 < count() ? step + 1 : step];
    const double turn = std::min(std::abs(before), std::abs(after));
    return before * after > 0 ? turn * steps_[step] / 8 : 0;
}

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

namespace {

/// Points of a fine line nearer to each other do not define its direction, mm.
constexpr double kShortestStep = 0.1;

/// Omits points too near to the previous one or to the end.
Points2 thinned(const Points2& line) {
    std::vector<Eigen::Index> kept{0};
    const Eigen::Index last = line.rows() - 1;
    for (Eigen::Index k = 1; k < last; ++k) {
        if ((line.row(k) - line.row(kept.back())).norm() >= kShortestStep &&
            (line.row(last) - line.row(k)).norm() >= kShortestStep) {
            kept.push_back(k);
        }
    }
    kept.push_back(last);
    return line(kept, Eigen::all);
}

double lengthOfLine(const Points2& line) {
    const Eigen::Index n = line.rows() - 1;
    return (line.bottomRows(n) - line.topRows(n)).rowwise().norm().sum();
}

std::vector<CubicCurve> edgesOf(const Points2& line) {
    std::vector<CubicCurve> edges;
    for (Eigen::Index k = 0; k + 1 < line.rows(); ++k) {
        if ((line.row(k + 1) - line.row(k)).norm() > 0) {
            edges.push_back(straightCurve(line.row(k), line.row(k + 1)));
        }
    }
    return edges;
}

/// Rows of the corners of a line, including the first and last row.
std::vector<Eigen::Index> breaksOf(const Points2& line) {
    std::vector<Eigen::Index> breaks{0};
    for (Eigen::Index k = 1; k + 1 < line.rows(); ++k) {
        if (std::abs(geometry::turnBetween(line.row(k) - line.row(k - 1),
                                           line.row(k + 1) - line.row(k))) > kLineCorner.turn) {
            breaks.push_back(k);
        }
    }
    breaks.push_back(line.rows() - 1);
    return breaks;
}

}  // namespace

std::vector<CubicCurve> curvesOf(const PatternPiece& piece, const geometry::Line& outline,
                                 const PatternSegment& segment) {
    const Points2 line = outline.part(segment.from, segment.to);
    if (!piece.isFine) {
        return edgesOf(line);
    }
    const Points2 fine = thinned(line);
    const double scale = (segment.to - segment.from) / lengthOfLine(fine);
    const std::vector<Eigen::Index> breaks = breaksOf(fine);
    std::vector<CubicCurve> curves;
    for (std::size_t k = 0; k + 1 < breaks.size(); ++k) {
        const Points2 part = fine.middleRows(breaks[k], breaks[k + 1] - breaks[k] + 1);
        const auto fitted = fitCurves(part, scale * lengthOfLine(part));
        curves.insert(curves.end(), fitted.begin(), fitted.end());
    }
    return curves;
}

}  // namespace toile
