// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/marker/stripes.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <limits>

namespace toile {
namespace {

constexpr const char* kNoSuchSeam = translatable("no seam that is laid here is called %1");
constexpr const char* kSeamNotMatched =
    translatable("the repeat does not meet along %1: its sides are %2 mm apart in it");
constexpr const char* kMatchedAtOneEnd =
    translatable("the repeat meets where %1 begins, and is %2 mm apart where it ends");

}  // namespace
}  // namespace toile

namespace toile::cloth {
namespace {

constexpr double kMatchedWithin = 0.5;  // mm: what no eye sees

/// A side of a seam on an item, as it lies but for where: ends that are sewn to each other.
struct MatchedSide {
    int item = 0;
    Eigen::Vector2d first{0, 0}, last{0, 0};  ///< in the item's coordinates
    Eigen::Vector2d turnedFirst{0, 0}, turnedLast{0, 0};
};

struct MatchedPair {
    std::string name;
    MatchedSide left, right;
};

Eigen::Vector2d turnedPoint(const NestItem& item, const Eigen::Vector2d& point) {
    NestItem turned;
    turned.rings = {geometry::Polygon(point.transpose())};
    return placedRings(turned, {0, item.angles.front(), false, 0, 0}).front().row(0).transpose();
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

/// The two sides of a seam, of originals and of images.
std::vector<MatchedPair> pairsOf(const Pattern& pattern, const std::vector<LaidPiece>& laid,
                                 const std::vector<NestItem>& items, const std::string& name) {
    std::vector<MatchedPair> pairs;
    for (const bool isImage : {false, true}) {
        std::vector<MatchedSide> left, right;
        for (std::size_t i = 0; i < laid.size(); ++i) {
            const LaidPiece& piece = laid[i];
            for (const SeamLine& seam :
                 pattern.pieces[static_cast<std::size_t>(piece.piece)].seams) {
                if (seam.name == name && !laid[i].isKept && piece.isImage == isImage) {
                    (seam.isRight ? right : left)
                        .push_back(sideOf(pattern, piece, static_cast<int>(i), items[i], seam));
                }
            }
        }
        if (!left.empty() && !right.empty()) {
            pairs.push_back({name, left.front(), right.front()});
        }
    }
    return pairs;
}

/// How far apart two places are in the repeat, mm.
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
    // Where the origin of each item would lie in the repeat; of the first of each tree such that
    // its seam begins where a repeat does.
    std::vector<std::optional<Eigen::Vector2d>> places(items.size());
    std::vector<bool> isKept(pairs.size());
    for (std::size_t root = 0; root < pairs.size(); ++root) {
        const auto at = [&](int item) -> auto& {
            return places[static_cast<std::size_t>(item)];
        };
        if (at(pairs[root].left.item) || at(pairs[root].right.item)) {
            continue;
        }
        at(pairs[root].left.item) = repeat.origin - pairs[root].left.turnedFirst;
        for (bool isMore = true; isMore;) {
            isMore = false;
            for (std::size_t k = 0; k < pairs.size(); ++k) {
                const MatchedSide &left = pairs[k].left, &right = pairs[k].right;
                if (at(left.item).has_value() != at(right.item).has_value()) {
                    const MatchedSide& known = at(left.item) ? left : right;
                    const MatchedSide& other = at(left.item) ? right : left;
                    at(other.item) = *at(known.item) + known.turnedFirst - other.turnedFirst;
                    isMore = true;
                }
            }
        }
    }
    for (const MatchedPair& pair : pairs) {
        const auto apartAt = [&](const Eigen::Vector2d& left, const Eigen::Vector2d& right) {
            return apartIn(repeat, *places[static_cast<std::size_t>(pair.left.item)] + left -
                                       *places[static_cast<std::size_t>(pair.right.item)] - right);
        };
        const double first = apartAt(pair.left.turnedFirst, pair.right.turnedFirst);
        const double last = apartAt(pair.left.turnedLast, pair.right.turnedLast);
        if (first > kMatchedWithin) {
            notes.push_back(worded(kSeamNotMatched, {pair.name, figure(first, 1)}));
        } else if (last > kMatchedWithin) {
            notes.push_back(worded(kMatchedAtOneEnd, {pair.name, figure(last, 1)}));
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
