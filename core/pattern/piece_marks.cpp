// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/pattern/piece_marks.h"

namespace toile {

std::string cuttingNote(const Cutting& cutting, const DrawingWords& words) {
    if (cutting.quantity == 1) {
        return cutting.mirroredPair ? words.cutPair : std::string();
    }
    std::string note = cutting.mirroredPair ? words.cutPairs : words.cut;
    if (const std::size_t place = note.find("%1"); place != std::string::npos) {
        note.replace(place, 2, std::to_string(cutting.quantity));
    }
    return note;
}

std::vector<std::string> labelLines(const std::string& name, const Cutting& cutting, bool mirrored,
                                    const DrawingWords& words) {
    std::vector<std::string> lines{name};
    if (std::string note = cuttingNote(cutting, words); !note.empty()) {
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

}  // namespace toile
