// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <tuple>

#include "core/seam/finish_seam.h"

namespace toile {
namespace {

// Places are compared in steps of this part of the garment, so that rounding does not decide.
constexpr double kSameCentre = 1e-6;

using Key = std::tuple<bool, int, int, SeamKind, std::array<double, 3>, double>;

Key keyOf(const Outlines& outlines, const Seam& seam) {
    const Outline& outline = outlines.list[outlines.indexOf(seam.left)];
    const Eigen::Vector3d middle = outline.pointAt(0.5 * (seam.left.start + seam.left.end));
    std::array<double, 3> place{};
    for (int k = 0; k < 3; ++k) {
        place[k] = std::round(middle[k] / (kSameCentre * outlines.size));
    }
    return {seam.kind == SeamKind::Free,
            seam.left.piece,
            seam.right.piece,
            seam.kind,
            place,
            seam.left.start};
}

/// The name without its number, and the noun that a number needs before it.
std::pair<std::string, std::string> baseName(
    const std::vector<std::shared_ptr<const Piece>>& pieces, const Seam& seam) {
    const std::string& left = pieces[seam.left.piece]->name;
    switch (seam.kind) {
        case SeamKind::Dart:
            return {left + ", dart", ""};
        case SeamKind::Fold:
            return {left + ", pleat", ""};
        case SeamKind::Free:
            return {left + ", free edge", ""};
        case SeamKind::Seam:
            break;
    }
    const bool itself = seam.left.piece == seam.right.piece;
    return {left + " / " + (itself ? "itself" : pieces[seam.right.piece]->name), ", seam"};
}

}  // namespace

void orderAndName(const std::vector<std::shared_ptr<const Piece>>& pieces, const Outlines& outlines,
                  std::vector<Seam>& seams) {
    std::vector<std::pair<Key, std::size_t>> order;
    std::map<std::string, int> count, used;
    for (std::size_t k = 0; k < seams.size(); ++k) {
        order.emplace_back(keyOf(outlines, seams[k]), k);
        ++count[baseName(pieces, seams[k]).first];
    }
    std::sort(order.begin(), order.end());
    std::vector<Seam> sorted;
    for (const auto& entry : order) {
        Seam& seam = sorted.emplace_back(std::move(seams[entry.second]));
        const auto [base, noun] = baseName(pieces, seam);
        seam.name = count[base] > 1 ? base + noun + " " + std::to_string(++used[base]) : base;
    }
    seams = std::move(sorted);
}

}  // namespace toile
