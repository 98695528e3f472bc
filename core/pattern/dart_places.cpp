// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/pattern/dart_places.h"

#include <algorithm>
#include <cmath>

#include "core/pattern/outline_reference.h"
#include "core/seam/seam_settings.h"

namespace toile {
namespace {

constexpr double kOneTip = 0.01;  // mm: between the end of one side and the start of the other
constexpr double kInDart = 1e-6;  // mm

double inFirstTurn(double at, double perimeter) {
    return at - perimeter * std::floor(at / perimeter);
}

}  // namespace

std::optional<DartPlace> dartPlace(const Garment& garment, int seam) {
    const Seam& dart = garment.seams.seams[static_cast<std::size_t>(seam)];
    if (dart.kind != SeamKind::Dart || dart.left.piece < 0 || dart.left.piece != dart.right.piece ||
        dart.left.loop != 0 || dart.right.loop != 0) {
        return std::nullopt;
    }
    const Piece& piece = *garment.pieces[static_cast<std::size_t>(dart.left.piece)];
    const double perimeter = outlineArc(piece).back();
    const auto place = [&](const SeamSide& first,
                           const SeamSide& second) -> std::optional<DartPlace> {
        const double tip = std::max(first.start, first.end);
        const double next = std::min(second.start, second.end);
        if (!(std::abs(std::remainder(tip - next, perimeter)) < kOneTip) ||
            !(first.length() > kOneTip) || !(second.length() > kOneTip) ||
            !(perimeter - first.length() - second.length() > kOneTip)) {
            return std::nullopt;
        }
        const double from = inFirstTurn(tip - first.length(), perimeter);
        return DartPlace{dart.left.piece, from, from + first.length(),
                         from + first.length() + second.length()};
    };
    const auto found = place(dart.left, dart.right);
    return found ? found : place(dart.right, dart.left);
}

double intakeOf(const DartPlace& dart, double angle) {
    const double a = dart.firstLeg(), b = dart.secondLeg(), half = std::sin(angle / 2);
    return std::sqrt((a - b) * (a - b) + 4 * a * b * half * half);
}

double angleOf(const DartPlace& dart, double intake) {
    const double a = dart.firstLeg(), b = dart.secondLeg();
    const double square = (intake - (a - b)) * (intake + (a - b)) / (4 * a * b);
    return 2 * std::asin(std::sqrt(std::clamp(square, 0.0, 1.0)));
}

std::map<int, DartSettings> saidOfDarts(const SeamGraph& graph, const LineSettings& settings) {
    std::map<int, DartSettings> said;
    for (const DartSettings& one : settings.darts) {
        const int seam = seamAt(graph, one.seam);
        if (seam >= 0 && graph.seams[static_cast<std::size_t>(seam)].kind == SeamKind::Dart) {
            said[seam] = one;
        }
    }
    return said;
}

std::vector<std::vector<TypedDart>> typedDarts(const Garment& garment,
                                               const LineSettings& settings) {
    std::vector<std::vector<TypedDart>> typed(garment.pieces.size());
    for (const auto& [seam, said] : saidOfDarts(garment.seams, settings)) {
        const auto place = said.intake ? dartPlace(garment, seam) : std::nullopt;
        if (place) {
            typed[static_cast<std::size_t>(place->piece)].push_back({*place, *said.intake});
        }
    }
    for (std::size_t p = 0; p < typed.size(); ++p) {
        std::ranges::sort(typed[p], {}, &TypedDart::from);
        std::vector<TypedDart> kept;
        for (const TypedDart& dart : typed[p]) {
            const double perimeter = outlineArc(*garment.pieces[p]).back();
            const bool isApart = std::ranges::none_of(kept, [&](const TypedDart& other) {
                return isWithin(other, perimeter, dart.tip) || isWithin(dart, perimeter, other.tip);
            });
            if (isApart) {
                kept.push_back(dart);
            }
        }
        typed[p] = std::move(kept);
    }
    return typed;
}

bool isWithin(const DartPlace& dart, double perimeter, double at) {
    const double past = inFirstTurn(at - dart.from, perimeter);
    return past > kInDart && past < dart.to - dart.from - kInDart;
}

}  // namespace toile
