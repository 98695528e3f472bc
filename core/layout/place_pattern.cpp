// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/layout/place_pattern.h"

#include <algorithm>
#include <functional>
#include <utility>

#include "core/layout/arrange.h"

namespace toile {
namespace {

constexpr double kRounding = 1e-12;

void turn(Points2& line, const Eigen::Matrix2d& linear, bool reversed) {
    line = (line * linear.transpose()).eval();
    if (reversed) {
        line = line.colwise().reverse().eval();
    }
}

/// Those without a place go in rows beside the others.
void placeTheRest(const Pattern& pattern, const std::vector<bool>& hasPlace,
                  const Eigen::AlignedBox2d& placed, Sheet& sheet) {
    Pattern rest;
    for (std::size_t i = 0; i < hasPlace.size(); ++i) {
        if (!hasPlace[i]) {
            rest.pieces.push_back(pattern.pieces[i]);
        }
    }
    const Sheet rows = layOutInRows(rest);
    Eigen::Vector2d corner(0, 0);
    if (!placed.isEmpty()) {
        const double largest = std::max({rows.width, rows.height, placed.sizes().maxCoeff()});
        corner = {placed.max().x() + gapBetweenPieces(largest), placed.min().y()};
    }
    std::size_t next = 0;
    for (std::size_t i = 0; i < hasPlace.size(); ++i) {
        if (!hasPlace[i]) {
            sheet.offset[i] = corner + rows.offset[next++];
        }
    }
}

}  // namespace

PatternPiece turnedPiece(PatternPiece piece, const Placement& placement) {
    if (piece.grain) {
        piece.grain = directionOnSheet(placement, *piece.grain);
    }
    if (placement.turn == 0 && !placement.mirrored) {
        return piece;
    }
    const Eigen::Matrix2d linear = placement.linear();
    turn(piece.outline, linear, placement.mirrored);
    for (Points2& hole : piece.holes) {
        turn(hole, linear, placement.mirrored);
    }
    for (SeamMark& seam : piece.seams) {
        turn(seam.line, linear, placement.mirrored);
    }
    piece.mirrored = piece.mirrored != placement.mirrored;
    return piece;
}

Sheet placeOnSheet(Pattern& pattern, const std::vector<PieceOnSheet>& places) {
    const std::size_t count = pattern.pieces.size();
    std::vector<bool> hasPlace(count, false);
    Sheet sheet;
    sheet.offset.resize(count, Eigen::Vector2d::Zero());
    Eigen::AlignedBox2d box;
    for (std::size_t i = 0; i < std::min(count, places.size()); ++i) {
        PatternPiece& piece = pattern.pieces[i];
        piece.grain = places[i].grain;
        piece.quantity = places[i].quantity;
        piece.mirroredPair = places[i].mirroredPair;
        piece.name = places[i].name.empty() ? piece.name : places[i].name;
        hasPlace[i] = places[i].placement.has_value();
        const Placement placement = places[i].placement.value_or(Placement{});
        piece = turnedPiece(std::move(piece), placement);
        if (hasPlace[i]) {
            sheet.offset[i] = placement.offset;
            box.extend(outlineBox(piece.outline, Placement{placement.offset}));
        }
    }
    if (std::ranges::none_of(hasPlace, std::identity())) {
        return layOutInRows(pattern);
    }
    if (!std::ranges::all_of(hasPlace, std::identity())) {
        placeTheRest(pattern, hasPlace, box, sheet);
    }
    Eigen::AlignedBox2d all;
    for (std::size_t i = 0; i < count; ++i) {
        all.extend(outlineBox(pattern.pieces[i].outline, Placement{sheet.offset[i]}));
    }
    if (all.isEmpty()) {
        return sheet;
    }
    sheet.width = all.sizes().x();
    sheet.height = all.sizes().y();
    // Where it begins at the corner already, rounding aside, every digit stays.
    if (all.min().cwiseAbs().maxCoeff() > kRounding * all.sizes().maxCoeff()) {
        for (Eigen::Vector2d& offset : sheet.offset) {
            offset -= all.min();
        }
    }
    return sheet;
}

}  // namespace toile
