// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/pattern/piece_curves.h"

#include <cmath>

#include "core/geometry/segment.h"
#include "core/pattern/curve_fit.h"
#include "core/pattern/segments.h"

namespace toile {
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
