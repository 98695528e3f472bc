// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/reading/joined_lines.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <utility>

namespace toile {
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
