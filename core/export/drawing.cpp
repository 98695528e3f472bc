// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/export/drawing.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace toile {
namespace {

constexpr double kMargin = 10;      // mm, around all
constexpr double kCheckGap = 20;    // mm, between the pieces and the check square
constexpr double kCheckSide = 100;  // mm
constexpr double kCheckTextHeight = 3.5;

void addPiece(Drawing& drawing, const PatternPiece& piece, const Eigen::Vector2d& offset,
              const DrawingWords& words) {
    if (piece.outline.rows() == 0) {
        return;
    }
    std::vector<Points2> loops{piece.outline};
    loops.insert(loops.end(), piece.holes.begin(), piece.holes.end());
    for (Points2& loop : loops) {
        loop.rowwise() += offset.transpose();
    }
    std::vector<std::string> lines = labelLines(piece, words);
    const auto [label, grain] =
        placeMarks(loops, lines, piece.grain,
                   {Eigen::Vector2d::Zero(), Eigen::Vector2d(drawing.width, drawing.height)});
    drawing.paths.push_back({"piece-" + piece.id + "-cut", LayerKind::Cut, loops.front()});
    if (grain) {
        drawing.paths.push_back(
            {"piece-" + piece.id + "--grain", LayerKind::Grain, arrowPath(*grain), false});
    }
    drawing.texts.push_back({"piece-" + piece.id + "-name", LayerKind::Text, label.position,
                             label.height, std::move(lines)});
    for (std::size_t k = 1; k < loops.size(); ++k) {
        drawing.paths.push_back(
            {"piece-" + piece.id + "--hole-" + std::to_string(k), LayerKind::Cut, loops[k]});
    }
    addSeamMarks(drawing, piece, offset);
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

bool hasLayer(const Drawing& drawing, LayerKind kind) {
    return kind != LayerKind::Grain || std::ranges::any_of(drawing.paths, [](const auto& path) {
               return path.layer == LayerKind::Grain;
           });
}

Drawing draw(const Pattern& pattern, const Sheet& sheet, const DrawingWords& words) {
    // The check square stands to the right on whole millimetres, so that its sides come out as
    // exactly 100 in any number of decimals.
    const double left = sheet.width > 0 ? std::ceil(kMargin + sheet.width + kCheckGap) : kMargin;
    Drawing drawing;
    drawing.title = pattern.name.empty() ? "pattern" : pattern.name;
    drawing.width = left + kCheckSide + kMargin;
    drawing.height = std::ceil(std::max(sheet.height, kCheckSide)) + 2 * kMargin;
    for (std::size_t i = 0; i < pattern.pieces.size(); ++i) {
        addPiece(drawing, pattern.pieces[i], sheet.offset[i] + Eigen::Vector2d::Constant(kMargin),
                 words);
    }
    addCheckSquare(drawing, {left, kMargin}, words.checkSquare);
    return drawing;
}

}  // namespace toile
