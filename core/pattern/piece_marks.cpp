// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/pattern/piece_marks.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/base/characters.h"
#include "core/geometry/polygon.h"
#include "core/geometry/segment.h"
#include "core/pattern/darts.h"
#include "core/pattern/half_pattern.h"
#include "core/pattern/internal_lines.h"
#include "core/pattern/notch_mark.h"

namespace toile {

namespace {

std::string filled(std::string text, const std::string& place, const std::string& words) {
    if (const std::size_t at = text.find(place); at != std::string::npos) {
        text.replace(at, place.size(), words);
    }
    return text;
}

}  // namespace

std::string cuttingNote(const Cutting& cutting, const DrawingWords& words, CutAs cutAs) {
    const bool isOnFold = cutAs == CutAs::OnFold;
    const bool isPair = !isOnFold && (cutting.mirroredPair || cutAs == CutAs::Pair);
    if (cutting.quantity == 1 && !isOnFold) {
        return isPair ? words.cutPair : std::string();
    }
    const int count = cutting.quantity * (isOnFold && cutting.mirroredPair ? 2 : 1);
    return filled(isOnFold ? words.cutOnFold
                  : isPair ? words.cutPairs
                           : words.cut,
                  "%1", std::to_string(count));
}

std::vector<std::string> labelLines(const std::string& name, const Cutting& cutting, bool mirrored,
                                    const DrawingWords& words, CutAs cutAs,
                                    const LabelFacts& facts) {
    std::vector<std::string> lines{name};
    const auto add = [&lines](std::string line) {
        if (!line.empty()) {
            lines.push_back(std::move(line));
        }
    };
    if (facts.number > 0 && facts.count > 0) {
        add(filled(filled(words.pieceNumber, "%1", std::to_string(facts.number)), "%2",
                   std::to_string(facts.count)));
    }
    if (!facts.size.empty()) {
        add(filled(words.size, "%1", facts.size));
    }
    add(facts.material);
    add(cuttingNote(cutting, words, cutAs));
    add(facts.hasAllowance ? words.allowance : facts.isDrawnOut ? "" : words.noAllowance);
    add(facts.date);
    if (mirrored) {
        add(words.mirrored);
    }
    return lines;
}

LabelFacts factsOf(const Pattern& pattern, const PatternPiece& piece) {
    LabelFacts facts;
    if (pattern.hasAllowance) {
        facts = {.number = piece.number, .count = drawnCount(pattern), .hasAllowance = true};
    }
    facts.isDrawnOut = !piece.extensions.empty();
    facts.size = shownText(pattern.label.size, kMaxLabelText);
    facts.material = shownText(piece.material, kMaxLabelText);
    facts.date = shownText(pattern.label.date, kMaxLabelText);
    return facts;
}

std::vector<Points2> drawnOnCloth(const Pattern& pattern, const PatternPiece& piece) {
    std::vector<Points2> lines;
    for (const std::vector<Points2>& strokes : notchMarks(pattern, piece)) {
        lines.insert(lines.end(), strokes.begin(), strokes.end());
    }
    for (const PieceInternal& internal : piece.internals) {
        const std::vector<Points2> drawn = drawnLines(internal);
        lines.insert(lines.end(), drawn.begin(), drawn.end());
    }
    for (const PieceDart& dart : piece.darts) {
        const DartMarks marks = dartMarks(dart);
        for (const Points2& line : {marks.fold, marks.drill, marks.cross[0], marks.cross[1]}) {
            if (line.rows() > 1) {
                lines.push_back(line);
            }
        }
    }
    return lines;
}

int drawnCount(const Pattern& pattern) {
    const auto isDrawn = [](const PatternPiece& piece) { return piece.outline.rows() > 0; };
    return static_cast<int>(std::ranges::count_if(pattern.pieces, isDrawn) +
                            std::ranges::count_if(pattern.facings, isDrawn, &FacingPiece::strip));
}

namespace {

constexpr double kAirOfLabel = 0.5;  // capital heights between label and grain line
constexpr double kGoodLabel = 3;     // mm: a larger one never replaces a number
constexpr double kClearlyLarger = 1.2;
constexpr double kGoodGrain = 180;      // mm: no need for a longer one
constexpr double kFoldText = 2.5;       // mm, of a capital
constexpr double kOffFold = 1.2;        // capital heights between the bracket and the text's middle
constexpr double kFoldOff = 8;          // mm: distance of the bracket from the fold,
constexpr double kFoldOffOfEdge = 0.1;  // at most this part of the fold's length
constexpr double kFoldHead = 0.4;       // arrow head, part of that distance
constexpr double kFoldFrom = 0.2;       // of the fold's length: position of the arrows
constexpr double kSmallestMarked = 100;  // mm²: no label or grain line on a smaller piece

double lengthOf(const std::optional<Chord>& line) {
    return line ? (line->to - line->from).norm() : 0;
}

/// The box that is kept free for the words of a fold, for any words.
Points2 foldRoom(const FoldMark& mark) {
    const Eigen::RowVector2d from = mark.path.row(3), to = mark.path.row(6);
    const Eigen::Vector2d along = (to - from).transpose().normalized();
    const Eigen::RowVector2d in =
        (kOffFold + 0.75) * kFoldText * geometry::leftOf(along).transpose();
    Points2 room(5, 2);
    room << from, to, to + in, from + in, from;
    return room;
}

double numberHeight(const SeamMark& mark) {
    return mark.numberPlace ? mark.numberPlace->height : 0;
}

/// Places the seam numbers, and the label where it is largest beside them. If the label is small,
/// it is placed first instead, unless that makes a number smaller than the label then is.
/// @param lines  of the label
void placeNumbersAndLabel(PieceMarks& marks, const PatternPiece& piece, const Placement& placement,
                          const FreeCloth& cloth, const std::vector<std::string>& lines) {
    std::vector<Points2> there = cloth.obstacles;
    marks.seams = seamMarks(piece, placement, there);
    for (const SeamMark& mark : marks.seams) {
        addObstacles(mark, there);
    }
    marks.label = placeLabel(cloth.loops, lines, there);
    if (marks.label.height >= kGoodLabel) {
        return;
    }
    PieceMarks other;
    there = cloth.obstacles;
    for (SeamMark mark : marks.seams) {
        mark.numberPlace = mark.namePlace = std::nullopt;
        addObstacles(mark, there);
    }
    other.label = placeLabel(cloth.loops, lines, there);
    if (!other.label.fits || other.label.height < kClearlyLarger * marks.label.height) {
        return;
    }
    there = cloth.obstacles;
    there.push_back(textBox(other.label, lines, 0, kAirOfLabel * other.label.height));
    other.seams = seamMarks(piece, placement, there);
    for (std::size_t i = 0; i < marks.seams.size(); ++i) {
        if (numberHeight(other.seams[i]) <
            std::min(numberHeight(marks.seams[i]), other.label.height)) {
            return;
        }
    }
    marks = std::move(other);
}

/// Places the grain line beside the label. If that makes it short, the grain line is placed first
/// instead, if the smaller of both, relative to its size alone, becomes larger. If neither leaves
/// room for the other, the grain line runs through the label.
void placeGrain(PieceMarks& marks, FreeCloth cloth, const std::vector<std::string>& lines,
                double direction) {
    for (const SeamMark& mark : marks.seams) {
        addObstacles(mark, cloth.obstacles);
    }
    cloth.obstacles.push_back(textBox(marks.label, lines, 0, kAirOfLabel * marks.label.height));
    marks.grain = grainLine(cloth, direction);
    if (lengthOf(marks.grain) >= kGoodGrain) {
        return;
    }
    cloth.obstacles.pop_back();
    const std::optional<Chord> alone = grainLine(cloth, direction);
    if (!alone) {
        return;
    }
    cloth.obstacles.push_back(arrowPath(*alone));
    const LabelPlace beside = placeLabel(cloth.loops, lines, cloth.obstacles);
    if (beside.fits &&
        beside.height / marks.label.height > lengthOf(marks.grain) / lengthOf(alone)) {
        marks.label = beside;
        marks.grain = alone;
    } else if (!marks.grain) {
        marks.grain = alone;
    }
}

}  // namespace

PieceMarks placeMarks(const PatternPiece& piece, const Placement& placement,
                      const std::vector<std::string>& lines, double grain,
                      const std::vector<Points2>& obstacles) {
    FreeCloth cloth{{turnedLine(piece.outline, placement)}};
    for (const Points2& hole : piece.holes) {
        cloth.loops.push_back(turnedLine(hole, placement));
    }
    for (const Points2& line : obstacles) {
        cloth.obstacles.push_back(turnedLine(line, placement));
    }
    if (piece.cutAs == CutAs::OnFold) {
        const FoldMark fold = foldMark(piece, placement, "");
        cloth.obstacles.push_back(fold.path);
        cloth.obstacles.push_back(foldRoom(fold));
    }
    if (std::abs(geometry::signedAreaOf(piece.outline)) < kSmallestMarked) {
        PieceMarks marks;
        marks.label = {geometry::boxAround(cloth.loops.front()).center(), kSmallestLabel, false};
        marks.seams = seamMarks(piece, placement, cloth.obstacles);
        return marks;
    }
    const auto placed = [&](std::vector<std::string> label) {
        PieceMarks marks;
        placeNumbersAndLabel(marks, piece, placement, cloth, label);
        placeGrain(marks, cloth, label, directionOnSheet(placement, grain));
        marks.lines = std::move(label);
        return marks;
    };
    PieceMarks marks = placed(lines);
    if (!marks.label.fits) {
        if (PieceMarks broken = placed(brokenLines(lines)); broken.label.fits) {
            return broken;
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
    const double height = std::min(kFoldText, room / textExtent({words}, 1).x());
    mark.place = {at(0.5, 0, off + kOffFold * height).transpose(), height};
    mark.angle = readableAngle(std::atan2(along.y(), along.x()));
    return mark;
}

}  // namespace toile
