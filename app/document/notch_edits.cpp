// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/notch_edits.h"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "core/pattern/notches.h"
#include "core/symmetry/symmetry.h"

namespace toile::app {

namespace {

/// Places on a line, and shares of a seam, that are closer than this count as one.
constexpr double kSamePart = 1e-6;

bool isFirst(const SeamNotch& one, const SeamNotch& other) {
    return std::tie(one.seam, one.share) < std::tie(other.seam, other.share);
}

bool areOne(const SeamNotch& one, const SeamNotch& other) {
    return one.seam == other.seam && std::abs(one.share - other.share) < kSamePart;
}

/// The setting that put a notch exactly there; -1: none.
int indexOf(const NotchRules& rules, const Garment& garment, const NotchAt& at) {
    const auto place = notchSettingsAt(garment, at.seam, at.share);
    const auto found = std::ranges::find_if(rules.notches, [&](const NotchSettings& said) {
        return place && said.isThere && said.line == place->line &&
               said.reversed == place->reversed && std::abs(said.at - place->at) < kSamePart;
    });
    return found == rules.notches.end() ? -1 : static_cast<int>(found - rules.notches.begin());
}

/// The same for the mirrored place; also -1 if it is ambiguous which end of the other seam mirrors
/// the start of this one.
int mirroredIndexOf(const NotchRules& rules, const Garment& garment, const NotchAt& at,
                    const Symmetry* symmetry) {
    const auto seam = static_cast<std::size_t>(at.seam);
    if (!symmetry || seam >= symmetry->lengths.mirrored.size() ||
        symmetry->lengths.mirrored[seam] < 0) {
        return -1;
    }
    const int other = symmetry->lengths.mirrored[seam];
    const int alike = indexOf(rules, garment, {other, at.share});
    const int turned = indexOf(rules, garment, {other, 1 - at.share});
    return alike < 0 || turned < 0 || alike == turned ? std::max(alike, turned) : -1;
}

}  // namespace

std::vector<SeamNotch> notchesOf(const Pattern& pattern) {
    std::vector<SeamNotch> notches;
    for (const PatternPiece& piece : pattern.pieces) {
        for (const PieceNotch& notch : piece.notches) {
            SeamNotch& one = notches.emplace_back();
            one.seam = notch.seam - 1;
            one.share = notch.share;
            one.reason = notch.reason;
        }
    }
    std::ranges::sort(notches, isFirst);
    notches.erase(std::unique(notches.begin(), notches.end(), areOne), notches.end());
    return notches;
}

LineSettings withNotch(LineSettings lines, const Garment& garment, const NotchAt& at) {
    if (const auto said = notchSettingsAt(garment, at.seam, at.share)) {
        lines.notches = lines.notches.value_or(NotchRules{});
        lines.notches->notches.push_back(*said);
    }
    return lines;
}

LineSettings withoutNotch(LineSettings lines, const Garment& garment, const SeamNotch& notch,
                          const Symmetry* symmetry) {
    if (!lines.notches) {
        return lines;
    }
    if (notch.reason == NotchReason::ByHand) {
        int index = indexOf(*lines.notches, garment, notch);
        index = index < 0 ? mirroredIndexOf(*lines.notches, garment, notch, symmetry) : index;
        if (index >= 0) {
            lines.notches->notches.erase(lines.notches->notches.begin() + index);
            return lines;
        }
    }
    if (auto said = notchSettingsAt(garment, notch.seam, notch.share)) {
        said->isThere = false;
        lines.notches->notches.push_back(*said);
    }
    return lines;
}

LineSettings withNotchMoved(LineSettings lines, const Garment& garment, const SeamNotch& notch,
                            double share, const Symmetry* symmetry) {
    return withNotch(withoutNotch(std::move(lines), garment, notch, symmetry), garment,
                     {notch.seam, share});
}

}  // namespace toile::app
