// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/reading/line_fit.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <utility>

#include "core/geometry/likeness.h"
#include "core/geometry/nearest_on_line.h"
#include "core/geometry/placement.h"
#include "core/geometry/polygon.h"
#include "core/geometry/segment.h"
#include "core/reading/pattern_file.h"

namespace toile {
namespace {

using geometry::CentredPlaces, geometry::NearestOnLine;

constexpr int kRoughPoints = 128;
constexpr int kFinePoints = 400;
constexpr int kMaxFitPoints = 20000;
constexpr int kMaxFitRounds = 40;
constexpr double kSettled = 1e-7;       // mm, change of the mean per round
constexpr double kMirrorShare = 0.8;    // a mirrored fit must be better by this factor
constexpr double kMirrorLength = 0.05;  // and by this distance, mm

/// Points of a closed line at equal distances along it, starting at its first point.
Points2 evenPoints(const Points2& closed, int count) {
    const double length = geometry::perimeterOf(closed);
    Points2 points(count, 2);
    Eigen::Index k = 0;
    double begin = 0;
    double step = (closed.row(1 % closed.rows()) - closed.row(0)).norm();
    for (int n = 0; n < count; ++n) {
        const double at = length * n / count;
        while (k + 1 < closed.rows() && begin + step < at) {
            begin += step;
            ++k;
            step = (closed.row((k + 1) % closed.rows()) - closed.row(k)).norm();
        }
        const double share = step > 0 ? std::clamp((at - begin) / step, 0.0, 1.0) : 0;
        points.row(n) =
            closed.row(k) + share * (closed.row((k + 1) % closed.rows()) - closed.row(k));
    }
    return points;
}

Points2 mirroredLine(const Points2& closed) {
    Points2 image = closed.colwise().reverse();  // so that it runs anti-clockwise again
    image.col(0) *= -1;
    return image;
}

CentredPlaces centred(const Points2& points, Eigen::RowVector2d& middle) {
    middle = points.colwise().mean();
    CentredPlaces numbers;
    for (Eigen::Index k = 0; k < points.rows(); ++k) {
        numbers.emplace_back(points(k, 0) - middle.x(), points(k, 1) - middle.y());
    }
    return numbers;
}

bool isLine(const Points2& closed) {
    return closed.rows() > 2 && closed.allFinite() && geometry::perimeterOf(closed) > 0;
}

Points2 turned(const Points2& points, double angle, const Eigen::RowVector2d& from,
               const Eigen::RowVector2d& to) {
    const Eigen::Matrix2d rotation = Eigen::Rotation2Dd(angle).toRotationMatrix();
    return ((points.rowwise() - from) * rotation.transpose()).rowwise() + to;
}

/// Pairs of each point of either line with the nearest point on the other line.
struct NearPairs {
    Points2 first, second;

    NearPairs(const NearestOnLine& line, const Points2& points, const NearestOnLine& other,
              const Points2& otherPoints)
        : first(points.rows() + otherPoints.rows(), 2), second(first.rows(), 2) {
        for (Eigen::Index k = 0; k < points.rows(); ++k) {
            first.row(k) = points.row(k);
            second.row(k) = other(points.row(k));
        }
        for (Eigen::Index k = 0; k < otherPoints.rows(); ++k) {
            first.row(points.rows() + k) = line(otherPoints.row(k));
            second.row(points.rows() + k) = otherPoints.row(k);
        }
    }

    Eigen::VectorXd distances() const { return (first - second).rowwise().norm(); }
};

/// Even points and the line's own points, as even points miss corners.
Points2 pointsToTry(const Points2& closed) {
    Points2 even = evenPoints(closed, kFinePoints);
    if (closed.rows() > kFinePoints) {
        return even;
    }
    Points2 all(even.rows() + closed.rows(), 2);
    all << even, closed;
    return all;
}

LineFit settledFit(const Points2& line, Points2 other, bool mirrored) {
    other = mirrored ? mirroredLine(other) : other;
    Eigen::RowVector2d middle, otherMiddle;
    const auto even = centred(evenPoints(line, kRoughPoints), middle);
    const auto otherEven = centred(evenPoints(other, kRoughPoints), otherMiddle);
    const auto best = geometry::bestLikeness(even, otherEven).likeness;
    other = turned(other, std::arg(best), otherMiddle, middle);
    const Points2 points = pointsToTry(line);
    const NearestOnLine onLine(line);
    LineFit fit{other, mirrored, std::numeric_limits<double>::infinity(), 0};
    for (int round = 0; round < kMaxFitRounds; ++round) {
        const NearPairs pairs(onLine, points, NearestOnLine(other), pointsToTry(other));
        const Eigen::VectorXd distances = pairs.distances();
        const double mean = distances.mean();
        if (!(mean < fit.mean)) {
            break;
        }
        const bool isSettled = fit.mean - mean < kSettled;
        fit = {other, mirrored, mean, distances.maxCoeff(),
               std::sqrt(distances.squaredNorm() / static_cast<double>(distances.size()))};
        if (isSettled) {
            break;
        }
        other = geometry::fitMotion(pairs.second, pairs.first).appliedToRows(other);
    }
    return fit;
}

/// Resamples lines with an implausible number of points.
Points2 fewerPoints(const Points2& closed) {
    return closed.rows() > kMaxFitPoints ? evenPoints(closed, kMaxFitPoints) : closed;
}

}  // namespace

double roughDistance(const Points2& line, const Points2& other, bool mirrored) {
    if (!isLine(line) || !isLine(other)) {
        return std::numeric_limits<double>::infinity();
    }
    Eigen::RowVector2d middle;
    const auto even = centred(evenPoints(line, kRoughPoints), middle);
    const auto otherEven =
        centred(evenPoints(mirrored ? mirroredLine(other) : other, kRoughPoints), middle);
    const double best = std::abs(geometry::bestLikeness(even, otherEven).likeness);
    const double square = geometry::squaresOf(even) + geometry::squaresOf(otherEven) - 2 * best;
    return std::sqrt(std::max(0.0, square) / kRoughPoints);
}

LineFit fitLine(const Points2& line, const Points2& other, bool canMirror) {
    if (!isLine(line) || !isLine(other)) {
        return {};
    }
    const Points2 first = geometry::antiClockwise(fewerPoints(line)),
                  second = geometry::antiClockwise(fewerPoints(other));
    LineFit plain = settledFit(first, second, false);
    if (!canMirror) {
        return plain;
    }
    LineFit image = settledFit(first, second, true);
    const bool isBetter = image.mean < kMirrorShare * plain.mean - kMirrorLength;
    return isBetter ? image : plain;
}

}  // namespace toile
