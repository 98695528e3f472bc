// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/drawing/drawing.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "core/base/text.h"
#include "core/geometry/line.h"
#include "core/layout/free_place.h"
#include "core/pattern/darts.h"
#include "core/pattern/internal_lines.h"
#include "core/pattern/notch_mark.h"
#include "core/pattern/pattern.h"

namespace toile {
namespace {

constexpr double kCheckGap = 20;    // mm, between the pieces and the check square
constexpr double kCheckSide = 100;  // mm
constexpr double kCheckTextHeight = 3.5;
constexpr double kOnRim = 1e-6;  // mm; a seam may begin between two vertices

void keepOnPage(LabelPlace& label, const std::vector<std::string>& lines, const Drawing& page) {
    const auto keep = [](double value, double least, double most) {
        return least > most ? 0.5 * (least + most) : std::clamp(value, least, most);
    };
    const Eigen::Vector2d size = textExtent(lines, label.height);
    const double below = size.y() - 0.5 * label.height;  // from the first line's middle
    label.position.x() = keep(label.position.x(), 0.5 * size.x(), page.width - 0.5 * size.x());
    label.position.y() = keep(label.position.y(), below, page.height - 0.5 * label.height);
}

double lineLength(const Points2& line, bool closed) {
    double length = closed ? (line.row(0) - line.row(line.rows() - 1)).norm() : 0;
    for (Eigen::Index k = 1; k < line.rows(); ++k) {
        length += (line.row(k) - line.row(k - 1)).norm();
    }
    return length;
}

/// A line of two points, moved.
Points2 movedChord(const Chord& chord, const Eigen::Vector2d& offset) {
    Points2 line(2, 2);
    line << (chord.from + offset).transpose(), (chord.to + offset).transpose();
    return line;
}

void addSeams(Drawing& drawing, const PatternPiece& piece, const Placement& placement,
              const std::vector<SeamMark>& seams) {
    for (const SeamMark& seam : seams) {
        const std::string id = "piece-" + piece.slug + "--seam-" + std::to_string(seam.number) +
                               (seam.second ? "b" : "");
        for (std::size_t k = 0; k < seam.ticks.size(); ++k) {
            if (seam.ticks[k]) {
                drawing.paths.push_back({id + "-tick-" + std::to_string(k + 1), LayerKind::Marks,
                                         movedChord(*seam.ticks[k], placement.offset), false});
            }
        }
        const auto addText = [&](const std::optional<LabelPlace>& at, const char* kind,
                                 const std::string& text) {
            if (at) {
                drawing.texts.push_back({id + kind,
                                         LayerKind::Marks,
                                         at->position + placement.offset,
                                         at->height,
                                         {text},
                                         seam.angle});
            }
        };
        addText(seam.numberPlace, "-number", numberText(seam));
        addText(seam.namePlace, "-name", seam.name);
    }
}

void addFold(Drawing& drawing, const PatternPiece& piece, const Placement& placement,
             const std::string& words) {
    const std::string id = "piece-" + piece.slug + "--fold";
    FoldMark mark = foldMark(piece, placement, words);
    mark.path.rowwise() += placement.offset.transpose();
    drawing.paths.push_back({id, LayerKind::Marks, std::move(mark.path), false});
    drawing.texts.push_back({id + "-text",
                             LayerKind::Marks,
                             mark.place.position + placement.offset,
                             mark.place.height,
                             {words},
                             mark.angle});
}

void addNotches(Drawing& drawing, const Pattern& pattern, const PatternPiece& piece,
                const Placement& placement) {
    const auto marks = notchMarks(pattern, piece);
    for (std::size_t n = 0; n < marks.size(); ++n) {
        const std::string id = "piece-" + piece.slug + "--notch-" + std::to_string(n + 1);
        for (std::size_t k = 0; k < marks[n].size(); ++k) {
            drawing.paths.push_back({k == 0 ? id : id + "-" + std::to_string(k + 1),
                                     LayerKind::Notches, placedLine(marks[n][k], placement),
                                     false});
        }
    }
}

/// Fold lines, drill points and tips of darts whose cloth stays.
void addDarts(Drawing& drawing, const PatternPiece& piece, const Placement& placement) {
    for (std::size_t k = 0; k < piece.darts.size(); ++k) {
        const std::string id = "piece-" + piece.slug + "--dart-" + std::to_string(k + 1);
        const auto add = [&](const char* what, const Points2& line, bool closed, bool isDrill) {
            if (line.rows() > 0) {
                drawing.paths.push_back(
                    {id + what, LayerKind::Internal, placedLine(line, placement), closed, isDrill});
            }
        };
        const DartMarks marks = dartMarks(piece.darts[k]);
        add("-fold", marks.fold, false, false);
        add("-drill", marks.drill, true, true);
        add("-tip-1", marks.cross[0], false, true);
        add("-tip-2", marks.cross[1], false, true);
    }
}

/// Lines and drill points, each numbered from 1.
void addInternals(Drawing& drawing, const PatternPiece& piece, const Placement& placement) {
    int lines = 0, points = 0;
    for (const PieceInternal& internal : piece.internals) {
        const std::vector<Points2> drawn = drawnLines(internal);
        const bool isPoint = isDrillPoint(internal);
        const std::string id = "piece-" + piece.slug + (isPoint ? "--point-" : "--line-");
        for (std::size_t k = 0; k < drawn.size(); ++k) {
            const bool isClosed = k == 0 && (isPoint || internal.closed);
            const Points2& line = internal.closed ? internal.points : drawn[k];
            const int number = k > 0 ? points : isPoint ? ++points : ++lines;
            drawing.paths.push_back(
                {id + std::to_string(number) + (k > 0 ? "-" + std::to_string(k + 1) : ""),
                 LayerKind::Internal, placedLine(line, placement), isClosed, isPoint});
        }
    }
}

/// Arc lengths of a stretch on the drawn line: mirrored lines run in the opposite direction.
/// @param from, to  on the line of the piece
std::pair<double, double> drawnPlaces(const geometry::Line& line, double from, double to,
                                      bool isMirrored) {
    if (!isMirrored) {
        return {from, to};
    }
    const double last = line.arc()[line.count() - 1];
    const double start = line.wrap(last - to);
    return {start, start + (to - from)};
}

/// The sides of the seams of a piece, on its seam line or the rims of its holes.
/// @param seamPath  index of its seam line in the drawing  @param rims  of the first of its holes
void addEdges(Drawing& drawing, const PatternPiece& piece, const Placement& placement,
              std::size_t seamPath, std::size_t rims) {
    std::vector<geometry::Line> lines{geometry::Line::closed(piece.outline)};
    for (const Points2& hole : piece.holes) {
        lines.push_back(geometry::Line::closed(hole));
    }
    UniqueNames taken;
    std::set<int> seen;
    for (const SeamLine& seam : piece.seams) {
        std::size_t line = 0;
        double from = seam.from, to = seam.to;
        for (std::size_t k = 1; seam.from == seam.to && k < lines.size(); ++k) {
            const double start = lines[k].nearestPlace(seam.line.row(0));
            if ((lines[k].pointAt(start) - seam.line.row(0)).norm() < kOnRim) {
                line = k;
                from = start;
                to = start + lineLength(seam.line, seam.closed);
            }
        }
        if (from == to) {
            continue;  // on a rim that is not drawn
        }
        const bool isSecond = !seen.insert(seam.number).second && seam.isRight;
        const std::string id =
            "piece-" + piece.slug + "--edge-" + std::to_string(seam.number) + (isSecond ? "b" : "");
        const auto [first, last] = drawnPlaces(lines[line], from, to, placement.mirrored);
        drawing.edges.push_back({taken.free(id, "-"), "", seam.name, seam.number,
                                 static_cast<int>(line == 0 ? seamPath : rims + line - 1), first,
                                 last, placedLine(seam.line, placement), seam.length3d});
    }
}

/// Links the two sides of each seam if each is drawn exactly once. With two copies of a piece both
/// would be the same side.
void pairEdges(Drawing& drawing) {
    struct Side {
        DrawnEdge* edge;
        std::size_t block;
    };
    std::map<int, std::vector<Side>> bySeam;
    for (std::size_t k = 0; k < drawing.blocks.size(); ++k) {
        const DrawnBlock& block = drawing.blocks[k];
        for (std::size_t e = block.edge; e < block.edge + block.edgeCount; ++e) {
            bySeam[drawing.edges[e].number].push_back({&drawing.edges[e], k});
        }
    }
    for (auto& [number, sides] : bySeam) {
        const auto pieceOf = [&drawing](const Side& side) {
            return drawing.blocks[side.block].piece;
        };
        if (sides.size() == 2 &&
            (sides[0].block == sides[1].block || pieceOf(sides[0]) != pieceOf(sides[1]))) {
            sides[0].edge->pair = sides[1].edge->id;
            sides[1].edge->pair = sides[0].edge->id;
        }
    }
}

/// @param piece  the piece at the index, with the slug of the copy
void addPiece(Drawing& drawing, const Pattern& pattern, int index, const PatternPiece& piece,
              const Placement& placement, const DrawingWords& words) {
    const std::string id = "piece-" + piece.slug + "-";
    DrawnBlock block{
        "piece-" + piece.slug, index, placement, drawing.paths.size(), drawing.texts.size(),
        drawing.edges.size()};
    const auto placed = [&placement](const Points2& line) -> Points2 {
        return placedLine(line, placement);
    };
    const std::vector<std::string> wanted = labelLines(piece.name, piece, placement.mirrored, words,
                                                       piece.cutAs, factsOf(pattern, piece));
    auto [label, lines, grain, seams] =
        placeMarks(piece, placement, wanted, grainOf(piece), drawnOnCloth(pattern, piece));
    label.position += placement.offset;
    drawing.paths.push_back({id + "cut", LayerKind::Cut, placed(edgeOf(piece))});
    std::size_t seamPath = drawing.paths.size() - 1;
    if (piece.cuttingLine.rows() > 0) {
        ++seamPath;
        drawing.paths.push_back({id + "-sew", LayerKind::Sew, placed(piece.outline)});
    }
    if (piece.grain && grain) {
        const Chord line{grain->from + placement.offset, grain->to + placement.offset};
        drawing.paths.push_back({id + "-grain", LayerKind::Grain, arrowPath(line), false});
    }
    if (!lines.empty()) {
        keepOnPage(label, lines, drawing);
        drawing.texts.push_back(
            {id + "name", LayerKind::Text, label.position, label.height, std::move(lines)});
    }
    for (std::size_t k = 0; pattern.hasAllowance && k < piece.extensions.size(); ++k) {
        drawing.paths.push_back({id + "-extension-" + std::to_string(k + 1), LayerKind::Internal,
                                 placed(piece.extensions[k]), false});
    }
    addEdges(drawing, piece, placement, seamPath, drawing.paths.size());
    for (std::size_t k = 0; k < piece.holes.size(); ++k) {
        drawing.paths.push_back(
            {id + "-hole-" + std::to_string(k + 1), LayerKind::Cut, placed(piece.holes[k])});
    }
    addSeams(drawing, piece, placement, seams);
    addNotches(drawing, pattern, piece, placement);
    addInternals(drawing, piece, placement);
    addDarts(drawing, piece, placement);
    if (piece.cutAs == CutAs::OnFold) {
        addFold(drawing, piece, placement, words.placeOnFold);
    }
    block.pathCount = drawing.paths.size() - block.path;
    block.textCount = drawing.texts.size() - block.text;
    block.edgeCount = drawing.edges.size() - block.edge;
    drawing.blocks.push_back(std::move(block));
}

void addCheckSquare(Drawing& drawing, const Eigen::Vector2d& corner, const std::string& words) {
    Points2 square(4, 2);
    square << 0, 0, kCheckSide, 0, kCheckSide, kCheckSide, 0, kCheckSide;
    square.rowwise() += corner.transpose();
    const Eigen::Vector2d middle = corner + Eigen::Vector2d::Constant(0.5 * kCheckSide);
    drawing.paths.push_back({"check-square", LayerKind::Check, std::move(square)});
    drawing.texts.push_back(
        {"check-square-text", LayerKind::Check, middle, kCheckTextHeight, {words}});
}

}  // namespace

std::optional<LayerKind> layerNamed(std::string_view name, const char* LayerNames::*file) {
    const auto found = std::ranges::find_if(
        kLayerKinds, [&](LayerKind kind) { return namesOf(kind).*file == name; });
    return found == kLayerKinds.end() ? std::nullopt : std::optional(*found);
}

bool hasLayer(const Drawing& drawing, LayerKind kind) {
    const bool isOptional = kind == LayerKind::Sew || kind == LayerKind::Notches ||
                            kind == LayerKind::Internal || kind == LayerKind::Grain;
    return !isOptional || std::ranges::any_of(drawing.paths, [kind](const auto& path) -> bool {
        return path.layer == kind;
    });
}

Drawing draw(const Pattern& pattern, const Marker& marker, const DrawingWords& words) {
    // The check square is to the right on whole millimetres, so that its sides are exactly 100 in
    // any number of decimals.
    const double left =
        marker.width > 0 ? std::ceil(kDrawingMargin + marker.width + kCheckGap) : kDrawingMargin;
    Drawing drawing;
    drawing.words = words;
    drawing.title = pattern.name.empty() ? "pattern" : pattern.name;
    drawing.width = left + kCheckSide + kDrawingMargin;
    drawing.height = std::ceil(std::max(marker.height, kCheckSide)) + 2 * kDrawingMargin;
    UniqueNames slugs;
    for (const PatternPiece& piece : pattern.pieces) {
        slugs.take(piece.slug);
    }
    std::set<int> drawn;
    for (const auto& [index, placement] : marker.copies) {
        const PatternPiece& piece = pattern.pieces[static_cast<std::size_t>(index)];
        const Placement onPage = movedBy(placement, Eigen::Vector2d::Constant(kDrawingMargin));
        if (drawn.insert(index).second) {
            addPiece(drawing, pattern, index, piece, onPage, words);
        } else {
            PatternPiece copy = piece;
            copy.slug = slugs.numbered(piece.slug, "-copy-", 2);
            addPiece(drawing, pattern, index, copy, onPage, words);
        }
    }
    pairEdges(drawing);
    addCheckSquare(drawing, {left, kDrawingMargin}, words.checkSquare);
    return drawing;
}

namespace {

constexpr std::size_t kNamed = 3;

/// The outermost closed line of a block, along which it is cut.
Points2 cutLineOf(const Drawing& drawing, const DrawnBlock& block) {
    for (std::size_t k = block.path; k < block.path + block.pathCount; ++k) {
        if (drawing.paths[k].layer == LayerKind::Cut && drawing.paths[k].closed) {
            return drawing.paths[k].points;
        }
    }
    return Points2(0, 2);
}

const PatternPiece& drawnPiece(const Pattern& pattern, const DrawnBlock& block) {
    return pattern.pieces[static_cast<std::size_t>(block.piece)];
}

}  // namespace

std::vector<Wording> overlapNotes(const Pattern& pattern, const Drawing& drawing) {
    std::vector<Points2> outlines;
    for (const DrawnBlock& block : drawing.blocks) {
        outlines.push_back(cutLineOf(drawing, block));
    }
    std::vector<std::string> names;
    for (const auto& [one, other] : overlappingOutlines(outlines)) {
        names.push_back(drawnPiece(pattern, drawing.blocks[static_cast<std::size_t>(one)]).name +
                        " / " +
                        drawnPiece(pattern, drawing.blocks[static_cast<std::size_t>(other)]).name);
    }
    if (names.empty()) {
        return {};
    }
    return {worded("Pieces overlap on the sheet: %1. Move them apart, or lay out all pieces again.",
                   {quotedList(names, kNamed)})};
}

std::vector<Wording> grainNotes(const Pattern& pattern, const Drawing& drawing) {
    std::vector<std::string> names;
    std::set<int> seen;  // a piece may be drawn more than once
    for (const DrawnBlock& block : drawing.blocks) {
        if (!drawnPiece(pattern, block).grain && seen.insert(block.piece).second) {
            names.push_back(drawnPiece(pattern, block).name);
        }
    }
    if (names.empty()) {
        return {};
    }
    return {
        worded("Pieces without a grain line because no grain is set: %1. Turn the arrow, or choose "
               "a grain.",
               {quotedList(names, kNamed)})};
}

}  // namespace toile
