// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/marker/cloth_fit.h"

#include <array>
#include <optional>
#include <utility>

#include "core/base/wording.h"
#include "core/marker/cloth_marker.h"
#include "core/marker/laid_pieces.h"
#include "core/marker/stripes.h"

namespace toile {
namespace {

WidePiece wideOne(const Pattern& pattern, int piece) {
    const int pieces = static_cast<int>(pattern.pieces.size() - pattern.facings.size());
    if (piece < pieces) {
        return {piece};
    }
    // In a pattern, facings follow the garment's pieces.
    const FacingPiece& facing = pattern.facings[static_cast<std::size_t>(piece - pieces)];
    return {facing.piece, pattern.pieces[static_cast<std::size_t>(piece)].name};
}

/// Tests whether an item is too large, and if so writes its extent and the room to `wide`.
bool isTooLarge(const NestItem& item, double roomAcross, double roomAlong, WidePiece& wide) {
    NestItem asItIs = item;
    asItIs.tolerance = 0;
    for (const NestItem* const turns : {&std::as_const(asItIs), &item}) {  // mostly the first fits
        const Eigen::Vector2d sides = cloth::leastSides(*turns);
        if (sides.x() <= roomAlong && sides.y() <= roomAcross) {
            return false;
        }
        const bool isTooWide = sides.y() > roomAcross;
        wide.extent = isTooWide ? sides.y() : sides.x();
        wide.room = isTooWide ? roomAcross : roomAlong;
    }
    return true;
}

}  // namespace

ClothRules clothRules(const MarkerPlans& plans) {
    ClothRules rules;
    for (const auto& [material, plan] : plans) {
        rules.emplace(material, plan.settings);
    }
    return rules;
}

std::vector<WidePiece> widerThanCloth(const Pattern& whole, const Fabric& own,
                                      const ClothRules& rules, const Progress& progress) {
    std::vector<WidePiece> found;
    std::array<std::optional<Pattern>, 2> asLaid;  // on flat cloth, on folded cloth
    std::vector<Wording> ignored;
    for (const std::string& material : markerMaterials(whole)) {
        const auto said = rules.find(material);
        const MarkerSettings settings = said == rules.end() ? MarkerSettings{} : said->second;
        if (!settings.hides.empty()) {
            continue;
        }
        std::optional<Pattern>& laid = asLaid[settings.isFolded ? 1 : 0];
        if (!laid) {
            laid = patternOnCloth(whole, settings);
        }
        const Pattern& pattern = *laid;
        std::vector<cloth::LaidPiece> pieces =
            cloth::laidPieces(pattern, material, settings, ignored);
        const auto pieceOf = [&pattern](const cloth::LaidPiece& one) -> const PatternPiece& {
            return pattern.pieces[static_cast<std::size_t>(one.piece)];
        };
        std::erase_if(
            pieces, [&](const cloth::LaidPiece& one) { return !edgeOf(pieceOf(one)).allFinite(); });
        std::vector<NestItem> items;
        for (const cloth::LaidPiece& one : pieces) {
            items.push_back(cloth::itemOf(pieceOf(one), one.isImage, settings));
        }
        if (!settings.matched.empty()) {
            cloth::matchStripes(pattern, pieces, settings, items, ignored);
        }
        const double width =
            cloth::widthOnCloth(settings, fabricOf(material, pattern.materials, own));
        for (std::size_t i = 0; i < items.size() && !progress.isCancelled(); ++i) {
            WidePiece wide = wideOne(pattern, pieces[i].piece);
            if (!pieces[i].isImage &&
                isTooLarge(items[i], cloth::roomAcross(items[i], width, settings),
                           cloth::roomAlong(settings), wide)) {
                found.push_back(std::move(wide));
            }
        }
    }
    return found;
}

}  // namespace toile
