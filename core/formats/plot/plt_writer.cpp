// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include "core/base/text.h"
#include "core/formats/drawing/text_outlines.h"
#include "core/formats/writers.h"
#include "core/geometry/segment.h"

namespace toile {
namespace {

constexpr double kOffLine = 0.019;  // mm; limit of reading back, 0.02, minus a reserve for rounding
constexpr double kOffLength = 0.004;  // mm, tolerance of a long step
constexpr double kPerOffset = 0.15;   // mm of length per mm that a point is off
/// Each short step of a zigzag adds length: mm of length, times mm of step.
constexpr double kPerStep = 0.002;
constexpr Eigen::Index kMaxPassed = 200;  // points passed by one step

/// Walks along a line in steps between the grid points of a plotter.
class PlotterWalk {
public:
    PlotterWalk(const Points2& line, bool closed) : line_(line) {
        if (closed) {
            line_.conservativeResize(line.rows() + 1, 2);
            line_.row(line.rows()) = line.row(0);
        }
        arc_.push_back(0);
        for (Eigen::Index k = 1; k < line_.rows(); ++k) {
            arc_.push_back(arc_.back() + (line_.row(k) - line_.row(k - 1)).norm());
        }
        isClosed_ = closed;
    }

    std::vector<Eigen::Vector2d> walk() {
        at_ = rounded(0);
        const Eigen::Index before = isClosed_ ? line_.rows() - 2 : 0;
        error_ = -ahead(0, at_, line_.row(0) - line_.row(before));
        std::vector<Eigen::Vector2d> places{at_};
        for (Eigen::Index k = 0; k + 1 < line_.rows();) {
            const Step step = next(k, places.front());
            error_ = step.error;
            k = step.end;
            if (step.place != at_ || places.size() == 1) {
                places.push_back(step.place);
            }
            at_ = step.place;
        }
        return places;
    }

private:
    struct Step {
        Eigen::Index end = 0;
        Eigen::Vector2d place{0, 0};  ///< units
        double error = 0;             ///< of the length up to the place, mm
        /// Error of the length up to the new line's nearest point to the original point.
        double seen = std::numeric_limits<double>::infinity();
    };

    Eigen::Vector2d rounded(Eigen::Index k) const {
        return (kPlotterUnits * line_.row(k).transpose()).array().round();
    }

    /// The farthest point at which a step may end with the right length, else the best of all.
    Step next(Eigen::Index from, const Eigen::Vector2d& first) const {
        Step best, farthest;
        double least = std::numeric_limits<double>::infinity();
        const Eigen::Index last = std::min(line_.rows() - 1, from + kMaxPassed);
        int misses = 0;
        for (Eigen::Index end = from + 1; end <= last && misses < 3; ++end) {
            const Step step = stepTo(from, end, first);
            if (!std::isfinite(step.seen)) {
                ++misses;  // the next point may round better
                continue;
            }
            misses = 0;
            const double cost = std::abs(step.seen) + kPerStep / lengthBetween(from, end);
            if (cost < least) {  // false for coinciding points
                best = step;
                least = cost;
            }
            farthest = std::abs(step.seen) <= kOffLength ? step : farthest;
        }
        if (farthest.end > 0 || best.end > 0) {
            return farthest.end > 0 ? farthest : best;
        }
        // Points closer together than the plotter's grid.
        const Eigen::Vector2d place = rounded(from + 1);
        return {from + 1, place,
                error_ + (place - at_).norm() / kPlotterUnits - lengthBetween(from, from + 1)};
    }

    double lengthBetween(Eigen::Index from, Eigen::Index end) const {
        return arc_[static_cast<std::size_t>(end)] - arc_[static_cast<std::size_t>(from)];
    }

    /// The end with the smallest error of length and place; infinite if the line is too far off.
    Step stepTo(Eigen::Index from, Eigen::Index end, const Eigen::Vector2d& first) const {
        Step best{end};
        double least = std::numeric_limits<double>::infinity();
        const double length = lengthBetween(from, end);
        const bool isEnd = isClosed_ && end + 1 == line_.rows();
        const Eigen::Vector2d exact = kPlotterUnits * line_.row(end).transpose();
        for (int side = 0; side < (isEnd ? 1 : 4); ++side) {
            const Eigen::Vector2d place =
                isEnd
                    ? first
                    : Eigen::Vector2d(exact.array().floor() + Eigen::Array2d(side & 1, side >> 1));
            const double off = (place - exact).norm() / kPlotterUnits;
            const double error = error_ + (place - at_).norm() / kPlotterUnits - length;
            const double seen = error + ahead(end, place, (place - at_).transpose());
            const double cost = std::abs(seen) + kPerOffset * off;
            const bool isShort = place == at_ && end + 1 < line_.rows();
            if (!isShort && off <= kOffLine && cost < least && isNear(from, end, place)) {
                best = {end, place, error, seen};
                least = cost;
            }
        }
        return best;
    }

    /// Signed distance along the line from a place to the nearest point to its original point, mm.
    /// At a corner that point may be on the incoming step or on the next one.
    /// @param step  the incoming step
    double ahead(Eigen::Index k, const Eigen::Vector2d& place,
                 const Eigen::RowVector2d& step) const {
        const Eigen::Vector2d off = line_.row(k).transpose() - place / kPlotterUnits;
        const Eigen::Index next = k + 1 < line_.rows() ? k + 1 : isClosed_ ? 1 : k;
        const Eigen::Vector2d before = step.transpose().normalized();
        const Eigen::Vector2d behind = (line_.row(next) - line_.row(k)).normalized();
        const double back = std::min(0.0, off.dot(before)), on = std::max(0.0, off.dot(behind));
        const bool isBehind = (off - on * behind).norm() < (off - back * before).norm();
        return isBehind ? on : back;
    }

    /// Whether all points passed by a step are near it.
    bool isNear(Eigen::Index from, Eigen::Index end, const Eigen::Vector2d& place) const {
        const Eigen::Vector2d a = at_ / kPlotterUnits, b = place / kPlotterUnits;
        for (Eigen::Index k = from + 1; k < end; ++k) {
            const Eigen::Vector2d point = line_.row(k);
            const double share = geometry::nearestShare(point, a, b);
            if ((a + share * (b - a) - point).norm() > kOffLine) {
                return false;
            }
        }
        return true;
    }

    Points2 line_;  ///< a closed line repeats its first point
    std::vector<double> arc_;
    bool isClosed_ = false;
    Eigen::Vector2d at_{0, 0};  ///< units
    double error_ = 0;          ///< of the length so far, mm
};

}  // namespace

Points2 plotterLine(const Points2& line, bool closed) {
    const std::vector<Eigen::Vector2d> places = PlotterWalk(line, closed).walk();
    Points2 units(static_cast<Eigen::Index>(places.size()), 2);
    for (std::size_t k = 0; k < places.size(); ++k) {
        units.row(static_cast<Eigen::Index>(k)) = places[k].transpose();
    }
    return units;
}

namespace {

constexpr int kCutPen = 1, kLinePen = 2, kLetterPen = 3;
constexpr Eigen::Index kMaxInList = 64;  // points: buffer size of old plotters
constexpr int kPerLetterCurve = 4;       // points

class PltWriter {
public:
    PltWriter(const Drawing& drawing, const PltOptions& options)
        : drawing_(drawing), options_(options) {}

    std::string write() {
        bytes_ = "IN;PA;";
        for (const DrawnText& text : drawing_.texts) {
            for (const std::vector<CubicCurve>& contour : placedOutlines(text)) {
                add(kLetterPen, letterLine(contour));
            }
        }
        for (const DrawnPath& path : drawing_.paths) {
            if (path.layer != LayerKind::Cut) {
                add(kLinePen, plotterLine(placed(path.points), path.closed));
            }
        }
        // Reverse order: a piece's holes come after its outline in the drawing.
        for (auto path = drawing_.paths.rbegin(); path != drawing_.paths.rend(); ++path) {
            if (path->layer == LayerKind::Cut) {
                add(kCutPen, plotterLine(placed(path->points), path->closed));
            }
        }
        return bytes_ + "PU0,0;SP0;";
    }

private:
    Points2 placed(const Points2& line) const {
        Points2 moved = line;
        if (options_.turned) {
            moved.col(0) = drawing_.height - line.col(1).array();
            moved.col(1) = line.col(0);
        }
        return moved.cwiseMax(0);  // for letters that extend beyond the page
    }

    /// The line of a letter, whose length is irrelevant: rounded, without repeated points.
    Points2 letterLine(const std::vector<CubicCurve>& contour) const {
        Points2 units(static_cast<Eigen::Index>(contour.size()) * (kPerLetterCurve + 1), 2);
        Eigen::Index count = 0;
        for (const CubicCurve& curve : contour) {
            const int points = curve.isLine ? 1 : kPerLetterCurve;
            const Points2 line = placed(sampled({curve}, points));
            for (Eigen::Index k = 0; k <= points; ++k) {
                units.row(count) = (kPlotterUnits * line.row(k)).array().round();
                const bool isNew = count == 0 || units.row(count) != units.row(count - 1);
                count += isNew ? 1 : 0;
            }
        }
        return units.topRows(count);
    }

    void add(int pen, const Points2& units) {
        if (units.rows() == 0) {
            return;
        }
        if (pen != pen_) {
            bytes_ += "SP" + std::to_string(pen) + ';';
            pen_ = pen;
        }
        bytes_ += "PU";
        append(units, 0);
        for (Eigen::Index k = 1; k < units.rows(); ++k) {
            bytes_ += k % kMaxInList == 1 ? ";PD" : ",";
            append(units, k);
        }
        bytes_ += ";PU;";
    }

    void append(const Points2& units, Eigen::Index k) {
        appendFixed(bytes_, units(k, 0), 0);
        bytes_ += ',';
        appendFixed(bytes_, units(k, 1), 0);
    }

    const Drawing& drawing_;
    const PltOptions& options_;
    std::string bytes_;
    int pen_ = 0;
};

}  // namespace

std::string writePlt(const Drawing& drawing, const PltOptions& options) {
    return PltWriter(drawing, options).write();
}

}  // namespace toile
