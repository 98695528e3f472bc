// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/dxf/dxf_curve.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <map>
#include <utility>

#include "core/base/units.h"
#include "core/geometry/segment.h"

namespace toile {
namespace {

using Eigen::Vector2d;
using CurvePoints = std::vector<Vector2d>;

constexpr double kMinBulge = 1e-7, kMaxBulge = 1e5;  // smaller: a straight line; larger: invalid
constexpr int kMaxHalvings = 12, kMaxDegree = 15;
constexpr double kSameEnd = 1e-9;     // of the extent: the last point repeats the first
constexpr double kNoSweep = 1e-4;     // radians, by rounding; less is a full turn
constexpr double kMaxOfFrame = 1.01;  // largest ratio of a spline's length to that of its chords
constexpr long kMeshFlags = 16 | 64;  // of a POLYLINE that is a mesh

/// Appends chords of one smooth stretch of a curve, without its first point. Halves the stretch
/// until no point of the curve is farther than the tolerance from its chord.
void addChords(CurvePoints& points, const std::function<Vector2d(double)>& at, double from,
               double to, double tolerance, int halvings = kMaxHalvings) {
    const Vector2d start = at(from), end = at(to);
    bool isFlat = halvings == 0 || points.size() > kMaxCurvePoints;
    if (!isFlat) {
        isFlat = true;
        for (const double share : {0.25, 0.5, 0.75}) {
            isFlat = isFlat && !(geometry::distanceToSegment<Vector2d>(
                                     at(from + share * (to - from)), start, end) > tolerance);
        }
    }
    if (isFlat) {
        points.push_back(end);
        return;
    }
    const double middle = (from + to) / 2;
    addChords(points, at, from, middle, tolerance, halvings - 1);
    addChords(points, at, middle, to, tolerance, halvings - 1);
}

/// Appends an arc of an ellipse by two half axes (of a circle: two radii) between two angles.
void addArc(CurvePoints& points, const Vector2d& centre, const Vector2d& major,
            const Vector2d& minor, double from, double to, double tolerance) {
    constexpr double kStretch = kPi / 4;
    const auto at = [&](double angle) -> Vector2d {
        return centre + std::cos(angle) * major + std::sin(angle) * minor;
    };
    const int stretches = std::max(1, static_cast<int>(std::ceil(std::abs(to - from) / kStretch)));
    for (int k = 0; k < stretches; ++k) {
        const double step = (to - from) / stretches;
        addChords(points, at, from + k * step, from + (k + 1) * step, tolerance);
    }
}

/// Anti-clockwise sweep from one angle to another, in (0, 2 pi].
double sweepOf(double from, double to) {
    const double sweep = std::fmod(to - from, 2 * kPi);
    return sweep <= kNoSweep ? sweep + 2 * kPi : sweep;
}

CurvePoints polylinePoints(const DxfEntity& entity, double tolerance) {
    const Eigen::Index n = entity.points.rows();
    CurvePoints points;
    for (Eigen::Index k = 0; k < n; ++k) {
        const Vector2d from = entity.points.row(k).transpose();
        points.push_back(from);
        const double bulge = entity.bulges[static_cast<std::size_t>(k)];
        const bool isArc = std::abs(bulge) > kMinBulge && std::abs(bulge) < kMaxBulge;
        if (!isArc || (k + 1 == n && !entity.closed)) {
            continue;
        }
        const Vector2d to = entity.points.row((k + 1) % n).transpose();
        const Vector2d centre = (from + to) / 2 + (1 - bulge * bulge) / (4 * bulge) *
                                                      geometry::leftOf(Vector2d(to - from));
        const Vector2d radius = from - centre;
        addArc(points, centre, radius, geometry::leftOf(radius), 0, 4 * std::atan(bulge),
               tolerance);
        points.pop_back();  // the next vertex adds it
    }
    return points;
}

/// A B-spline, rational if it has weights, over the part of its knots where it is defined.
struct BSpline {
    int degree = 3;
    std::vector<double> knots{};
    std::vector<Eigen::Vector3d> controls{};  ///< (x w, y w, w) with weight w

    bool isValid() const {
        const std::size_t order = static_cast<std::size_t>(degree) + 1;
        return degree >= 1 && degree <= kMaxDegree && controls.size() >= order &&
               knots.size() == controls.size() + order && std::ranges::is_sorted(knots) &&
               std::ranges::all_of(controls, [](const auto& point) { return point.z() > 0; });
    }

    /// By de Boor's algorithm. @param span  the knot before the parameter
    Vector2d at(std::size_t span, double parameter) const {
        const auto p = static_cast<std::size_t>(degree);
        Eigen::Vector3d local[kMaxDegree + 1];
        std::copy_n(controls.begin() + static_cast<std::ptrdiff_t>(span - p), p + 1, local);
        for (std::size_t level = 1; level <= p; ++level) {
            for (std::size_t k = p; k >= level; --k) {
                const double low = knots[span - p + k], high = knots[span + 1 + k - level];
                local[k] += (high - parameter) / (high - low) * (local[k - 1] - local[k]);
            }
        }
        return local[p].head<2>() / local[p].z();
    }

    CurvePoints points(double tolerance) const {
        CurvePoints made;
        for (auto span = static_cast<std::size_t>(degree); span < controls.size(); ++span) {
            const double from = knots[span], to = knots[span + 1];
            if (from < to) {
                const auto place = [&](double parameter) { return at(span, parameter); };
                if (made.empty()) {
                    made.push_back(place(from));
                }
                addChords(made, place, from, (from + to) / 2, tolerance);
                addChords(made, place, (from + to) / 2, to, tolerance);
            }
        }
        return made;
    }
};

/// The spline with this control polygon and equal knots. Unless closed, it starts and ends at the
/// first and last control points.
CurvePoints framePoints(CurvePoints frame, int degree, bool closed, double tolerance) {
    BSpline spline;
    spline.degree = std::min(degree, static_cast<int>(frame.size()) - 1);
    if (closed && spline.degree > 0) {
        frame.insert(frame.end(), frame.begin(), frame.begin() + spline.degree);
    }
    for (const Vector2d& point : frame) {
        spline.controls.emplace_back(point.x(), point.y(), 1);
    }
    const int count = static_cast<int>(frame.size());
    for (int k = 0; k <= count + spline.degree; ++k) {
        spline.knots.push_back(closed ? k : std::clamp(k, spline.degree, count));
    }
    return spline.isValid() ? spline.points(tolerance) : CurvePoints();
}

double lengthOf(const CurvePoints& points, bool closed) {
    double length = closed && !points.empty() ? (points.front() - points.back()).norm() : 0;
    for (std::size_t k = 0; k + 1 < points.size(); ++k) {
        length += (points[k + 1] - points[k]).norm();
    }
    return length;
}

/// The spline of the control points of a spline-fit polyline. The file also has points of the
/// curve; returns these if their length shows that they are of another curve.
CurvePoints splineFitPoints(const DxfEntity& entity, CurvePoints chords, double tolerance) {
    constexpr double kQuadratic = 5;
    CurvePoints frame;
    for (const auto& row : entity.frame.rowwise()) {
        frame.emplace_back(row.transpose());
    }
    CurvePoints curve = framePoints(std::move(frame), entity.number(75) == kQuadratic ? 2 : 3,
                                    entity.closed, tolerance);
    const double length = lengthOf(curve, entity.closed), own = lengthOf(chords, entity.closed);
    const bool isSame = length >= own * (1 - kSameEnd) && length <= own * kMaxOfFrame;
    return chords.size() < 2 || isSame ? curve : chords;
}

/// The cubic spline through fit points, as CAD programs draw it: parametrised by chord length, with
/// zero curvature at ends without given tangents.
CurvePoints fitPoints(CurvePoints fit, const std::optional<Vector2d>& startWay,
                      const std::optional<Vector2d>& endWay, bool closed, double tolerance) {
    // A closed spline is repeated this many points beyond its ends; farther points have no effect.
    constexpr std::size_t kAround = 24;
    fit.erase(std::unique(fit.begin(), fit.end()), fit.end());
    if (closed && fit.size() > 1 && fit.front() == fit.back()) {
        fit.pop_back();
    }
    std::size_t first = 0, last = fit.size() - 1;
    if (closed && fit.size() > 2) {
        const CurvePoints once = fit;
        fit.clear();
        for (std::size_t k = 0; k <= once.size() + 2 * kAround; ++k) {
            fit.push_back(once[(k + once.size() * kAround - kAround) % once.size()]);
        }
        first = kAround;
        last = kAround + once.size();
    }
    const std::size_t n = fit.size();
    if (n < 2) {
        return {};
    }
    // Slopes from a tridiagonal system, by forward elimination and back substitution.
    std::vector<double> step(n - 1), above(n);
    CurvePoints slope(n);
    for (std::size_t k = 0; k + 1 < n; ++k) {
        step[k] = (fit[k + 1] - fit[k]).norm();
    }
    const auto chord = [&](std::size_t k) -> Vector2d {
        return 3 * (fit[k + 1] - fit[k]) / (step[k] * step[k]);
    };
    for (std::size_t k = 0; k < n; ++k) {
        const auto& way = k == 0 ? startWay : k + 1 == n ? endWay : std::optional<Vector2d>();
        const double before = k > 0 && !way ? 1 / step[k - 1] : 0;
        const double after = k + 1 < n && !way ? 1 / step[k] : 0;
        Vector2d right = way ? way->normalized() : Vector2d(0, 0);
        right += before > 0 ? chord(k - 1) : Vector2d(0, 0);
        right += after > 0 ? chord(k) : Vector2d(0, 0);
        const double pivot = (way ? 1 : 2 * (before + after)) - (k > 0 ? before * above[k - 1] : 0);
        above[k] = after / pivot;
        slope[k] = (right - (k > 0 ? before * slope[k - 1] : Vector2d(0, 0))) / pivot;
    }
    for (std::size_t k = n - 1; k-- > 0;) {
        slope[k] -= above[k] * slope[k + 1];
    }
    CurvePoints points{fit[first]};
    for (std::size_t k = first; k < last; ++k) {
        const auto at = [&](double t) -> Vector2d {
            const double u = 1 - t;
            return u * u * ((1 + 2 * t) * fit[k] + t * step[k] * slope[k]) +
                   t * t * ((1 + 2 * u) * fit[k + 1] - u * step[k] * slope[k + 1]);
        };
        addChords(points, at, 0, 0.5, tolerance);
        addChords(points, at, 0.5, 1, tolerance);
    }
    return points;
}

/// The values of all groups with a code.
std::vector<double> groupNumbers(const DxfEntity& entity, int code) {
    std::vector<double> numbers;
    for (const DxfGroup& group : entity.groups) {
        if (group.code == code) {
            numbers.push_back(group.number().value_or(std::nan("")));
        }
    }
    return numbers;
}

CurvePoints splinePoints(const DxfEntity& entity, bool closed, double tolerance) {
    const auto x = groupNumbers(entity, 10), y = groupNumbers(entity, 20);
    const auto weights = groupNumbers(entity, 41);
    if (x.empty()) {
        const auto fitX = groupNumbers(entity, 11), fitY = groupNumbers(entity, 21);
        CurvePoints fit;
        for (std::size_t k = 0; k < std::min(fitX.size(), fitY.size()); ++k) {
            fit.emplace_back(fitX[k], fitY[k]);
        }
        const auto wayOf = [&entity](int code) {
            const auto way = entity.point(code);
            return way && !way->isZero() ? way : std::nullopt;
        };
        return fit.empty() ? fit
                           : fitPoints(std::move(fit), wayOf(12), wayOf(13), closed, tolerance);
    }
    if (x.size() != y.size() || !(weights.empty() || weights.size() == x.size())) {
        return {};
    }
    BSpline spline;
    spline.degree = static_cast<int>(std::clamp(entity.number(71).value_or(3), 0.0, 100.0));
    spline.knots = groupNumbers(entity, 40);
    for (std::size_t k = 0; k < x.size(); ++k) {
        const double weight = weights.empty() ? 1 : weights[k];
        spline.controls.emplace_back(weight * x[k], weight * y[k], weight);
    }
    return spline.isValid() ? spline.points(tolerance) : CurvePoints();
}

/// The line of an entity in its own coordinates. @param closed  set to whether it is closed
CurvePoints ownPoints(const DxfEntity& entity, double tolerance, bool& closed) {
    const auto flags = static_cast<long>(std::clamp(entity.number(70).value_or(0), 0.0, 65535.0));
    const auto centre = entity.point(), other = entity.point(11);
    const double size = entity.number(40).value_or(0);  // a radius, or a ratio
    CurvePoints points;
    closed = entity.closed;
    if (entity.kind == "LWPOLYLINE" || (entity.kind == "POLYLINE" && (flags & kMeshFlags) == 0)) {
        points = polylinePoints(entity, tolerance);
        return entity.frame.rows() > 1 ? splineFitPoints(entity, std::move(points), tolerance)
                                       : points;
    }
    if (entity.kind == "SPLINE") {
        closed = (flags & 1) != 0;
        return splinePoints(entity, closed, tolerance);
    }
    if (!centre) {
        return {};
    }
    if (entity.kind == "LINE" && other) {
        return {*centre, *other};
    }
    if ((entity.kind == "ARC" || entity.kind == "CIRCLE") && size > 0) {
        const bool isArc = entity.kind == "ARC";
        const double from = isArc ? kDegree * entity.number(50).value_or(0) : 0;
        const double to = isArc ? kDegree * entity.number(51).value_or(360) : 0;
        const double sweep = sweepOf(from, to);
        closed = !isArc;
        points = {*centre + size * Vector2d(std::cos(from), std::sin(from))};
        addArc(points, *centre, {size, 0}, {0, size}, from, from + sweep, tolerance);
    } else if (entity.kind == "ELLIPSE" && other && size > 0) {
        const double from = entity.number(41).value_or(0);
        const double sweep = sweepOf(from, entity.number(42).value_or(2 * kPi));
        const double side = entity.number(230).value_or(1) < 0 ? -size : size;
        const Vector2d minor = side * geometry::leftOf(*other);
        points = {*centre + std::cos(from) * *other + std::sin(from) * minor};
        addArc(points, *centre, *other, minor, from, from + sweep, tolerance);
    }
    return points;
}

}  // namespace

std::optional<Error> refusalOfCurves(const DxfDocument& document, double unit) {
    DxfBlockInserter inserter(document);
    Eigen::Index points = 0;
    const auto areFew = [&](const std::vector<DxfEntity>& entities) {
        for (const DxfEntity& entity : inserter.replaced(entities)) {
            if (const auto line = dxfCurve(entity, unit)) {
                points += std::max<Eigen::Index>(0, line->points.rows() - entity.points.rows());
            }
            if (points > static_cast<Eigen::Index>(kMaxCurvePoints)) {
                return false;
            }
        }
        return true;
    };
    if (areFew(document.entities) &&
        std::ranges::all_of(document.blocks, areFew, &DxfBlock::entities)) {
        return std::nullopt;
    }
    return Error{ErrorCode::MalformedFile,
                 {},
                 worded("at a tolerance of %1 mm its curves need more than %2 points; check the "
                        "unit, and remove lines that belong to no piece",
                        {figure(kDxfChordTolerance, 3), figure(1.0 * kMaxCurvePoints)})};
}

std::optional<FileLine> dxfCurve(const DxfEntity& entity, double unit) {
    bool closed = false;
    const double scale = unit * entity.map.linear().norm();
    CurvePoints points =
        scale > 0 ? ownPoints(entity, kDxfChordTolerance / scale, closed) : CurvePoints();
    Eigen::AlignedBox2d box;
    for (Vector2d& point : points) {
        point = entity.map * point;
        box.extend(point);
        if (!point.allFinite()) {
            return {};
        }
    }
    if (points.size() < 2) {
        return {};
    }
    const bool isCurve =
        entity.kind != "LINE" && entity.kind != "POLYLINE" && entity.kind != "LWPOLYLINE";
    if (isCurve && (points.front() - points.back()).norm() <= kSameEnd * box.diagonal().norm()) {
        closed = true;
        points.pop_back();
    }
    FileLine line{Points2(static_cast<Eigen::Index>(points.size()), 2), closed};
    for (std::size_t k = 0; k < points.size(); ++k) {
        line.points.row(static_cast<Eigen::Index>(k)) = points[k].transpose();
    }
    return line;
}

namespace {

constexpr double kFarthestCell = 1e15;
constexpr int kMaxEnds = 32;  // tested per cell: more never meet in a pattern

Points2 withoutRepeated(const Points2& points, bool closed) {
    Points2 kept(points.rows(), 2);
    Eigen::Index count = 0;
    for (Eigen::Index k = 0; k < points.rows(); ++k) {
        if (count == 0 || kept.row(count - 1) != points.row(k)) {
            kept.row(count++) = points.row(k);
        }
    }
    while (closed && count > 1 && kept.row(count - 1) == kept.row(0)) {
        --count;
    }
    return kept.topRows(count);
}

/// Finds ends of open lines by position.
class LineEnds {
public:
    LineEnds(const std::vector<FileLine>& lines, double near) : lines_(lines), near_(near) {
        for (std::size_t k = 0; k < lines.size(); ++k) {
            if (!lines[k].closed && lines[k].points.rows() > 1) {
                cells_[cellOf(endOf(2 * k))].push_back(2 * k);
                cells_[cellOf(endOf(2 * k + 1))].push_back(2 * k + 1);
            }
        }
    }

    /// The nearest end, within reach, of a line that is not taken: 2 * line for its first point,
    /// 2 * line + 1 for its last; -1 if there is none.
    std::ptrdiff_t nearest(const Eigen::RowVector2d& place, const std::vector<char>& isTaken) {
        const auto [column, row] = cellOf(place);
        std::ptrdiff_t best = -1;
        double reach = near_;
        for (std::int64_t x = column - 1; x <= column + 1; ++x) {
            for (std::int64_t y = row - 1; y <= row + 1; ++y) {
                const auto cell = cells_.find({x, y});
                if (cell == cells_.end()) {
                    continue;
                }
                std::vector<std::size_t>& ends = cell->second;
                int looked = 0;
                for (std::size_t k = ends.size(); k-- > 0 && looked < kMaxEnds;) {
                    const std::size_t end = ends[k];
                    if (isTaken[end / 2] != 0) {
                        ends[k] = ends.back();
                        ends.pop_back();
                        continue;
                    }
                    ++looked;
                    const double distance = (endOf(end) - place).norm();
                    if (distance < reach || (distance <= near_ && best < 0)) {
                        reach = distance;
                        best = static_cast<std::ptrdiff_t>(end);
                    }
                }
            }
        }
        return best;
    }

private:
    using Cell = std::pair<std::int64_t, std::int64_t>;

    Eigen::RowVector2d endOf(std::size_t end) const {
        const Points2& points = lines_[end / 2].points;
        return points.row(end % 2 == 0 ? 0 : points.rows() - 1);
    }

    Cell cellOf(const Eigen::RowVector2d& place) const {
        const auto of = [this](double x) {
            return static_cast<std::int64_t>(
                std::floor(std::clamp(x / near_, -kFarthestCell, kFarthestCell)));
        };
        return {of(place.x()), of(place.y())};
    }

    const std::vector<FileLine>& lines_;
    double near_;
    std::map<Cell, std::vector<std::size_t>> cells_;
};

}  // namespace

std::vector<FileLine> joinedLines(const std::vector<FileLine>& lines, double near, double gap) {
    LineEnds ends(lines, near);
    std::vector<char> isTaken(lines.size(), 0);
    std::vector<FileLine> joined;
    for (std::size_t k = 0; k < lines.size(); ++k) {
        if (isTaken[k] != 0 || lines[k].points.rows() < 2) {
            continue;
        }
        isTaken[k] = 1;
        if (lines[k].closed) {
            joined.push_back({withoutRepeated(lines[k].points, true), true});
            continue;
        }
        std::vector<Points2> parts{lines[k].points};
        Eigen::Index count = parts.front().rows();
        // Extend the chain at its last end until it returns to its start.
        const Eigen::RowVector2d start = parts.front().row(0);
        while ((parts.back().row(parts.back().rows() - 1) - start).norm() > near) {
            const Eigen::RowVector2d place = parts.back().row(parts.back().rows() - 1);
            const std::ptrdiff_t end = ends.nearest(place, isTaken);
            if (end < 0) {
                break;
            }
            const Points2& next = lines[static_cast<std::size_t>(end / 2)].points;
            isTaken[static_cast<std::size_t>(end / 2)] = 1;
            parts.push_back(end % 2 == 0 ? next : Points2(next.colwise().reverse()));
            count += next.rows();
        }
        // Then extend it backwards at its first end, unless it is closed.
        std::vector<Points2> before;
        for (Eigen::RowVector2d place = start;;) {
            const Eigen::RowVector2d last = parts.back().row(parts.back().rows() - 1);
            const std::ptrdiff_t end =
                (last - place).norm() > near ? ends.nearest(place, isTaken) : -1;
            if (end < 0) {
                break;
            }
            const Points2& next = lines[static_cast<std::size_t>(end / 2)].points;
            isTaken[static_cast<std::size_t>(end / 2)] = 1;
            before.push_back(end % 2 == 1 ? next : Points2(next.colwise().reverse()));
            place = before.back().row(0);
            count += next.rows();
        }
        parts.insert(parts.begin(), before.rbegin(), before.rend());
        Points2 all(count, 2);
        Eigen::Index row = 0;
        for (const Points2& part : parts) {
            // Merge the ends of two parts into one point even if they differ slightly.
            const Eigen::Index skipped =
                row > 0 && (all.row(row - 1) - part.row(0)).norm() <= near ? 1 : 0;
            all.middleRows(row, part.rows() - skipped) = part.bottomRows(part.rows() - skipped);
            row += part.rows() - skipped;
        }
        const bool closes =
            row > 2 && (all.row(row - 1) - all.row(0)).norm() <= std::max(near, gap);
        if (closes && (all.row(row - 1) - all.row(0)).norm() <= near) {
            --row;
        }
        joined.push_back({withoutRepeated(all.topRows(row), closes), closes});
    }
    return joined;
}

Points2 mirroredAcross(const Points2& points, const FileChord& line) {
    const Eigen::Vector2d along = (line[1] - line[0]).normalized();
    const Eigen::RowVector2d across(-along.y(), along.x());
    const Eigen::VectorXd off = (points.rowwise() - line[0].transpose()) * across.transpose();
    return points - 2 * off * across;
}

Unfolded unfolded(const Points2& closed, const FileChord& mirror, double near) {
    const Eigen::Index n = closed.rows();
    const Eigen::Vector2d along = (mirror[1] - mirror[0]).normalized();
    if (n < 3 || !along.allFinite() || along.isZero()) {
        return {closed};
    }
    const Eigen::Vector2d across(-along.y(), along.x());
    const Eigen::VectorXd off = (closed.rowwise() - mirror[0].transpose()) * across;
    if (off.maxCoeff() > near && off.minCoeff() < -near) {
        return {closed};
    }
    const auto isOn = [&](Eigen::Index k) { return std::abs(off[k % n]) <= near; };
    // The longest run of edges along the mirror line, from point `first` on.
    Eigen::Index first = -1, steps = 0;
    double longest = near;
    for (Eigen::Index k = 0; k < n; ++k) {
        if (!isOn(k) || isOn(k + n - 1)) {
            continue;  // runs start where the point before is off the line
        }
        Eigen::Index count = 0;
        while (count + 1 < n && isOn(k + count + 1)) {
            ++count;
        }
        const double length = (closed.row((k + count) % n) - closed.row(k)).norm();
        if (count > 0 && length > longest) {
            first = k;
            steps = count;
            longest = length;
        }
    }
    if (first < 0) {
        return {closed};
    }
    // From the end of the run around to its start; then the image in reverse.
    const Eigen::Index kept = n - steps + 1;
    Points2 half(kept, 2);
    for (Eigen::Index k = 0; k < kept; ++k) {
        half.row(k) = closed.row((first + steps + k) % n);
    }
    const Points2 image = mirroredAcross(half, mirror).colwise().reverse();
    Points2 whole(2 * kept - 2, 2);
    whole << half, image.middleRows(1, kept - 2);
    return {whole, true};
}

}  // namespace toile
