// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/place_pieces.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <utility>

#include <Eigen/Geometry>

#include "core/geometry/polygon.h"
#include "core/layout/arrange.h"
#include "core/layout/free_place.h"
#include "core/layout/marker.h"
#include "core/pattern/piece_allowance.h"
#include "core/pattern/piece_grain.h"

namespace toile {
namespace {

constexpr double kPartGapShare = 0.5;  // part of the gap between pieces, between parts of one piece
constexpr double kGrownAlike = 0.01;   // units differ by far more
constexpr double kStays = 1;           // mm: how far a cut part may move from its place
constexpr double kChanged = 0.1;       // mm: smaller changes do not count as another shape

Eigen::AlignedBox2d boxOf(const Points2& points) {
    return outlineBox(points, Placement{});
}

class Placing {
public:
    Placing(std::vector<PieceSettings> settings, const PieceResults& results,
            const Pattern* pattern, std::vector<double> clothWidths)
        : settings_(std::move(settings)),
          results_(results),
          pattern_(pattern),
          clothWidths_(std::move(clothWidths)) {}

    std::vector<PieceSettings> run(const std::vector<std::optional<FlatMotion>>& motions) {
        evictWhatIsOver();
        followUnit();
        const std::vector<std::vector<std::size_t>> cut = partsOfOne();
        std::vector<char> isPart(settings_.size(), 0), changed(settings_.size(), 0);
        for (const auto& parts : cut) {
            for (const std::size_t part : parts) {
                isPart[part] = 1;
            }
        }
        for (std::size_t i = 0; i < settings_.size(); ++i) {
            if (isFlat(i)) {
                changed[i] = fit(i, motions[i], isPart[i] != 0) || mayHaveGrown(i);
            }
        }
        makeRoom(cut, changed);
        placeNew();
        return std::move(settings_);
    }

private:
    bool isFlat(std::size_t i) const { return results_[i] && results_[i]->flat; }
    /// Whether the settings refer to exactly these flat points.
    bool isAboutThese(std::size_t i) const {
        return isFlat(i) && settings_[i].flat != 0 && settings_[i].flat == results_[i]->fingerprint;
    }
    void evictWhatIsOver() {
        for (std::size_t i = 0; i < settings_.size(); ++i) {
            if (isAboutThese(i)) {
                settings_[i].anchors.clear();
            }
        }
    }
    bool isPlaced(std::size_t i) const { return isFlat(i) && settings_[i].placement; }

    /// A wider allowance also changes the shape, and the earlier width is unknown.
    bool mayHaveGrown(std::size_t i) const {
        return pattern_ && pattern_->hasAllowance && !settings_[i].placedByHand;
    }

    Points2 outlineOf(std::size_t i) const {
        const Placement placement = settings_[i].placement.value_or(Placement{});
        if (pattern_ && pattern_->pieces[i].cuttingLine.rows() > 0) {
            const Points2& line = pattern_->pieces[i].cuttingLine;
            return (line * placement.linear().transpose()).rowwise() + placement.offset.transpose();
        }
        return placedOutline(results_[i]->flat->Q, results_[i]->piece->boundary, placement);
    }

    double gap() const {
        double largest = 0;
        for (std::size_t i = 0; i < settings_.size(); ++i) {
            if (isFlat(i)) {
                largest = std::max(largest, boxOf(outlineOf(i)).sizes().maxCoeff());
            }
        }
        return gapBetweenPieces(largest);  // as in the first layout
    }

    /// If all pieces have grown alike, the garment was read in another unit, and the sheet grows
    /// with them.
    void followUnit() {
        std::optional<double> least, most;
        for (std::size_t i = 0; i < settings_.size(); ++i) {
            if (!isFlat(i)) {
                continue;
            }
            const auto growth = anchorGrowth(settings_[i].anchors, results_[i]->flat->Q);
            if (!growth) {
                return;
            }
            least = std::min(least.value_or(*growth), *growth);
            most = std::max(most.value_or(*growth), *growth);
        }
        const bool alike = least && *most - *least <= kGrownAlike * *most;
        if (!alike || std::abs(*most - 1) <= kAnchorDoubt) {
            return;
        }
        for (PieceSettings& settings : settings_) {
            settings = scaledSettings(std::move(settings), *most);
        }
    }

    /// The parts of each cut piece that are flat for the first time since the cut.
    std::vector<std::vector<std::size_t>> partsOfOne() const {
        std::map<PieceId, std::vector<std::size_t>> byUncut;
        for (std::size_t i = 0; i < settings_.size(); ++i) {
            if (isPlaced(i) && settings_[i].partOf && !settings_[i].anchors.empty()) {
                byUncut[settings_[i].partOf].push_back(i);
            }
        }
        std::vector<std::vector<std::size_t>> cut;
        for (auto& [whole, parts] : byUncut) {
            if (parts.size() > 1) {
                cut.push_back(std::move(parts));
            }
        }
        std::ranges::sort(cut);
        return cut;
    }

    /// Puts the piece back in its place. @return whether its shape has changed
    bool fit(std::size_t i, const std::optional<FlatMotion>& motion, bool isPart) {
        PieceSettings& settings = settings_[i];
        settings.partOf = {};
        if (isAboutThese(i)) {
            return false;
        }
        const std::uint64_t before = std::exchange(settings.flat, results_[i]->fingerprint);
        if (!settings.anchors.empty()) {
            const Points2& Q = results_[i]->flat->Q;
            const auto residual = anchorResidual(settings.anchors, Q);
            settings = isPart ? anchoredSettings(std::move(settings), Q, kStays)
                              : anchoredSettings(std::move(settings), Q);
            return !residual || *residual > kChanged;
        }
        if (motion && (before == 0 || before == motion->before)) {
            settings = uprightSettings(std::move(settings), motion->oldOfNew, motion->radius);
            return motion->residual > kChanged;
        }
        return false;
    }

    void makeRoom(const std::vector<std::vector<std::size_t>>& cut,
                  const std::vector<char>& changed) {
        if (cut.empty() && std::ranges::find(changed, 1) == changed.end()) {
            return;
        }
        outlines_.assign(settings_.size(), Points2(0, 2));
        std::vector<char> stays(settings_.size(), 0);
        for (std::size_t i = 0; i < settings_.size(); ++i) {
            stays[i] = settings_[i].placedByHand ? 1 : 0;
            if (isPlaced(i)) {
                outlines_[i] = outlineOf(i);
            }
        }
        const double between = kPartGapShare * gap();
        for (const auto& parts : cut) {
            stays[takeApart(parts, between)] = 1;
        }
        pushNeighbours(changed, stays, between);
    }

    /// @return the part that stays
    std::size_t takeApart(std::vector<std::size_t> parts, double between) {
        std::ranges::stable_sort(parts, std::greater<>(), [this](std::size_t part) {
            return std::abs(geometry::signedAreaOf(outlines_[part]));
        });
        std::vector<Points2> later;  // parts not placed yet obstruct no other part
        later.reserve(parts.size());
        for (const std::size_t part : parts) {
            later.push_back(std::exchange(outlines_[part], Points2(0, 2)));
        }
        outlines_[parts.front()] = later.front();
        for (std::size_t k = 1; k < parts.size(); ++k) {
            outlines_[parts[k]] = later[k];
            if (liesOnAnother(parts[k])) {
                moveAway(parts[k], between);
            }
        }
        return parts.front();
    }

    void pushNeighbours(const std::vector<char>& changed, const std::vector<char>& stays,
                        double between) {
        for (const auto& [a, b] : overlappingOutlines(outlines_)) {
            const auto one = static_cast<std::size_t>(a), other = static_cast<std::size_t>(b);
            const bool stillLie = !overlappingOutlines({outlines_[one], outlines_[other]}).empty();
            if (!stillLie || (!changed[one] && !changed[other]) || (stays[one] && stays[other])) {
                continue;
            }
            // Move the unchanged one; if both or none changed, the smaller one.
            bool first = std::abs(geometry::signedAreaOf(outlines_[one])) <
                         std::abs(geometry::signedAreaOf(outlines_[other]));
            if (changed[one] != changed[other]) {
                first = !changed[one];
            }
            if (stays[one] != stays[other]) {
                first = !stays[one];
            }
            moveAway(first ? one : other, between);
        }
    }

    bool liesOnAnother(std::size_t i) const {
        return std::ranges::any_of(outlines_, [&](const Points2& other) {
            return &other != &outlines_[i] && !overlappingOutlines({outlines_[i], other}).empty();
        });
    }

    void moveAway(std::size_t i, double between) {
        std::vector<Points2> others = outlines_;
        others[i].resize(0, 2);
        const Eigen::Vector2d move = moveToFreePlace(outlines_[i], others, between);
        settings_[i].placement->offset += move;
        outlines_[i].rowwise() += move.transpose();
    }

    /// For the first layout, when no piece has a place: all in rows.
    void placeInRows() {
        std::vector<Eigen::AlignedBox2d> boxes(settings_.size());
        for (std::size_t i = 0; i < settings_.size(); ++i) {
            if (isFlat(i)) {
                boxes[i] = boxOf(outlineOf(i));
            }
        }
        const Rows rows = layOutInRows(boxes, clothWidths_);
        for (std::size_t i = 0; i < settings_.size(); ++i) {
            if (isFlat(i)) {
                settings_[i].placement = Placement{rows.offset[i]};
            }
        }
    }

    void placeNew() {
        Eigen::AlignedBox2d taken;
        for (std::size_t i = 0; i < settings_.size(); ++i) {
            if (isPlaced(i)) {
                taken.extend(boxOf(outlineOf(i)));
            }
        }
        if (taken.isEmpty()) {
            placeInRows();
            return;
        }
        const double between = gap();
        // Downwards in a column to the right of all pieces, then in the next column.
        Eigen::Vector2d corner(taken.max().x() + between, taken.max().y());
        double columnRight = corner.x();
        for (std::size_t i = 0; i < settings_.size(); ++i) {
            if (!isFlat(i) || settings_[i].placement) {
                continue;
            }
            const Eigen::AlignedBox2d box = boxOf(outlineOf(i));
            const bool atTop = corner.y() == taken.max().y();
            if (!atTop && corner.y() - box.sizes().y() < taken.min().y()) {
                corner = {columnRight + between, taken.max().y()};
            }
            const Eigen::Vector2d upperLeft(box.min().x(), box.max().y());
            settings_[i].placement = Placement{corner - upperLeft};
            columnRight = std::max(columnRight, corner.x() + box.sizes().x());
            corner.y() -= box.sizes().y() + between;
        }
    }

    std::vector<PieceSettings> settings_;
    const PieceResults& results_;
    const Pattern* pattern_;
    std::vector<double> clothWidths_;  ///< one per piece
    std::vector<Points2> outlines_;    ///< of placed pieces; empty for others
};

}  // namespace

std::vector<std::optional<FlatMotion>> flatMotions(const PieceResults& before,
                                                   const PieceResults& after) {
    std::vector<std::optional<FlatMotion>> motions(after.size());
    for (std::size_t i = 0; i < after.size() && i < before.size(); ++i) {
        const PieceResult *old = before[i].get(), *now = after[i].get();
        if (old && now && old != now && old->piece == now->piece && old->flat && now->flat) {
            const RigidMotion motion = bestMotion(now->flat->Q, old->flat->Q);
            motions[i] =
                FlatMotion{motion, old->fingerprint, now->flat->Q.rowwise().norm().maxCoeff(),
                           residual(motion, now->flat->Q, old->flat->Q)};
        }
    }
    return motions;
}

std::vector<PieceSettings> placedSettings(std::vector<PieceSettings> settings,
                                          const PieceResults& results,
                                          const std::vector<std::optional<FlatMotion>>& motions,
                                          const Pattern* pattern, const MaterialList& materials,
                                          const Fabric& own) {
    std::vector<double> clothWidths;
    clothWidths.reserve(settings.size());
    for (const PieceSettings& piece : settings) {
        clothWidths.push_back(fabricOf(piece.material, materials, own).width);
    }
    return Placing(std::move(settings), results, pattern, std::move(clothWidths)).run(motions);
}

void setGrains(std::vector<PieceSettings>& settings, const Garment& garment,
               const PieceResults& results, const Symmetry* symmetry, GrainRule rule,
               const MaterialList& materials, const Fabric& own) {
    if (std::ranges::all_of(settings,
                            [](const PieceSettings& of) { return of.grain.has_value(); })) {
        return;
    }
    std::vector<Fabric> fabrics;
    fabrics.reserve(settings.size());
    for (const PieceSettings& piece : settings) {
        fabrics.push_back(fabricOf(piece.material, materials, own));
    }
    const auto grains = findGrains(garment, results, symmetry, rule, fabrics);
    for (std::size_t p = 0; p < grains.size(); ++p) {
        std::optional<double>& grain = settings[p].grain;
        grain = grain ? grain : grains[p];
    }
}

LaidOutPattern cutAndPlace(Pattern pattern, const std::vector<PieceSettings>& settings,
                           MaterialList materials, const Fabric& own) {
    std::vector<std::optional<Placement>> placements;
    for (std::size_t i = 0; i < settings.size(); ++i) {
        setCutting(pattern.pieces[i], settings[i]);
        placements.push_back(settings[i].placement);
    }
    pattern.materials = std::move(materials);
    return cutAndPlace(std::move(pattern), placements, own);
}

}  // namespace toile
