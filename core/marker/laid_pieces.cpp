// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/marker/laid_pieces.h"

#include <algorithm>
#include <cmath>

#include "core/base/units.h"
#include "core/nest/shape.h"
#include "core/pattern/half_pattern.h"

namespace toile {
namespace {

constexpr const char* kFromBothLayers = translatable(
    "%1 is cut through both layers of the folded cloth, which gives %2 more than needed");

}  // namespace
}  // namespace toile

namespace toile::cloth {
namespace {

using geometry::Polygon;

/// Salts that keep the ids made here distinct from others.
constexpr std::uint64_t kFacingOnCloth = 0x6661636573, kNamelessOnCloth = 0x6e6f6e616d65;

void addNumbers(LaidPiece& laid, int first, int step, int count) {
    for (int k = 0; k < count; ++k) {
        laid.numbers.push_back(first + step * k);
    }
}

}  // namespace

PieceId idOnCloth(const Pattern& pattern, int piece) {
    const PieceId id = pattern.pieces[static_cast<std::size_t>(piece)].id;
    const auto index = static_cast<std::uint64_t>(piece);
    if (id) {
        return id;
    }
    const std::size_t pieces =
        pattern.pieces.size() - std::min(pattern.pieces.size(), pattern.facings.size());
    if (index < pieces) {
        return {hashOf({kNamelessOnCloth, index})};
    }
    const FacingPiece& facing = pattern.facings[index - pieces];
    const auto of = static_cast<std::size_t>(facing.piece);
    std::uint64_t before = 0;  // earlier copies of the same facing on the same piece
    for (std::size_t k = 0; k < index - pieces; ++k) {
        before +=
            pattern.facings[k].piece == facing.piece && pattern.facings[k].facing == facing.facing
                ? 1
                : 0;
    }
    return {hashOf({kFacingOnCloth, pattern.pieces[of].id.value,
                    static_cast<std::uint64_t>(facing.facing), before})};
}

std::string materialOnCloth(const Pattern& pattern, const PatternPiece& piece) {
    return findMaterial(piece.material, pattern.materials) ? piece.material : std::string();
}

std::vector<LaidPiece> laidPieces(const Pattern& pattern, const std::string& material,
                                  const MarkerSettings& settings, std::vector<Wording>& notes) {
    std::vector<LaidPiece> all;
    for (std::size_t p = 0; p < pattern.pieces.size(); ++p) {
        const PatternPiece& piece = pattern.pieces[p];
        const int count = std::max(piece.quantity, 0) * std::max(settings.garments, 0);
        if (piece.outline.rows() < 3 || count == 0 || materialOnCloth(pattern, piece) != material) {
            continue;
        }
        const bool isPair =
            piece.cutAs == CutAs::Pair || (piece.mirroredPair && piece.cutAs == CutAs::Whole);
        LaidPiece laid;
        laid.piece = static_cast<int>(p);
        if (piece.cutAs == CutAs::OnFold) {
            addNumbers(laid, 0, 1, piece.mirroredPair ? 2 * count : count);
        } else if (!settings.isFolded) {
            addNumbers(laid, 0, isPair ? 2 : 1, count);
        } else if (isPair || piece.mirror.isSymmetric) {
            laid.yield = 2;
            addNumbers(laid, 0, 2, isPair ? count : (count + 1) / 2);
        } else {
            addNumbers(laid, 0, 1, count);
        }
        const int spare = !settings.isFolded || isPair || piece.cutAs == CutAs::OnFold ? 0
                          : piece.mirror.isSymmetric                                   ? count % 2
                                                                                       : count;
        if (spare > 0) {
            notes.push_back(worded(kFromBothLayers, {piece.name, figure(spare)}));
        }
        all.push_back(laid);
        if (isPair && !settings.isFolded) {
            LaidPiece image;
            image.piece = laid.piece;
            image.isImage = true;
            addNumbers(image, 1, 2, count);
            all.push_back(std::move(image));
        }
    }
    return all;
}

Points2 NestForm::of(const Points2& line) const {
    NestItem item;
    item.rings = {line};
    Points2 formed = placedRings(item, {0, turn, false, 0, 0}).front();
    formed.col(0) *= flip ? -1 : 1;
    return formed;
}

Eigen::Vector2d NestForm::of(const Eigen::Vector2d& point) const {
    return of(Points2(point.transpose())).row(0).transpose();
}

NestPlacement NestForm::nestPlacement(const Placement& placement) const {
    return {0, placement.mirrored ? placement.turn + turn : placement.turn - turn,
            placement.mirrored != flip, placement.offset.x(), placement.offset.y()};
}

Placement NestForm::placement(const NestPlacement& placed) const {
    const bool isMirrored = placed.mirrored != flip;
    return {
        {placed.x, placed.y}, isMirrored ? placed.angle - turn : placed.angle + turn, isMirrored};
}

NestForm nestFormOf(const PatternPiece& piece, bool isImage) {
    NestForm form;
    form.flip = isImage;
    if (piece.cutAs == CutAs::OnFold) {
        const Chord fold = foldOf(piece);
        form.turn = -directionTo(fold.from, fold.to);
        form.flip = std::cos(grainOf(piece) + form.turn) < 0;  // so that the warp runs along x
    }
    return form;
}

NestItem itemOf(const PatternPiece& piece, bool isImage, const MarkerSettings& settings) {
    NestItem item;
    item.name = piece.name;
    item.rings = {nestFormOf(piece, isImage).of(edgeOf(piece))};
    if (piece.cutAs == CutAs::OnFold) {
        item.touchesEdge = true;
        item.mayMirror = settings.turns != TurnRule::OneWay;
        return item;
    }
    const double grain = grainOf(piece);
    const double up = wrappedAngle(isImage ? grain - kPi : -grain);
    item.angles = {up};
    if (settings.turns == TurnRule::HalfTurns) {
        item.angles.push_back(up + kPi);
    }
    item.tolerance = settings.turns == TurnRule::Free ? kPi : settings.tolerance;
    return item;
}

Eigen::Vector2d leastSides(const NestItem& item) {
    const std::vector<Eigen::Vector2d> hull = nest::hullOf(item.rings.front(), 0);
    NestItem around;
    around.rings = {Polygon(static_cast<Eigen::Index>(hull.size()), 2)};
    for (std::size_t k = 0; k < hull.size(); ++k) {
        around.rings.front().row(static_cast<Eigen::Index>(k)) = hull[k].transpose();
    }
    const int steps = item.tolerance > 0 ? 180 : 0;
    Eigen::Vector2d least(HUGE_VAL, HUGE_VAL);
    for (const double angle : item.angles) {
        for (int k = -steps; k <= steps; ++k) {
            const double aside = steps > 0 ? std::min(item.tolerance, kPi) * k / steps : 0;
            const Polygon line = placedRings(around, {0, angle + aside, false, 0, 0}).front();
            const Eigen::RowVector2d sides = line.colwise().maxCoeff() - line.colwise().minCoeff();
            least = least.cwiseMin(sides.transpose());
        }
    }
    return least;
}

double roomAcross(const NestItem& item, double width, const MarkerSettings& settings) {
    return width - (item.touchesEdge ? 1 : 2) * settings.border -
           (settings.gap > 0 ? kGapRounding : 0);
}

double roomAlong(const MarkerSettings& settings) {
    return settings.sheet
               ? settings.sheet->x() - 2 * settings.border - (settings.gap > 0 ? kGapRounding : 0)
               : HUGE_VAL;
}

geometry::Polygon lineOf(const PatternPiece& piece, bool isImage, const Placement& placement) {
    const NestForm form = nestFormOf(piece, isImage);
    NestItem item;
    item.rings = {form.of(edgeOf(piece))};
    return placedRings(item, form.nestPlacement(placement)).front();
}

}  // namespace toile::cloth
