// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/pattern/piece_marks.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>
#include <utility>

#include "core/geometry/segment.h"
#include "core/pattern/half_pattern.h"

namespace toile {

std::string cuttingNote(const Cutting& cutting, const DrawingWords& words, CutAs cutAs) {
    const bool isOnFold = cutAs == CutAs::OnFold;
    const bool isPair = !isOnFold && (cutting.mirroredPair || cutAs == CutAs::Pair);
    if (cutting.quantity == 1 && !isOnFold) {
        return isPair ? words.cutPair : std::string();
    }
    std::string note = isOnFold ? words.cutOnFold : isPair ? words.cutPairs : words.cut;
    const int count = cutting.quantity * (isOnFold && cutting.mirroredPair ? 2 : 1);
    if (const std::size_t place = note.find("%1"); place != std::string::npos) {
        note.replace(place, 2, std::to_string(count));
    }
    return note;
}

std::vector<std::string> labelLines(const std::string& name, const Cutting& cutting, bool mirrored,
                                    const DrawingWords& words, CutAs cutAs) {
    std::vector<std::string> lines{name};
    if (std::string note = cuttingNote(cutting, words, cutAs); !note.empty()) {
        lines.push_back(std::move(note));
    }
    lines.push_back(words.noAllowance);
    if (mirrored) {
        lines.push_back(words.mirrored);
    }
    return lines;
}

PieceMarks placeMarks(const PatternPiece& piece, const Placement& placement,
                      const std::vector<std::string>& lines, double grain) {
    std::vector<Points2> loops{turnedLine(piece.outline, placement)};
    for (const Points2& hole : piece.holes) {
        loops.push_back(turnedLine(hole, placement));
    }
    PieceMarks marks;
    marks.label = placeLabel(loops, lines);
    const Eigen::Vector2d size = textExtent(lines, marks.label.height);
    const Eigen::Vector2d top = marks.label.position + Eigen::Vector2d(0, 0.5 * marks.label.height);
    const Eigen::AlignedBox2d words(Eigen::Vector2d(top.x() - 0.5 * size.x(), top.y() - size.y()),
                                    Eigen::Vector2d(top.x() + 0.5 * size.x(), top.y()));
    const double direction = directionOnSheet(placement, grain);
    marks.grain = grainLine(loops, direction, words);
    if (!marks.grain) {
        marks.grain = grainLine(loops, direction, {});  // no room beside the label: through it
    }
    return marks;
}

namespace {

constexpr double kTick = 5;             // mm; shorter on a short seam
constexpr double kTickOfSeam = 0.2;     // of the seam's length, at most
constexpr double kNameHeight = 2.5;     // mm, of a capital
constexpr double kSmallestText = 0.8;   // mm: what cannot be read is not written
constexpr double kNameOfSeam = 0.8;     // of the seam's length that a text may take
constexpr double kOffCut = 1.2;         // capital heights between the outline and the text's middle
constexpr double kSameTick = 0.1;       // mm
constexpr double kFoldOff = 8;          // mm: the bracket from the fold,
constexpr double kFoldOffOfEdge = 0.1;  // at most so much of the fold's length
constexpr double kFoldHead = 0.4;       // of that: an arrow head
constexpr double kFoldFrom = 0.2;       // of the fold's length: where the arrows are

double lengthOf(const Points2& line) {
    double length = 0;
    for (Eigen::Index i = 1; i < line.rows(); ++i) {
        length += (line.row(i) - line.row(i - 1)).norm();
    }
    return length;
}

/// The point at an arc length.
Eigen::Vector2d pointAt(const Points2& line, double arc) {
    for (Eigen::Index i = 1; i < line.rows(); ++i) {
        const double step = (line.row(i) - line.row(i - 1)).norm();
        if (arc <= step && step > 0) {
            return (line.row(i - 1) + arc / step * (line.row(i) - line.row(i - 1))).transpose();
        }
        arc -= step;
    }
    return line.bottomRows<1>().transpose();
}

/// The same line for a text, which is never upside down.
double readable(double angle) {
    const bool isUpsideDown =
        angle > 0.5 * std::numbers::pi + 1e-9 || angle <= -0.5 * std::numbers::pi + 1e-9;
    return !isUpsideDown ? angle : angle + (angle > 0 ? -std::numbers::pi : std::numbers::pi);
}

/// Marks the seams of one piece, one after the other.
class SeamMarker {
public:
    explicit SeamMarker(const Placement& placement) : placement_(placement) {}

    std::optional<SeamMark> mark(const SeamLine& seam) {
        const Points2 line = turnedLine(seam.line, placement_);
        const double length = lengthOf(line);
        if (!(length > 0)) {
            return std::nullopt;
        }
        SeamMark mark;
        mark.number = seam.number;
        mark.second = !numbers_.insert(seam.number).second;
        const double tick = std::min(kTick, kTickOfSeam * length);
        // Of a mirrored piece the line runs from its end.
        const bool isAtFold[] = {seam.isAtFold[placement_.mirrored ? 1 : 0],
                                 seam.isAtFold[placement_.mirrored ? 0 : 1]};
        if (!isAtFold[0]) {
            mark.ticks[0] = this->tick(pointAt(line, 0), pointAt(line, tick), tick);
        }
        if (!seam.closed && !isAtFold[1]) {
            // Seen from the end backwards the cloth is on the right.
            mark.ticks[1] = this->tick(pointAt(line, length), pointAt(line, length - tick), -tick);
        }
        addText(mark, line, length, seam.name);
        return mark;
    }

private:
    /// A tick at `from`, square to the way towards `towards`, `size` to its left.
    std::optional<Chord> tick(const Eigen::Vector2d& from, const Eigen::Vector2d& towards,
                              double size) {
        const Eigen::Vector2d way = towards - from;
        if (!(way.norm() > 0)) {
            return std::nullopt;
        }
        const Chord tick{from, from + size * geometry::leftOf(way.normalized())};
        for (const Chord& other : ticks_) {
            if ((tick.from - other.from).norm() < kSameTick &&
                (tick.to - other.to).norm() < kSameTick) {
                return std::nullopt;  // the seam before ends here, straight on
            }
        }
        ticks_.push_back(tick);
        return tick;
    }

    static void addText(SeamMark& mark, const Points2& line, double length,
                        const std::string& name) {
        const std::string number = std::to_string(mark.number);
        std::string words = number + "  " + name;
        double height = kNameHeight;
        if (textExtent({words}, height).x() > kNameOfSeam * length) {
            words = number;
            height = std::min(height, kNameOfSeam * length / textExtent({words}, 1).x());
        }
        if (height < kSmallestText) {
            return;
        }
        const double half = 0.5 * textExtent({words}, height).x();
        const Eigen::Vector2d before = pointAt(line, std::max(0.0, 0.5 * length - half));
        const Eigen::Vector2d after = pointAt(line, std::min(length, 0.5 * length + half));
        Eigen::Vector2d along = after - before;
        if (!(along.norm() > 0)) {
            return;
        }
        along.normalize();
        // Clear of an edge that bulges into the cloth under the text.
        double bulge = 0;
        for (Eigen::Index i = 0; i < line.rows(); ++i) {
            const Eigen::Vector2d p = line.row(i).transpose() - before;
            const double place = p.dot(along);
            if (place > 0 && place < 2 * half) {
                bulge = std::max(bulge, p.dot(geometry::leftOf(along)));
            }
        }
        mark.place = {0.5 * (before + after) + (bulge + kOffCut * height) * geometry::leftOf(along),
                      height};
        mark.angle = readable(std::atan2(along.y(), along.x()));
        mark.text = std::move(words);
    }

    const Placement& placement_;
    std::set<int> numbers_;
    std::vector<Chord> ticks_;
};

}  // namespace

std::vector<SeamMark> seamMarks(const PatternPiece& piece, const Placement& placement) {
    SeamMarker marker(placement);
    std::vector<SeamMark> marks;
    for (const SeamLine& seam : piece.seams) {
        if (seam.kind != SeamKind::Free) {
            if (auto mark = marker.mark(seam)) {
                marks.push_back(std::move(*mark));
            }
        }
    }
    return marks;
}

FoldMark foldMark(const PatternPiece& piece, const Placement& placement, const std::string& words) {
    const Chord fold = foldOf(piece);
    Points2 chord(2, 2);
    chord << fold.from.transpose(), fold.to.transpose();
    chord = turnedLine(chord, placement);
    const Eigen::Vector2d from = chord.row(0), way = (chord.row(1) - chord.row(0)).transpose();
    const double length = way.norm();
    const Eigen::Vector2d along = way.normalized(), inwards = geometry::leftOf(along);
    const double off = std::min(kFoldOff, kFoldOffOfEdge * length), head = kFoldHead * off;
    const auto at = [&](double share, double aside, double in) -> Eigen::RowVector2d {
        return (from + share * way + aside * along + in * inwards).transpose();
    };
    FoldMark mark;
    mark.path.resize(10, 2);
    Eigen::Index row = 0;
    const auto addArrow = [&](double share) {
        for (const double aside : {-head, 0.0, head}) {
            mark.path.row(row++) = at(share, aside, std::abs(aside));
        }
    };
    addArrow(kFoldFrom);
    mark.path.row(row++) = at(kFoldFrom, 0, 0);
    mark.path.row(row++) = at(kFoldFrom, 0, off);
    mark.path.row(row++) = at(1 - kFoldFrom, 0, off);
    mark.path.row(row++) = at(1 - kFoldFrom, 0, 0);
    addArrow(1 - kFoldFrom);
    const double room = (1 - 2 * kFoldFrom) * length;
    const double height = std::min(kNameHeight, room / textExtent({words}, 1).x());
    mark.place = {at(0.5, 0, off + kOffCut * height).transpose(), height};
    mark.angle = readable(std::atan2(along.y(), along.x()));
    return mark;
}

}  // namespace toile
