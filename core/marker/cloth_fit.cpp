// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/marker/cloth_fit.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <deque>
#include <limits>
#include <optional>
#include <utility>

#include "core/base/wording.h"
#include "core/marker/cloth_marker.h"
#include "core/marker/laid_pieces.h"

namespace toile {
namespace {

constexpr const char* kNoSuchSeam = translatable("no seam in this marker is called %1");
constexpr const char* kSeamNotMatched =
    translatable("the repeat does not match along %1: its sides are %2 mm off");
constexpr const char* kMatchedAtOneEnd =
    translatable("the repeat matches at the start of %1, but is %2 mm off at its end");

}  // namespace
}  // namespace toile

namespace toile::cloth {
namespace {

constexpr double kMatchedWithin = 0.5;  // mm: invisible mismatch

/// A side of a seam on an item, turned but not moved: ends that are sewn to each other.
struct MatchedSide {
    int item = 0;
    Eigen::Vector2d first{0, 0}, last{0, 0};  ///< in the item's coordinates
    Eigen::Vector2d turnedFirst{0, 0}, turnedLast{0, 0};
};

struct MatchedPair {
    std::string name;
    MatchedSide left, right;
};

/// Turned like the item, or like its fixed placement, but not moved.
geometry::Polygon turnedAs(const NestItem& item, const geometry::Polygon& line) {
    NestItem turned;
    turned.rings = {line};
    const double angle = item.fixed ? item.fixed->angle : item.angles.front();
    return placedRings(turned, {0, angle, item.fixed && item.fixed->mirrored, 0, 0}).front();
}

Eigen::Vector2d turnedPoint(const NestItem& item, const Eigen::Vector2d& point) {
    return turnedAs(item, point.transpose()).row(0).transpose();
}

/// Placements that the repeat cannot change: a kept item in full, one on the fold across it.
void keepKnown(const NestItem& item, std::optional<Eigen::Vector2d>& place) {
    if (item.fixed) {
        place = {item.fixed->x, item.fixed->y};
    } else if (item.touchesEdge && place) {
        place->y() = -turnedAs(item, item.rings.front()).col(1).minCoeff();
    }
}

MatchedSide sideOf(const Pattern& pattern, const LaidPiece& laid, int index, const NestItem& item,
                   const SeamLine& seam) {
    const PatternPiece& piece = pattern.pieces[static_cast<std::size_t>(laid.piece)];
    const Points2 line = nestFormOf(piece, laid.isImage).of(seam.line);
    MatchedSide side;
    side.item = index;
    side.first = line.row(seam.isRight ? line.rows() - 1 : 0).transpose();
    side.last = line.row(seam.isRight ? 0 : line.rows() - 1).transpose();
    side.turnedFirst = turnedPoint(item, side.first);
    side.turnedLast = turnedPoint(item, side.last);
    return side;
}

/// Pairs of the two sides of a seam, separately for originals and images; further sides, of kept
/// copies, are paired with the first of the other side.
std::vector<MatchedPair> pairsOf(const Pattern& pattern, const std::vector<LaidPiece>& laid,
                                 const std::vector<NestItem>& items, const std::string& name) {
    std::vector<MatchedPair> pairs;
    for (const bool isImage : {false, true}) {
        std::vector<MatchedSide> left, right;
        for (std::size_t i = 0; i < laid.size(); ++i) {
            const LaidPiece& piece = laid[i];
            for (const SeamLine& seam :
                 pattern.pieces[static_cast<std::size_t>(piece.piece)].seams) {
                if (seam.name == name && piece.isImage == isImage) {
                    (seam.isRight ? right : left)
                        .push_back(sideOf(pattern, piece, static_cast<int>(i), items[i], seam));
                }
            }
        }
        for (std::size_t k = 0; !left.empty() && k < right.size(); ++k) {
            pairs.push_back({name, left.front(), right[k]});
        }
        for (std::size_t k = 1; !right.empty() && k < left.size(); ++k) {
            pairs.push_back({name, left[k], right.front()});
        }
    }
    return pairs;
}

/// Distance of two places modulo the repeat, mm.
double apartIn(const ClothRepeat& repeat, const Eigen::Vector2d& way) {
    const auto along = [](double distance, double step) {
        return step > 0 ? std::abs(std::remainder(distance, step)) : 0;
    };
    return std::max(along(way.x(), repeat.warp), along(way.y(), repeat.weft));
}

}  // namespace

void matchStripes(const Pattern& pattern, const std::vector<LaidPiece>& laid,
                  const MarkerSettings& settings, std::vector<NestItem>& items,
                  std::vector<Wording>& notes) {
    std::vector<MatchedPair> pairs;
    for (const std::string& name : settings.matched) {
        const std::vector<MatchedPair> found = pairsOf(pattern, laid, items, name);
        if (found.empty()) {
            notes.push_back(worded(kNoSuchSeam, {name}));
        }
        pairs.insert(pairs.end(), found.begin(), found.end());
    }
    const ClothRepeat& repeat = settings.repeat;
    // Origin of each item in the repeat: first of items whose place is known, then of the first
    // item of each tree, on the fold if possible, such that its seam begins at the start of a
    // repeat.
    std::vector<std::optional<Eigen::Vector2d>> places(items.size());
    const auto at = [&](int item) -> auto& {
        return places[static_cast<std::size_t>(item)];
    };
    const auto itemAt = [&](int item) -> const NestItem& {
        return items[static_cast<std::size_t>(item)];
    };
    std::vector<const MatchedSide*> roots;
    for (const MatchedPair& pair : pairs) {
        roots.insert(roots.end(), {&pair.left, &pair.right});
        for (const int item : {pair.left.item, pair.right.item}) {
            keepKnown(itemAt(item), at(item));
        }
    }
    std::ranges::stable_sort(roots, std::ranges::greater{}, [&](const MatchedSide* side) {
        return itemAt(side->item).fixed ? 2 : itemAt(side->item).touchesEdge ? 1 : 0;
    });
    for (const MatchedSide* root : roots) {
        if (!at(root->item)) {
            at(root->item) = repeat.origin - root->turnedFirst;
            keepKnown(itemAt(root->item), at(root->item));
        }
        for (bool isMore = true; isMore;) {
            isMore = false;
            for (std::size_t k = 0; k < pairs.size(); ++k) {
                const MatchedSide &left = pairs[k].left, &right = pairs[k].right;
                if (at(left.item).has_value() != at(right.item).has_value()) {
                    const MatchedSide& known = at(left.item) ? left : right;
                    const MatchedSide& other = at(left.item) ? right : left;
                    at(other.item) = *at(known.item) + known.turnedFirst - other.turnedFirst;
                    keepKnown(itemAt(other.item), at(other.item));
                    isMore = true;
                }
            }
        }
    }
    const auto note = [&](const Wording& stated) {
        if (std::ranges::find(notes, stated) == notes.end()) {
            notes.push_back(stated);
        }
    };
    for (const MatchedPair& pair : pairs) {
        const auto apartAt = [&](const Eigen::Vector2d& left, const Eigen::Vector2d& right) {
            return apartIn(repeat, *places[static_cast<std::size_t>(pair.left.item)] + left -
                                       *places[static_cast<std::size_t>(pair.right.item)] - right);
        };
        const double first = apartAt(pair.left.turnedFirst, pair.right.turnedFirst);
        const double last = apartAt(pair.left.turnedLast, pair.right.turnedLast);
        if (first > kMatchedWithin) {
            note(worded(kSeamNotMatched, {pair.name, figure(first, 1)}));
        } else if (last > kMatchedWithin) {
            note(worded(kMatchedAtOneEnd, {pair.name, figure(last, 1)}));
        }
    }
    for (std::size_t i = 0; i < items.size(); ++i) {
        if (places[i] && !items[i].fixed) {
            items[i].lattice = NestLattice{{0, 0}, *places[i], {repeat.warp, repeat.weft}};
            items[i].angles.resize(1);
            items[i].tolerance = 0;
            items[i].mayMirror = false;
        }
    }
}

}  // namespace toile::cloth

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
        const auto stated = rules.find(material);
        const MarkerSettings settings = stated == rules.end() ? MarkerSettings{} : stated->second;
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
