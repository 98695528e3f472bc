// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/pattern/piece_curves.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

#include "core/geometry/segment.h"
#include "core/pattern/curve_fit.h"
#include "core/pattern/segments.h"
#include "core/quality/closed_line.h"

namespace toile {
namespace {

using Eigen::Vector2d;

/// Points of a fine line nearer to each other tell nothing of its direction, mm.
constexpr double kShortestStep = 0.1;
/// A joint that turns by no more is smooth, radians.
constexpr double kSmoothJoint = 1e-3;
constexpr int kSamplesPerCurve = 32;
constexpr int kMostParts = 4096;

/// Without points that are too near to the one before or to the end.
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

/// Rows at which a line begins anew, first and last among them: its corners.
std::vector<Eigen::Index> breaksOf(const Points2& line) {
    std::vector<Eigen::Index> breaks{0};
    for (Eigen::Index k = 1; k + 1 < line.rows(); ++k) {
        if (std::abs(geometry::turnBetween(line.row(k) - line.row(k - 1),
                                           line.row(k + 1) - line.row(k))) > kCornerTurn) {
            breaks.push_back(k);
        }
    }
    breaks.push_back(line.rows() - 1);
    return breaks;
}

/// A run of curves that join smoothly, by arc length.
class SmoothRun {
public:
    explicit SmoothRun(std::vector<CubicCurve> curves)
        : curves_(std::move(curves)), samples_(sampled(curves_, kSamplesPerCurve)), arc_{0} {
        for (Eigen::Index k = 1; k < samples_.rows(); ++k) {
            arc_.push_back(arc_.back() + (samples_.row(k) - samples_.row(k - 1)).norm());
        }
    }

    /// Its start and points at even lengths, but for its end.
    std::vector<Vector2d> points(double deviation) const {
        int parts = 1;
        while (parts < kMostParts && deviationOf(parts) > deviation) {
            parts += std::max(1, parts / 4);
        }
        std::vector<Vector2d> points;
        points.reserve(static_cast<std::size_t>(parts));
        for (int k = 0; k < parts; ++k) {
            points.push_back(pointAt(k, parts));
        }
        return points;
    }

private:
    Vector2d pointAt(int k, int parts) const {
        const double way = arc_.back() * k / parts;
        const auto next = std::upper_bound(arc_.begin() + 1, arc_.end() - 1, way);
        const auto before = static_cast<std::size_t>(next - arc_.begin()) - 1;
        const double step = arc_[before + 1] - arc_[before];
        const double within = step > 0 ? (way - arc_[before]) / step : 0;
        const std::size_t curve = before / kSamplesPerCurve;
        const auto sample = static_cast<double>(before % kSamplesPerCurve);
        return curves_[curve].at((sample + within) / kSamplesPerCurve);
    }

    double deviationOf(int parts) const {
        double most = 0;
        int part = 0;
        for (std::size_t s = 0; s < arc_.size(); ++s) {
            while (part + 1 < parts && arc_[s] > arc_.back() * (part + 1) / parts) {
                ++part;
            }
            const Vector2d a = pointAt(part, parts), b = pointAt(part + 1, parts);
            const Vector2d p = samples_.row(static_cast<Eigen::Index>(s));
            most = std::max(most, (a + geometry::nearestShare(p, a, b) * (b - a) - p).norm());
        }
        return most;
    }

    std::vector<CubicCurve> curves_;
    Points2 samples_;
    std::vector<double> arc_;
};

bool joinsSmoothly(const CubicCurve& before, const CubicCurve& after) {
    return !before.isLine && !after.isLine &&
           std::abs(geometry::turnBetween(before.derivative(1), after.derivative(0))) <
               kSmoothJoint;
}

}  // namespace

std::vector<CubicCurve> curvesOf(const PatternPiece& piece, const PatternSegment& segment) {
    const Points2 line = ClosedLine(piece.outline).part(segment.from, segment.to);
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

std::vector<CurvePoint> curvePoints(const PatternPiece& piece, double deviation) {
    assert(deviation > 0);
    std::vector<CurvePoint> points;
    for (const PatternSegment& segment : piece.segments) {
        const std::vector<CubicCurve> curves = curvesOf(piece, segment);
        bool isTurn = segment.isCorner;
        for (std::size_t k = 0; k < curves.size();) {
            std::size_t end = k + 1;
            while (end < curves.size() && joinsSmoothly(curves[end - 1], curves[end])) {
                ++end;
            }
            const SmoothRun run({curves.begin() + static_cast<std::ptrdiff_t>(k),
                                 curves.begin() + static_cast<std::ptrdiff_t>(end)});
            for (const Vector2d& point : run.points(deviation)) {
                points.push_back({point, std::exchange(isTurn, false)});
            }
            k = end;
        }
    }
    return points;
}

}  // namespace toile
