// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/export/drawing.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/export/grain_line.h"
#include "core/export/label.h"
#include "core/export/seam_marks.h"

namespace toile {
namespace {

constexpr double kMargin = 10;      // mm, around all
constexpr double kCheckGap = 20;    // mm, between the pieces and the check square
constexpr double kCheckSide = 100;  // mm
constexpr double kCheckTextHeight = 3.5;
constexpr const char* kAllowanceNote = "net outline, no allowance";
constexpr const char* kMirroredNote = "mirrored: wrong side of the fabric up";
constexpr const char* kCheckText = "check square 100 mm x 100 mm";

/// Keeps a text on the page: a tiny piece may be narrower than its own name.
void keepOnPage(DrawnText& text, const Drawing& drawing) {
    const Eigen::Vector2d half = 0.5 * textExtent(text.lines, text.height);
    const auto keep = [](double value, double least, double most) {
        return least > most ? 0.5 * (least + most) : std::clamp(value, least, most);
    };
    const double below = 2 * half.y() - 0.5 * text.height;  // of the first line's middle
    text.position.x() = keep(text.position.x(), half.x(), drawing.width - half.x());
    text.position.y() = keep(text.position.y(), below, drawing.height - 0.5 * text.height);
}

void addGrainLine(Drawing& drawing, const PatternPiece& piece, const std::vector<Points2>& loops,
                  const DrawnText& name) {
    const Eigen::Vector2d size = textExtent(name.lines, name.height);
    const Eigen::Vector2d top = name.position + Eigen::Vector2d(0, 0.5 * name.height);
    const Eigen::AlignedBox2d words(Eigen::Vector2d(top.x() - 0.5 * size.x(), top.y() - size.y()),
                                    Eigen::Vector2d(top.x() + 0.5 * size.x(), top.y()));
    auto line = grainLine(loops, *piece.grain, words);
    if (!line) {
        line = grainLine(loops, *piece.grain, {});  // no room beside the name: through it
    }
    if (line) {
        drawing.paths.push_back(
            {"piece-" + piece.id + "--grain", LayerKind::Grain, arrowPath(*line), false});
    }
}

void addPiece(Drawing& drawing, const PatternPiece& piece, const Eigen::Vector2d& offset) {
    if (piece.outline.rows() == 0) {
        return;
    }
    std::vector<Points2> loops{piece.outline};
    loops.insert(loops.end(), piece.holes.begin(), piece.holes.end());
    for (Points2& loop : loops) {
        loop.rowwise() += offset.transpose();
    }
    std::vector<std::string> lines{piece.name};
    if (std::string note = cuttingNote(piece.quantity, piece.mirroredPair); !note.empty()) {
        lines.push_back(std::move(note));
    }
    lines.emplace_back(kAllowanceNote);
    if (piece.mirrored) {
        lines.push_back(kMirroredNote);
    }
    const LabelPlace place = placeLabel(loops, lines);
    DrawnText text{"piece-" + piece.id + "-name", LayerKind::Text, place.position, place.height,
                   std::move(lines)};
    keepOnPage(text, drawing);
    drawing.paths.push_back({"piece-" + piece.id + "-cut", LayerKind::Cut, loops.front()});
    if (piece.grain) {
        addGrainLine(drawing, piece, loops, text);
    }
    drawing.texts.push_back(std::move(text));
    for (std::size_t k = 1; k < loops.size(); ++k) {
        drawing.paths.push_back(
            {"piece-" + piece.id + "--hole-" + std::to_string(k), LayerKind::Cut, loops[k]});
    }
    addSeamMarks(drawing, piece, offset);
}

void addCheckSquare(Drawing& drawing, const Eigen::Vector2d& corner) {
    Points2 square(4, 2);
    square << 0, 0, kCheckSide, 0, kCheckSide, kCheckSide, 0, kCheckSide;
    square.rowwise() += corner.transpose();
    const Eigen::Vector2d middle = corner + Eigen::Vector2d::Constant(0.5 * kCheckSide);
    drawing.paths.push_back({"check-square", LayerKind::Check, std::move(square)});
    drawing.texts.push_back(
        {"check-square-text", LayerKind::Check, middle, kCheckTextHeight, {kCheckText}});
}

}  // namespace

bool hasLayer(const Drawing& drawing, LayerKind kind) {
    return kind != LayerKind::Grain || std::ranges::any_of(drawing.paths, [](const auto& path) {
               return path.layer == LayerKind::Grain;
           });
}

Drawing draw(const Pattern& pattern, const Sheet& sheet) {
    // The check square stands to the right on whole millimetres, so that its sides come out as
    // exactly 100 in any number of decimals.
    const double left = sheet.width > 0 ? std::ceil(kMargin + sheet.width + kCheckGap) : kMargin;
    Drawing drawing;
    drawing.title = pattern.name.empty() ? "pattern" : pattern.name;
    drawing.width = left + kCheckSide + kMargin;
    drawing.height = std::ceil(std::max(sheet.height, kCheckSide)) + 2 * kMargin;
    for (std::size_t i = 0; i < pattern.pieces.size(); ++i) {
        addPiece(drawing, pattern.pieces[i], sheet.offset[i] + Eigen::Vector2d::Constant(kMargin));
    }
    addCheckSquare(drawing, {left, kMargin});
    return drawing;
}

}  // namespace toile
