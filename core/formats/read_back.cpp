// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/read_back.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "core/base/text.h"
#include "core/geometry/line.h"
#include "core/geometry/segment.h"

namespace toile {
namespace {

struct Nearest {
    double cost = std::numeric_limits<double>::infinity();
    double distance = cost;
    double at = 0;  ///< arc length
};

/// A line may pass a place twice, as at a slit: the passage near the arc length is used.
constexpr double kPerLength = 1e-3;  // of the distance, for each mm along the line

void take(Nearest& best, const geometry::Line& line, int k, const Eigen::RowVector2d& point,
          double expected) {
    const Eigen::RowVector2d a = line.point(k), b = line.point(k + 1);
    const double share = geometry::nearestShare(point, a, b);
    const double distance = (a + share * (b - a) - point).norm();
    const double at = line.arc()[k] + share * (line.arc()[k + 1] - line.arc()[k]);
    const double cost = distance + kPerLength * std::abs(at - expected);
    if (cost < best.cost) {
        best = {cost, distance, at};
    }
}

/// Maximum difference of arc length between key points and their line, over the whole line, mm.
constexpr double kSlack = 5;

/// The nearest point of a line near an arc length.
Nearest nearestAround(const geometry::Line& line, double at, const Eigen::RowVector2d& point) {
    Nearest best;
    const auto look = [&](double from, double to, double expected) {
        for (int k = from > 0 ? line.edgeAt(from) : 0;
             k < line.arc().edgeCount() && line.arc()[k] <= to; ++k) {
            take(best, line, k, point, expected);
        }
    };
    const double middle = line.wrap(at);
    look(middle - kSlack, middle + kSlack, middle);
    if (line.isClosed() && middle < kSlack) {
        look(line.length() + middle - kSlack, line.length(), line.length() + middle);
    }
    if (line.isClosed() && middle > line.length() - kSlack) {
        look(0, middle + kSlack - line.length(), middle - line.length());
    }
    return best;
}

/// @param start  arc length on `line` of the first point of `points`
/// @param enough  mm, beyond which the exact distance is irrelevant
double farthestFrom(const geometry::Line& line, const geometry::Line& points, double start,
                    double enough) {
    double farthest = 0;
    for (int k = 0; k < points.count() && farthest <= enough; ++k) {
        const double at = start + points.arc()[k];
        farthest = std::max(farthest, nearestAround(line, at, points.point(k)).distance);
    }
    return farthest;
}

/// Possible starts of a line on another one that passes there repeatedly, the nearest place first.
std::vector<Nearest> startsOn(const geometry::Line& line, const Eigen::RowVector2d& first) {
    if (!line.isClosed()) {
        return {Nearest()};
    }
    std::vector<Nearest> starts;
    Nearest best;
    for (int k = 0; k < line.arc().edgeCount(); ++k) {
        Nearest here;
        take(here, line, k, first, line.arc()[k]);
        if (here.distance < kReadBackCoordinates &&
            (starts.empty() || here.at - starts.back().at > kSlack)) {
            starts.push_back(here);
        }
        best = here.distance < best.distance ? here : best;
    }
    std::ranges::stable_sort(starts, {}, &Nearest::distance);
    return starts.empty() ? std::vector{best} : starts;
}

/// The match of a line of a file with its drawn line.
struct Matched {
    double distance = std::numeric_limits<double>::infinity();
    double start = 0;  ///< of the read line, on the drawn one
};

Matched matched(const geometry::Line& read, const geometry::Line& drawn, bool hasKeyPoints) {
    Matched best;
    if (read.count() == 0 || drawn.count() == 0) {
        return best;
    }
    for (const Nearest& start : startsOn(drawn, read.point(0))) {
        double distance = farthestFrom(drawn, read, start.at, best.distance);
        if (!hasKeyPoints && distance < best.distance) {
            distance = std::max(distance, farthestFrom(read, drawn, -start.at, best.distance));
        }
        if (distance < best.distance) {
            best = {distance, start.at};
        }
    }
    return best;
}

std::string millimetres(double value) {
    return std::isfinite(value) ? fixed(value, 3) + " mm" : "no length";
}

bool isCompared(const std::vector<LayerKind>& layers, LayerKind layer) {
    return std::ranges::find(layers, layer) != layers.end();
}

/// The lines of a file in the order of the drawing's; an error if any has no counterpart.
Result<std::vector<const ReadLine*>> inOrder(const ReadDrawing& read, const Drawing& drawing,
                                             const std::vector<LayerKind>& layers) {
    std::map<std::string, const ReadLine*> byId;
    std::map<LayerKind, std::vector<const ReadLine*>> byLayer;
    for (const ReadLine& line : read.lines) {
        if (!line.id.empty() && !byId.emplace(line.id, &line).second) {
            return notReadBack(line.id, "it occurs twice");
        }
        if (line.id.empty()) {
            byLayer[line.layer].push_back(&line);
        }
    }
    std::map<LayerKind, std::size_t> next;
    std::vector<const ReadLine*> found(drawing.paths.size(), nullptr);
    std::size_t count = 0;
    for (std::size_t k = 0; k < drawing.paths.size(); ++k) {
        const DrawnPath& path = drawing.paths[k];
        if (!isCompared(layers, path.layer)) {
            continue;
        }
        if (const auto named = byId.find(path.id); named != byId.end()) {
            found[k] = named->second;
        } else if (std::size_t& place = next[path.layer]; place < byLayer[path.layer].size()) {
            found[k] = byLayer[path.layer][place++];
        }
        if (!found[k]) {
            return notReadBack(path.id, "it is missing");
        }
        ++count;
    }
    if (count != read.lines.size()) {
        return notReadBack(drawing.title,
                           countWording(static_cast<long long>(read.lines.size()), "line") +
                               " instead of " + std::to_string(count));
    }
    return found;
}

/// Length tolerance, mm: on very long lines the rounding of many points adds up.
double allowedOf(double length) {
    return std::max(kReadBackLengths, kReadBackLengthShare * length);
}

/// The standard deviation of a line's length if its points are rounded independently to a grid. A
/// shift of a point along one edge is cancelled along the next, except for the turn between them.
double roundingOf(const DrawnPath& path, double grid) {
    const Points2& points = path.points;
    const Eigen::Index n = points.rows();
    const auto direction = [&](Eigen::Index k) -> Eigen::RowVector2d {
        return (points.row((k + 1) % n) - points.row(k % n)).normalized();
    };
    double turns = 0;
    for (Eigen::Index k = 1; k < (path.closed ? n + 1 : n - 1); ++k) {
        turns += (direction(k) - direction(k - 1)).squaredNorm();
    }
    return grid * std::sqrt(turns / 12);
}

/// Length of a side of a seam along the line of the file.
double lengthOn(const geometry::Line& read, const geometry::Line& drawn, double start,
                const DrawnEdge& edge) {
    const double first = nearestAround(read, edge.from - start, drawn.pointAt(edge.from)).at;
    const double second = nearestAround(read, edge.to - start, drawn.pointAt(edge.to)).at;
    const double length = second - first;
    // If it passes the first point, or goes all the way round: its ends may coincide.
    const double missing = edge.to - edge.from - length;
    return read.isClosed() && read.length() > 0
               ? length + std::round(missing / read.length()) * read.length()
               : length;
}

}  // namespace

Error notReadBack(std::string_view subject, const std::string& what) {
    return {
        ErrorCode::NotReadBack, {}, std::string(subject) + (subject.empty() ? "" : ": ") + what};
}

std::string readBackSentence(const ReadBack& found) {
    if (found.dots[0] > 0) {
        return "read back: " + std::to_string(found.dots[0]) + " x " +
               std::to_string(found.dots[1]) + " dots";
    }
    return "read back: " + counted(found.pieces, "piece") + ", largest difference " +
           fixed(found.largest, 3) + " mm";
}

double distanceBetween(const ReadLine& read, const DrawnPath& path) {
    return matched({read.points, read.closed}, {path.points, path.closed}, read.hasKeyPoints)
        .distance;
}

Result<ReadBack> comparedWithDrawing(const ReadDrawing& read, const Drawing& drawing,
                                     const std::vector<LayerKind>& layers, double grid) {
    if (read.pieces != static_cast<int>(drawing.blocks.size())) {
        return notReadBack(drawing.title, counted(read.pieces, "piece") + " instead of " +
                                              std::to_string(drawing.blocks.size()));
    }
    const auto lines = inOrder(read, drawing, layers);
    if (!lines) {
        return lines.error();
    }
    ReadBack found{read.pieces};
    for (std::size_t k = 0; k < drawing.paths.size(); ++k) {
        const DrawnPath& path = drawing.paths[k];
        const ReadLine* line = (*lines)[k];
        if (!line) {
            continue;
        }
        if (line->closed != path.closed) {
            return notReadBack(path.id, path.closed ? "it is not closed" : "it is closed");
        }
        const geometry::Line is(line->points, line->closed), should(path.points, path.closed);
        const auto [distance, start] = matched(is, should, line->hasKeyPoints);
        if (!(distance <= kReadBackCoordinates)) {
            return notReadBack(path.id, millimetres(distance) + " from its place");
        }
        found.largest = std::max(found.largest, distance);
        const double rounded = grid > 0 ? kReadBackRounding * roundingOf(path, grid) : 0;
        int sides = 0;
        for (const DrawnEdge& edge : drawing.edges) {
            if (edge.path != static_cast<int>(k)) {
                continue;
            }
            const double length = edge.to - edge.from;
            const double difference = lengthOn(is, should, start, edge) - length;
            if (!(std::abs(difference) <= std::max(rounded, allowedOf(length)))) {
                return notReadBack(edge.id, "longer by " + millimetres(difference));
            }
            found.largest = std::max(found.largest, std::abs(difference));
            ++found.seams;
            ++sides;
        }
        const double allowed =
            line->hasKeyPoints ? kReadBackLengths * std::max({sides, line->stretches, 1}) : 0;
        if (const double difference = is.length() - should.length();
            path.closed &&
            !(std::abs(difference) <= std::max({allowed, rounded, allowedOf(should.length())}))) {
            return notReadBack(path.id, "longer by " + millimetres(difference));
        }
    }
    return found;
}

}  // namespace toile
