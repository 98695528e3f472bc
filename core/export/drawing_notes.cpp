// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/export/drawing_notes.h"

#include <algorithm>
#include <set>
#include <string>
#include <vector>

#include "core/base/text.h"
#include "core/layout/sheet_overlaps.h"
#include "core/pattern/pattern.h"

namespace toile {
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
    return {worded("On each other on the sheet: %1. Move them apart, or lay all out again.",
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
        worded("Without a grain line, as their grain is not stated: %1. Turn the arrow, or "
               "choose a grain.",
               {quotedList(names, kNamed)})};
}

}  // namespace toile
