// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/layout.h"

#include <algorithm>
#include <numbers>
#include <set>
#include <utility>

#include "app/base/text.h"
#include "app/document/document.h"
#include "app/document/mirrored_edits.h"
#include "app/document/piece_edits.h"
#include "core/layout/marker.h"
#include "core/pattern/half_pattern.h"

namespace toile::app {

namespace {

const Points2 kNoOutline(0, 2);

std::vector<Eigen::AlignedBox2d> boxesOf(const Document& document, const std::vector<int>& pieces) {
    std::vector<Eigen::AlignedBox2d> boxes;
    boxes.reserve(pieces.size());
    for (const int piece : pieces) {
        boxes.push_back(boxOnSheet(document, piece));
    }
    return boxes;
}

template <class Value>
std::vector<int> piecesOf(const std::map<int, Value>& byPiece) {
    std::vector<int> pieces;
    pieces.reserve(byPiece.size());
    for (const auto& entry : byPiece) {
        pieces.push_back(entry.first);
    }
    return pieces;
}

/// Moves pieces. @param byHand  no other piece may push them away from there
void placeEach(Document& document, const QString& text, const PiecePlacements& placements,
               int gesture, bool byHand) {
    const auto place = [&](int piece, PieceSettings& settings) {
        const Placement& placement = placements.at(piece);
        if (placement.offset.cwiseAbs().maxCoeff() <= kFarthestOnSheet &&
            placement.offset.allFinite() && std::isfinite(placement.turn)) {
            settings.placement = placement;
            settings.placedByHand = byHand;
        }
    };
    const std::vector<int> pieces = piecesOf(placements);
    editSettings(document, stepOf(document, text, pieces), pieces, place, gesture);
}

void moveEach(Document& document, const QString& text, const std::vector<int>& pieces,
              const std::vector<Eigen::Vector2d>& moves, bool byHand = true) {
    PiecePlacements placements;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        placements[pieces[i]] = movedBy(placementOf(document, pieces[i]), moves[i]);
    }
    placeEach(document, text, placements, -1, byHand);
}

}  // namespace

std::vector<int> selectedFlat(const Document& document) {
    std::vector<int> pieces(document.selection().begin(), document.selection().end());
    std::erase_if(pieces, [&](int piece) {
        const PieceResult* result = document.result(piece);
        return !result || !result->flat;
    });
    return pieces;
}

std::vector<int> allFlat(const Document& document) {
    std::vector<int> pieces;
    for (int i = 0; i < document.pieceCount(); ++i) {
        if (const PieceResult* result = document.result(i); result && result->flat) {
            pieces.push_back(i);
        }
    }
    return pieces;
}

std::vector<int> selectedOrAllFlat(const Document& document) {
    std::vector<int> pieces = selectedFlat(document);
    return pieces.empty() ? allFlat(document) : pieces;
}

const Points2& flatOutline(const Document& document, int piece) {
    const PatternPiece* flat = document.patternPiece(piece);
    return flat ? flat->outline : kNoOutline;
}

const Points2& cutOutline(const Document& document, int piece) {
    const PatternPiece* flat = document.patternPiece(piece);
    return flat ? edgeOf(*flat) : kNoOutline;
}

Placement placementOf(const Document& document, int piece) {
    return document.settings()[static_cast<std::size_t>(piece)].placement.value_or(Placement{});
}

CutAs cutAsOf(const Document& document, int piece) {
    const PatternPiece* const flat = document.patternPiece(piece);
    if (!flat) {
        return CutAs::Whole;
    }
    const auto isByHalf = [&document](int k) -> bool {
        return k >= 0 && document.settings()[static_cast<std::size_t>(k)].byHalf;
    };
    return cutAs(flat->mirror, isByHalf(piece) || isByHalf(flat->mirror.counterpart));
}

Eigen::AlignedBox2d boxOnSheet(const Document& document, int piece) {
    return outlineBox(cutOutline(document, piece), placementOf(document, piece));
}

Eigen::AlignedBox2d boxOnSheet(const Document& document, const std::vector<int>& pieces) {
    Eigen::AlignedBox2d box;
    for (const int piece : pieces) {
        box.extend(boxOnSheet(document, piece));
    }
    return box;
}

void place(Document& document, const QString& text, const PiecePlacements& placements,
           int gesture) {
    placeEach(document, text, placements, gesture, true);
}

void placeBack(Document& document, const QString& text, const PiecePlacements& pieces,
               const std::vector<PieceSettings>& before, int gesture) {
    std::vector<int> there = piecesOf(pieces);
    std::erase_if(there, [&](int piece) {
        const auto at = static_cast<std::size_t>(piece);
        return at >= before.size() || at >= document.settings().size();
    });
    const auto back = [&before](int piece, PieceSettings& settings) {
        const PieceSettings& was = before[static_cast<std::size_t>(piece)];
        settings.placement = was.placement;
        settings.placedByHand = was.placedByHand;
    };
    editSettings(document, stepOf(document, text, there), there, back, gesture);
}

void setGrain(Document& document, const QString& text, const PieceGrains& grains, int gesture) {
    const PieceGrains all = withMirroredGrains(document, grains);
    const auto turn = [&all](int piece, PieceSettings& settings) {
        settings.grain = all.at(piece);
    };
    const std::vector<int> pieces = piecesOf(all);
    editSettings(document, stepOf(document, text, pieces), pieces, turn, gesture);
}

void turnTogether(Document& document, const QString& text, const std::vector<int>& pieces,
                  double angle) {
    const Eigen::AlignedBox2d box = boxOnSheet(document, pieces);
    if (box.isEmpty()) {
        return;
    }
    PiecePlacements placements;
    for (const int piece : pieces) {
        placements[piece] = turnedAbout(placementOf(document, piece), box.center(), angle);
    }
    place(document, text, placements);
}

void mirrorTogether(Document& document, const QString& text, const std::vector<int>& pieces,
                    Mirroring mirroring) {
    const Eigen::AlignedBox2d box = boxOnSheet(document, pieces);
    if (box.isEmpty()) {
        return;
    }
    PiecePlacements placements;
    for (const int piece : pieces) {
        placements[piece] = mirroredAt(placementOf(document, piece), box.center(), mirroring);
    }
    place(document, text, placements);
}

void turnGrainUpwards(Document& document, const std::vector<int>& pieces) {
    PiecePlacements placements;
    for (const int piece : pieces) {
        const Placement before = placementOf(document, piece);
        const double grain = grainOf(document.settings()[static_cast<std::size_t>(piece)]);
        placements[piece] = turnedAbout(before, boxOnSheet(document, piece).center(),
                                        std::numbers::pi / 2 - directionOnSheet(before, grain));
    }
    place(document, tr("Turn grain of %1 upwards"), placements);
}

void align(Document& document, const std::vector<int>& pieces, Alignment alignment) {
    moveEach(document, tr("Align %1"), pieces,
             alignmentMoves(boxesOf(document, pieces), alignment));
}

void distribute(Document& document, const std::vector<int>& pieces, Direction direction) {
    moveEach(document, tr("Distribute %1"), pieces,
             distributionMoves(boxesOf(document, pieces), direction));
}

void layOutAgain(Document& document, const std::vector<int>& pieces) {
    if (pieces.empty()) {
        return;
    }
    const std::vector<Eigen::AlignedBox2d> boxes = boxesOf(document, pieces);
    std::vector<double> clothWidths;
    clothWidths.reserve(pieces.size());
    for (const int piece : pieces) {
        clothWidths.push_back(document.fabricOf(piece).width);
    }
    const Rows rows = layOutInRows(boxes, clothWidths);
    const std::set<int> moving(pieces.begin(), pieces.end());
    std::vector<int> staying = allFlat(document);
    std::erase_if(staying, [&](int piece) { return moving.contains(piece); });
    Eigen::Vector2d corner(0, 0);
    if (const Eigen::AlignedBox2d others = boxOnSheet(document, staying); !others.isEmpty()) {
        double largest = 0;
        for (const Eigen::AlignedBox2d& box : boxes) {
            largest = std::max(largest, box.sizes().maxCoeff());
        }
        corner = {others.max().x() + gapBetweenPieces(largest), others.min().y()};
    }
    std::vector<Eigen::Vector2d> moves = rows.offset;
    for (Eigen::Vector2d& move : moves) {
        move += corner;
    }
    moveEach(document, tr("Lay out %1"), pieces, moves, false);
}

}  // namespace toile::app
