// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/allowance_edits.h"

#include <algorithm>
#include <utility>

#include "app/document/line_edits.h"
#include "app/document/strip_edits.h"
#include "core/pattern/pattern.h"
#include "core/pattern/piece_allowance.h"

namespace toile::app {

namespace {

void addOnce(std::vector<SegmentAt>& segments, const std::optional<SegmentAt>& one) {
    if (one && std::ranges::find(segments, *one) == segments.end()) {
        segments.push_back(*one);
    }
}

LineSettings withAllowances(LineSettings lines) {
    lines.allowance = lines.allowance.value_or(AllowanceWidths{});
    return lines;
}

/// The same corner where the outline runs the other way.
CornerRule turnedRule(CornerRule rule) {
    switch (rule) {
        case CornerRule::RightAngleFirst:
            return CornerRule::RightAngleSecond;
        case CornerRule::RightAngleSecond:
            return CornerRule::RightAngleFirst;
        case CornerRule::MirrorFirst:
            return CornerRule::MirrorSecond;
        case CornerRule::MirrorSecond:
            return CornerRule::MirrorFirst;
        default:
            return rule;
    }
}

LineSettings statedOf(LineSettings lines, const Segment& segment, std::optional<CornerRule> rule) {
    SegmentSettings said = segment.settings;
    said.corner = rule;
    return withSegment(std::move(lines), said);
}

}  // namespace

std::vector<SegmentAt> alikeSegments(const Garment& garment, const LineFacts& facts,
                                     const SegmentAt& one, bool bothSides,
                                     const Symmetry* symmetry) {
    std::vector<SegmentAt> alike{one};
    if (bothSides) {
        addOnce(alike, partnerOf(garment, facts, one));
    }
    if (symmetry) {
        const std::vector<SegmentAt> asked = alike;
        for (const SegmentAt& there : asked) {
            addOnce(alike, mirrorOf(garment, facts, *symmetry, there));
        }
    }
    return alike;
}

double allowanceOf(const Garment& garment, const Segment& segment, const LineSettings& lines) {
    PatternSegment kind;
    kind.seam = segment.seam + 1;
    if (segment.seam >= 0) {
        kind.kind = garment.seams.seams[static_cast<std::size_t>(segment.seam)].kind;
    }
    kind.isFaced = facingOf(lines, segment).has_value();
    return segment.settings.allowance.value_or(
        usualAllowance(kind, lines.allowance.value_or(AllowanceWidths{})));
}

LineSettings withAllowance(LineSettings lines, const LineFacts& facts,
                           const std::vector<SegmentAt>& segments, std::optional<double> width) {
    for (const SegmentAt& at : segments) {
        SegmentSettings said = facts.at(at).settings;
        if (said.place.line) {
            said.allowance = width;
            lines = withSegment(std::move(lines), said);
        }
    }
    return width ? withAllowances(std::move(lines)) : lines;
}

LineSettings withCorner(LineSettings lines, const LineFacts& facts, const SegmentAt& one,
                        const std::optional<SegmentAt>& image, std::optional<CornerRule> rule) {
    lines = statedOf(std::move(lines), facts.at(one), rule);
    if (image) {
        const auto& there = facts.segments[static_cast<std::size_t>(image->piece)].segments;
        const std::size_t next = (static_cast<std::size_t>(image->segment) + 1) % there.size();
        const SegmentAt after{image->piece, static_cast<int>(next)};
        if (!(after == one) && there[next].place.line) {
            lines = statedOf(std::move(lines), there[next],
                             rule ? std::optional(turnedRule(*rule)) : std::nullopt);
        }
    }
    return rule ? withAllowances(std::move(lines)) : lines;
}

}  // namespace toile::app
