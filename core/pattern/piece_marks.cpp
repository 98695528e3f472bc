// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/pattern/piece_marks.h"

#include <algorithm>

namespace toile {
namespace {

void keepOnPage(LabelPlace& label, const Eigen::Vector2d& size, const Eigen::AlignedBox2d& page) {
    const auto keep = [](double value, double least, double most) {
        return least > most ? 0.5 * (least + most) : std::clamp(value, least, most);
    };
    const Eigen::Vector2d half = 0.5 * size;
    const double below = 2 * half.y() - 0.5 * label.height;  // of the first line's middle
    label.position.x() =
        keep(label.position.x(), page.min().x() + half.x(), page.max().x() - half.x());
    label.position.y() =
        keep(label.position.y(), page.min().y() + below, page.max().y() - 0.5 * label.height);
}

}  // namespace

std::string cuttingNote(int quantity, bool mirroredPair, const DrawingWords& words) {
    if (quantity == 1) {
        return mirroredPair ? words.cutPair : std::string();
    }
    std::string note = mirroredPair ? words.cutPairs : words.cut;
    if (const std::size_t place = note.find("%1"); place != std::string::npos) {
        note.replace(place, 2, std::to_string(quantity));
    }
    return note;
}

std::vector<std::string> labelLines(const PatternPiece& piece, const DrawingWords& words) {
    std::vector<std::string> lines{piece.name};
    if (std::string note = cuttingNote(piece.quantity, piece.mirroredPair, words); !note.empty()) {
        lines.push_back(std::move(note));
    }
    lines.push_back(words.noAllowance);
    if (piece.mirrored) {
        lines.push_back(words.mirrored);
    }
    return lines;
}

PieceMarks placeMarks(const std::vector<Points2>& loops, const std::vector<std::string>& lines,
                      std::optional<double> grain, const Eigen::AlignedBox2d& page) {
    PieceMarks marks;
    marks.label = placeLabel(loops, lines);
    const Eigen::Vector2d size = textExtent(lines, marks.label.height);
    if (!page.isEmpty()) {
        keepOnPage(marks.label, size, page);
    }
    if (grain) {
        const Eigen::Vector2d top =
            marks.label.position + Eigen::Vector2d(0, 0.5 * marks.label.height);
        const Eigen::AlignedBox2d words(
            Eigen::Vector2d(top.x() - 0.5 * size.x(), top.y() - size.y()),
            Eigen::Vector2d(top.x() + 0.5 * size.x(), top.y()));
        marks.grain = grainLine(loops, *grain, words);
        if (!marks.grain) {
            marks.grain = grainLine(loops, *grain, {});  // no room beside the label: through it
        }
    }
    return marks;
}

}  // namespace toile
