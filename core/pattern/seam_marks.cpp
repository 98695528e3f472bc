// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/pattern/seam_marks.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <set>
#include <string_view>
#include <utility>

#include "core/geometry/line.h"
#include "core/geometry/polygon.h"
#include "core/geometry/segment.h"
#include "core/geometry/triangle_tree.h"

namespace toile {
namespace {

using Eigen::Vector2d;

constexpr double kTick = 5;          // mm; shorter on a short seam
constexpr double kTickOfSeam = 0.2;  // of the seam's length, at most
constexpr double kSameTick = 0.1;    // mm
/// Heights of numbers, mm, tried in turn.
constexpr std::array kNumberHeights{kLargestNumber, 5.0, 4.0, 3.5, 3.0, 2.5, 2.0, 1.5, 1.2, 1.0,
                                    kSmallestNumber};
/// Positions of the middle of a text, as parts of the seam's length.
constexpr std::array kPlacesAlong{0.5, 0.4, 0.6, 0.3, 0.7, 0.2, 0.8, 0.1, 0.9};
constexpr double kTextOfSeam = 0.8;     // of the seam's length that a text may take
constexpr double kStraightText = 0.95;  // chord to arc of the line under a text; less is a corner
constexpr double kOffEdge = 0.999;      // of the way from a text to its edge: excludes the edge
constexpr double kNameOff = 2;          // mm between number and name
constexpr double kRounding = 0x1p-22;
// In heights of a capital:
constexpr double kEdgeToText = 0.5;
constexpr double kAirAround = 0.25;  // kept free on each side

/// How far a line between two places bulges to the left of its chord.
double bulge(const geometry::Line& line, double from, double to, const Vector2d& left) {
    const Eigen::RowVector2d origin = line.pointAt(from);
    double largest = 0;
    for (int k = line.firstAfter(from); k < line.firstAfter(to); ++k) {
        largest = std::max(largest, (line.point(k) - origin).dot(left.transpose()));
    }
    return largest;
}

/// A box along an edge.
struct TurnedBox {
    Vector2d middle, along, half;

    Vector2d within(const Vector2d& point) const {
        const Vector2d way = point - middle;
        return {way.dot(along), way.dot(geometry::leftOf(along))};
    }
    bool meets(const Vector2d& a, const Vector2d& b) const {
        const Vector2d from = within(a);
        const auto share = geometry::shareInBox<Vector2d>(from, within(b) - from, -half, half);
        return share.first <= share.last;
    }
    std::array<Vector2d, 4> corners() const {
        const Vector2d x = half.x() * along, y = half.y() * geometry::leftOf(along);
        return {middle - x - y, middle + x - y, middle + x + y, middle - x + y};
    }
    bool meets(const TurnedBox& other) const {
        const auto rim = other.corners();
        for (std::size_t i = 0; i < rim.size(); ++i) {
            if (meets(rim[i], rim[(i + 1) % rim.size()])) {
                return true;
            }
        }
        return (other.within(middle).cwiseAbs().array() <= other.half.array()).all();
    }
};

/// Spatial index of the lines that texts keep clear of.
class LinesThere {
public:
    /// Call once all lines have been added.
    void finish() {
        std::vector<std::uint32_t> triangles;  // degenerate: segments
        triangles.reserve(3 * ends_.size());
        for (const auto& [a, b] : ends_) {
            triangles.insert(triangles.end(), {a, b, b});
        }
        tree_ = {coordinates_.data(), 2, triangles};
    }

    /// The inside of a closed line is blocked too.
    void addObstacle(const Points2& line) {
        add(line, false);
        if (line.rows() > 3 && line.row(0) == line.row(line.rows() - 1)) {
            taken_.push_back(line);
        }
    }

    void add(const Points2& line, bool isClosed) {
        const auto first = static_cast<std::uint32_t>(points_.size());
        for (Eigen::Index i = 0; i < line.rows(); ++i) {
            const Vector2d& point = points_.emplace_back(line.row(i).transpose());
            coordinates_.push_back(static_cast<float>(point.x()));
            coordinates_.push_back(static_cast<float>(point.y()));
            if (i > 0) {
                ends_.emplace_back(first + i - 1, first + i);
            }
        }
        if (isClosed && line.rows() > 0) {
            ends_.emplace_back(first + line.rows() - 1, first);
        }
    }

    bool meet(const TurnedBox& box) const {
        Vector2d low = box.middle, high = box.middle;
        for (const Vector2d& corner : box.corners()) {
            low = low.cwiseMin(corner);
            high = high.cwiseMax(corner);
        }
        // The boxes of the tree are rounded to floats.
        const Eigen::Vector2f from = (low - kRounding * low.cwiseAbs()).cast<float>();
        const Eigen::Vector2f to = (high + kRounding * high.cwiseAbs()).cast<float>();
        bool isMet = false;
        const auto distanceTo = [&](const Tree::Box& there) {
            const bool isNear = !isMet && there.low[0] <= to.x() && there.high[0] >= from.x() &&
                                there.low[1] <= to.y() && there.high[1] >= from.y();
            return isNear ? 0.0 : Tree::kMissed;
        };
        tree_.search(distanceTo, [&](std::uint32_t edge) {
            const auto& [a, b] = ends_[edge];
            isMet = isMet || box.meets(points_[a], points_[b]);
        });
        return isMet || std::ranges::any_of(taken_, [&box](const Points2& line) {
                   return geometry::isInside(line, box.middle);
               });
    }

private:
    using Tree = geometry::TriangleTree<2>;

    std::vector<Points2> taken_;

    std::vector<Vector2d> points_;
    std::vector<float> coordinates_;
    std::vector<std::pair<std::uint32_t, std::uint32_t>> ends_;
    Tree tree_;
};

/// The ticks of all seams of a piece.
class SeamTicks {
public:
    /// A tick at `from`, at right angles to the way to `towards`, `size` to its left.
    std::optional<Chord> tick(const Vector2d& from, const Vector2d& towards, double size) {
        const Vector2d way = towards - from;
        if (!(way.norm() > 0)) {
            return std::nullopt;
        }
        const Chord tick{from, from + size * geometry::leftOf(way.normalized())};
        for (const Chord& other : ticks_) {
            if ((tick.from - other.from).norm() < kSameTick &&
                (tick.to - other.to).norm() < kSameTick) {
                return std::nullopt;  // a seam ends here, straight on
            }
        }
        ticks_.push_back(tick);
        return tick;
    }

private:
    std::vector<Chord> ticks_;
};

Points2 tickLine(const Chord& chord) {
    Points2 line(2, 2);
    line << chord.from.transpose(), chord.to.transpose();
    return line;
}

/// Writes number and name along the edges, seam by seam.
class SeamTexts {
public:
    explicit SeamTexts(const LinesThere& lines) : lines_(lines) {}

    void write(SeamMark& mark, const geometry::Line& line, const std::string& name) {
        SeamMark named = mark;
        named.name = name;
        const double numbers[] = {textExtent({numberText(mark)}, 1).x(),
                                  textExtent({numberText(named)}, 1).x()};
        const double withName = kNameOff + textExtent({name}, kSeamNameHeight).x();
        for (const double height : kNumberHeights) {
            for (const bool isNamed : {true, false}) {
                const double number = numbers[isNamed ? 1 : 0];
                const double width = number * height + (isNamed ? withName : 0);
                if ((isNamed && (name.empty() || height < kSeamNameHeight)) ||
                    width > kTextOfSeam * line.length()) {
                    continue;
                }
                for (const double share : kPlacesAlong) {
                    if (const auto row = freeRow(line, share * line.length(), width, height)) {
                        place(mark, *row, number * height, width, height, isNamed ? name : "");
                        return;
                    }
                }
            }
        }
    }

private:
    /// A box for texts at a place of the line; nothing if the box is not free.
    std::optional<TurnedBox> freeRow(const geometry::Line& line, double at, double width,
                                     double height) const {
        const double from = at - 0.5 * width, to = at + 0.5 * width;
        if (from < 0 || to > line.length()) {
            return std::nullopt;
        }
        const Vector2d before = line.pointAt(from), after = line.pointAt(to);
        const Vector2d way = after - before;
        if (!(way.norm() > kStraightText * width)) {
            return std::nullopt;
        }
        const Vector2d left = geometry::leftOf(way.normalized());
        // Keep clear of an edge that bulges into the cloth under the text.
        const double off = bulge(line, from, to, left) + (kEdgeToText + 0.5) * height;
        const double air = kAirAround * height;
        const TurnedBox row{0.5 * (before + after) + off * left, way.normalized(),
                            Vector2d(0.5 * width + air, 0.5 * height + air)};
        // No other line may lie between the edge and the text.
        const Vector2d stalk = row.middle - line.pointAt(at).transpose();
        const TurnedBox between{row.middle - 0.5 * kOffEdge * stalk, stalk.normalized(),
                                Vector2d(0.5 * kOffEdge * stalk.norm(), 0)};
        const bool isFree = !lines_.meet(row) && !lines_.meet(between) &&
                            std::ranges::none_of(
                                rows_, [&row](const TurnedBox& other) { return row.meets(other); });
        return isFree ? std::optional(row) : std::nullopt;
    }

    void place(SeamMark& mark, const TurnedBox& row, double number, double width, double height,
               const std::string& name) {
        rows_.push_back(row);
        mark.angle = readableAngle(std::atan2(row.along.y(), row.along.x()));
        const Vector2d onwards(std::cos(mark.angle), std::sin(mark.angle));
        mark.numberPlace = {row.middle + 0.5 * (number - width) * onwards, height};
        if (!name.empty()) {
            const double half = 0.5 * textExtent({name}, kSeamNameHeight).x();
            mark.namePlace = {row.middle + (0.5 * width - half) * onwards, kSeamNameHeight};
            mark.name = name;
        }
    }

    const LinesThere& lines_;
    std::vector<TurnedBox> rows_;
};

/// The number as read upside down; empty if that is no number.
std::string upsideDown(const std::string& number) {
    std::string turned;
    for (const char digit : number) {
        const std::size_t at = std::string_view("0689").find(digit);
        if (at == std::string_view::npos) {
            return {};
        }
        turned.insert(turned.begin(), "0986"[at]);
    }
    return turned.front() == '0' ? std::string() : turned;
}

}  // namespace

std::string numberText(const SeamMark& mark) {
    std::string number = std::to_string(mark.number);
    const std::string turned = mark.name.empty() ? upsideDown(number) : std::string();
    return turned.empty() || turned == number ? number : number + ".";
}

std::vector<SeamMark> seamMarks(const PatternPiece& piece, const Placement& placement,
                                const std::vector<Points2>& obstacles) {
    std::vector<SeamMark> marks;
    std::vector<geometry::Line> lines;
    std::vector<const SeamLine*> seams;
    std::set<int> numbers;
    SeamTicks ticks;
    LinesThere there;
    there.add(turnedLine(piece.outline, placement), true);
    for (const Points2& hole : piece.holes) {
        there.add(turnedLine(hole, placement), true);
    }
    for (const Points2& obstacle : obstacles) {
        there.addObstacle(obstacle);
    }
    for (const SeamLine& seam : piece.seams) {
        if (seam.kind == SeamKind::Free || seam.line.rows() < 2) {
            continue;
        }
        auto line = geometry::Line::open(turnedLine(seam.line, placement));
        const double length = line.length();
        if (!(length > 0)) {
            continue;
        }
        SeamMark& mark = marks.emplace_back();
        mark.number = seam.number;
        mark.second = !numbers.insert(seam.number).second;
        const double tick = std::min(kTick, kTickOfSeam * length);
        // On a mirrored piece the line starts at its end.
        const bool isAtFold[] = {seam.isAtFold[placement.mirrored ? 1 : 0],
                                 seam.isAtFold[placement.mirrored ? 0 : 1]};
        if (!isAtFold[0]) {
            mark.ticks[0] = ticks.tick(line.pointAt(0), line.pointAt(tick), tick);
        }
        if (!seam.closed && !isAtFold[1]) {
            // Seen backwards from the end, the cloth is on the right.
            mark.ticks[1] = ticks.tick(line.pointAt(length), line.pointAt(length - tick), -tick);
        }
        for (const auto& made : mark.ticks) {
            if (made) {
                there.add(tickLine(*made), false);
            }
        }
        lines.push_back(std::move(line));
        seams.push_back(&seam);
    }
    there.finish();
    SeamTexts texts(there);
    for (std::size_t i = 0; i < marks.size(); ++i) {
        texts.write(marks[i], lines[i], seams[i]->name);
    }
    return marks;
}

void addObstacles(const SeamMark& mark, std::vector<Points2>& obstacles) {
    for (const auto& tick : mark.ticks) {
        if (tick) {
            obstacles.push_back(tickLine(*tick));
        }
    }
    if (mark.numberPlace) {
        const double air = kAirAround * mark.numberPlace->height;
        obstacles.push_back(textBox(*mark.numberPlace, {numberText(mark)}, mark.angle, air));
    }
    if (mark.namePlace) {
        const double air = kAirAround * mark.namePlace->height;
        obstacles.push_back(textBox(*mark.namePlace, {mark.name}, mark.angle, air));
    }
}

double readableAngle(double angle) {
    const bool isUpsideDown =
        angle > 0.5 * std::numbers::pi + 1e-9 || angle <= -0.5 * std::numbers::pi + 1e-9;
    return !isUpsideDown ? angle : angle + (angle > 0 ? -std::numbers::pi : std::numbers::pi);
}

}  // namespace toile
