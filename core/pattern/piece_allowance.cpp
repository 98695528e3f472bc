// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/pattern/piece_allowance.h"

#include <algorithm>
#include <utility>

#include "core/pattern/darts.h"
#include "core/pattern/extension.h"

namespace toile {
namespace {

bool isHem(const PatternSegment& segment) {
    return segment.seam > 0 && segment.kind == SeamKind::Free && !segment.isFaced;
}

}  // namespace

double usualAllowance(const PatternSegment& segment, const AllowanceWidths& widths) {
    switch (segment.kind) {
        case SeamKind::Fold:
        case SeamKind::Dart:
            return 0;
        case SeamKind::Free:  // too short to be a free edge, or faced: treat as a seam
            return isHem(segment) ? widths.hem : widths.seam;
        case SeamKind::Seam:
            break;
    }
    return widths.seam;
}

CornerRule cornerOf(const PatternPiece& piece, std::size_t k) {
    const PatternSegment& segment = piece.segments[k];
    const std::size_t count = piece.segments.size();
    std::size_t before = (k + count - 1) % count;
    while (before != k && piece.segments[before].kind == SeamKind::Dart) {
        before = (before + count - 1) % count;  // the line continues over the closed dart
    }
    const bool afterHem = isHem(piece.segments[before]);
    if (segment.corner || afterHem == isHem(segment)) {
        return segment.corner.value_or(CornerRule::Mitre);
    }
    return afterHem ? CornerRule::MirrorFirst : CornerRule::MirrorSecond;
}

AllowanceBase allowanceBase(const PatternPiece& piece, CappedOutline outline) {
    AllowanceBase base{std::move(outline.line), {}};
    base.stretches.reserve(outline.stretches.size());
    for (const CappedStretch& stretch : outline.stretches) {
        const auto k = static_cast<std::size_t>(stretch.segment);
        base.stretches.push_back(
            stretch.segment < 0
                ? AllowanceStretch{stretch.first, 0, CornerRule::Mitre}
                : AllowanceStretch{stretch.first, piece.segments[k].allowance, cornerOf(piece, k)});
    }
    return base;
}

void addCuttingLine(PatternPiece& piece) {
    CappedOutline outline = extendedOutline(piece, cappedOutline(piece, findDarts(piece)));
    piece.extensions = extensionEdges(piece, outline);
    AllowanceBase base = allowanceBase(piece, std::move(outline));
    const bool isNone = std::ranges::all_of(
        base.stretches, [](const AllowanceStretch& stretch) { return stretch.width == 0; });
    piece.cuttingLine = isNone ? std::move(base.line) : cuttingLine(base.line, base.stretches);
}

int segmentAt(const PatternPiece& piece, double length, double at) {
    const auto contains = [&](double slack) {
        return std::ranges::find_if(piece.segments, [&](const PatternSegment& segment) {
            // A segment may pass the outline's first point: also test a turn later.
            return (at >= segment.from - slack && at < segment.to + slack) ||
                   (at + length >= segment.from - slack && at + length < segment.to + slack);
        });
    };
    constexpr double kRounding = 1e-6;  // mm: between a segment's end and the next one's start
    auto found = contains(0);
    found = found != piece.segments.end() ? found : contains(kRounding);
    if (found == piece.segments.end()) {
        return -1;
    }
    const auto k = static_cast<int>(found - piece.segments.begin());
    return found->isFold && k > 0 ? k - 1 : k;  // a half ends with the segment before the fold
}

double allowanceAt(const PatternPiece& piece, double length, double at) {
    const int segment = segmentAt(piece, length, at);
    return segment < 0 ? 0 : piece.segments[segment].allowance;
}

}  // namespace toile
